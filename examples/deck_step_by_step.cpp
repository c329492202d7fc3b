// A whole deck, stepped from C++, with a look at every state.
// usage: deck_step_by_step DECK.k [NAME=VALUE ...]
#include <corpuscle/base/error.hpp>
#include <corpuscle/io/deck.hpp>
#include <corpuscle/solver/simulation.hpp>

#include <cstdio>

using namespace corpuscle;

int main(int argc, char** argv) try {
    if (argc < 2) return std::fprintf(stderr, "usage: %s DECK.k [NAME=VALUE ...]\n", argv[0]), 2;
    io::DeckOptions options;
    for (int i = 2; i < argc; ++i) {
        const std::string given = argv[i];
        const std::size_t at = given.find('=');
        if (at == std::string::npos) throw InputError(given + ": expected NAME=VALUE");
        options.overrides.push_back({given.substr(0, at), given.substr(at + 1)});
    }
    Model model = io::read_deck(argv[1], options);
    for (const std::string& warning : model.warnings) std::fprintf(stderr, "%s\n", warning.c_str());

    Simulation simulation(std::move(model), /*seed=*/1);
    double next = 0.0, greatest = 0.0;
    const auto look = [&](Simulation& now) {  // positions, forces and books are those of t
        for (const gas::BagGas& bag : now.bags()) {
            const gas::GasState gas = bag.state(now.nodes().x);
            greatest = std::max(greatest, gas.pressure);
            if (now.time() < next) continue;
            std::printf("t %.4g  volume %.5g  pressure %.5g  temperature %.4g  particles %zu\n",
                        now.time(), gas.volume, gas.pressure, gas.temperature, now.particles());
        }
        if (now.time() >= next) next += now.model().end_time / 10.0;
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
    std::printf("%lld steps, greatest pressure %.5g, energy residual %.2g\n",
                static_cast<long long>(simulation.steps()), greatest, simulation.books().residual);
} catch (const InputError& error) {
    for (const std::string& fault : error.faults) std::fprintf(stderr, "%s\n", fault.c_str());
    return 2;
} catch (const PhysicsError& error) {
    std::fprintf(stderr, "the physics broke %s\n", error.what());
    return 3;
}
