// A strip of cloth, folded over once: its upper layer falls on the lower one, which is held, and
// comes to rest there without passing through.
#include <corpuscle/solver/simulation.hpp>

#include <cstdio>

using namespace corpuscle;

int main() {
    constexpr int LONG = 24, WIDE = 6;  // cells of a layer; one more row is the fold
    constexpr double CELL = 0.01, GAP = 1.6 * CELL, THICKNESS = 0.3e-3;  // [m]

    Model model;
    ReferenceGeometry flat;  // free of stress
    for (int i = 0; i <= 2 * (LONG + 1); ++i)
        for (int j = 0; j <= WIDE; ++j) {
            const double y = CELL * j;
            const Vec3 lower(CELL * i, y, 0.0), upper(CELL * (2 * (LONG + 1) - i), y, GAP);
            const Vec3 fold(CELL * (LONG + 0.6), y, GAP / 2.0);
            flat.nodes.push_back({static_cast<Index>(model.x.size()), lower});
            model.x.push_back(i <= LONG ? lower : i == LONG + 1 ? fold : upper);
            model.node_id.push_back(static_cast<int>(model.x.size()));
            if (i <= LONG) model.supports.push_back({flat.nodes.back().first, 7U});  // x, y, z
        }
    for (int i = 0; i < 2 * (LONG + 1); ++i)
        for (int j = 0; j < WIDE; ++j) {
            const Index a = i * (WIDE + 1) + j, b = a + WIDE + 1;
            for (const auto& [p, q, r] : {Triangle{a, b, b + 1}, Triangle{a, b + 1, a + 1}})
                model.shells.push_back(
                    {static_cast<int>(model.shells.size()) + 1, 0, {p, q, r, r}});
        }
    model.references = {flat};
    model.parts = {{.id = 1, .material = 0, .thickness = THICKNESS}};
    model.materials = {{1, "cloth", fabric::ElasticCard{.density = 750, .E = 10e6, .nu = 0.3}}};
    model.body_loads = {{.axis = 2, .scale = 9.81}};  // the frame's acceleration: cloth falls
    model.mass_damping = 10.0;                        // [1/s]
    model.contacts = {{.id = 1, .parts = {0}, .friction_static = 0.3, .friction_dynamic = 0.3}};
    model.end_time = 0.2;

    Simulation simulation(std::move(model));
    double next = 0.0;
    const auto look = [&](Simulation& now) {
        if (now.time() < next) return;
        next += 0.02;
        double lowest = GAP;
        for (std::size_t n = (LONG + 2) * (WIDE + 1); n < now.nodes().size(); ++n)
            lowest = std::min(lowest, now.nodes().x[n].z());
        const contact::ContactCounts& counts = now.contact()->counts();
        std::printf("t %3.0f ms, lowest node of the upper layer %.2f mm, pairs that push %zu\n",
                    1e3 * now.time(), 1e3 * lowest, counts.touching);
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
    std::printf("pairs that passed through %zu, energy residual %.2g J\n",
                simulation.contact()->counts().unstopped, simulation.books().residual);
}
