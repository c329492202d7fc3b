// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: whatever number of the state is none any more, a run does not end with status 0 and a
// number in its results that is not finite: NaN and infinity are put into checkpoints, in place of
// one number of the state at a time, and the program goes on from there.
//
//   CORPUSCLE_SPOILED=2000 verify_finite "many*"     so many of the numbers

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>

#include "io/deck.hpp"
#include "io/results/checkpoint.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/constants.hpp"
#include "solver/simulation.hpp"
#include "tests/places.hpp"
#include "tests/support/decks/busy_cube.hpp"
#include "tests/support/runs/datasets.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

constexpr double SPOILED_AT = 0.32e-3, ENDS_AT = 0.3e-3;  ///< [s]

std::pair<int, std::string> run(const fs::path& deck, const fs::path& out,
                                const std::string& options) {
    return test::shell(fmt::format("timeout -s KILL 60 {} run '{}' -q -j 1 -o '{}' {} 2>&1",
                                   CORPUSCLE_PROGRAM, deck.string(), out.string(), options));
}

/// The cube with a fault at SPOILED_AT, which leaves a checkpoint.
std::string broken_cube() {
    return support::BusyCube{fmt::format("*LOAD_NODE_POINT\n8, 1, 77, 1e100\n*DEFINE_CURVE\n77\n"
                                         "0.0, 0.0\n{0}, 0.0\n{0}, 1e100\n1.0, 1e100\n",
                                         SPOILED_AT)}
        .deck();
}

double number_at(const std::vector<char>& state, std::size_t at) {
    double number = 0.0;
    std::memcpy(&number, state.data() + at, sizeof(double));
    return number;
}

/// Places in a state that hold doubles: those whose eight bytes are a little other, but no more, in
/// the state of a run that began a little otherwise; counts, names and flags are the same there.
std::vector<std::size_t> numbers_in(const std::vector<char>& state,
                                    const std::vector<char>& other) {
    constexpr double LEAST = 1e-20, MOST = 1e20, LITTLE = 1e-2;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i + sizeof(double) <= state.size();) {
        const double a = number_at(state, i), b = number_at(other, i), size = std::abs(a);
        const bool is_number =
            size > LEAST && size < MOST && a != b && std::abs(b - a) < LITTLE * size;
        if (is_number) places.push_back(i);
        i += is_number ? sizeof(double) : 1;
    }
    return places;
}

/// Bytes of the simulation in the state of a run; those of its results follow.
std::size_t simulation_size(const fs::path& deck, const io::Checkpoint& checkpoint) {
    Simulation simulation(io::read_deck(deck));
    StateReader reader(checkpoint.state);
    reader(simulation);
    StateWriter writer;
    writer(simulation);
    return writer.bytes().size();
}

/// State of a run that began a little otherwise, with as many of everything: which pairs are near
/// may differ by then.
std::optional<io::Checkpoint> twin_of(const io::Checkpoint& state, const fs::path& deck,
                                      const fs::path& out) {
    for (const double eps : {1e-15, -1e-15, 2e-15, -2e-15, 4e-15, -4e-15, 8e-15, -8e-15}) {
        fs::remove_all(out);
        if (run(deck, out, fmt::format("-D DUMP=75 -D EPS={}", eps)).first != 3) return {};
        auto twin = io::read_checkpoint(out);
        if (twin && twin->state.size() == state.state.size()) return twin;
    }
    return {};
}

/// Puts a number into the checkpoint of a folder.
void spoil(const fs::path& folder, io::Checkpoint checkpoint, std::size_t at, double broken) {
    std::memcpy(checkpoint.state.data() + at, &broken, sizeof(double));
    io::write_checkpoint(folder, checkpoint);
}

void spoil_many(std::size_t wanted) {
    const test::DeckFolder folder;
    const fs::path deck = folder.write("deck.k", broken_cube());
    const fs::path run_to = deck.parent_path() / "run", out = deck.parent_path() / "out";
    REQUIRE(run(deck, run_to, "-D DUMP=75").first == 3);
    const auto state = io::read_checkpoint(run_to);
    REQUIRE(state);
    const auto other = twin_of(*state, deck, out);
    REQUIRE(other);
    REQUIRE(state->step == 75);
    REQUIRE(state->t < ENDS_AT);
    std::vector<std::size_t> places = numbers_in(state->state, other->state);
    const std::size_t size = simulation_size(deck, *state);
    std::erase_if(places, [&](std::size_t at) { return at >= size; });
    CAPTURE(state->state.size(), places.size());
    REQUIRE(places.size() > 1000);

    const std::string options = fmt::format("-D DUMP=75 --restart --until {}", ENDS_AT);
    std::map<int, int> ended;
    for (std::size_t k = 0; k < wanted; ++k) {
        const std::size_t at = places[k * places.size() / wanted];
        const double broken = k % 2 == 0 ? NaN : INF;
        fs::remove_all(out);
        fs::copy(run_to, out, fs::copy_options::recursive);
        spoil(out, *state, at, broken);
        const auto [status, told] = run(deck, out, options);
        INFO("byte " << at << ", " << number_at(state->state, at) << " is " << broken << " now\n"
                     << told);
        ++ended[status];
        CHECK((status == 0 || status == 3 ||
               (status == 1 && told.find("finite") != std::string::npos)));
        const test::Numbers numbers = test::numbers_of(out / "results.h5");
        CHECK(numbers.not_finite == "");
        CHECK(numbers.count > 1000);
    }
    fmt::print("{} of {} numbers of the state spoiled:", wanted, places.size());
    for (const auto& [status, count] : ended) fmt::print(" {} ended with status {}", count, status);
    fmt::print("\n");
    CHECK(5 * (ended[1] + ended[3]) > static_cast<int>(wanted));
}

}  // namespace

TEST_CASE("a run that goes on from a spoiled state has no NaN in its results", "[finite]") {
    spoil_many(60);
}

TEST_CASE("many spoiled states", "[.full][finite]") {
    const char* const text = std::getenv("CORPUSCLE_SPOILED");
    spoil_many(text ? std::strtoul(text, nullptr, 10) : 2000);
}
