// A strip of cloth between two held ends under pressure becomes an arc of radius R with N = p R.
#include <corpuscle/fabric/membranes.hpp>
#include <corpuscle/fabric/nodes.hpp>

#include <cstdio>

using namespace corpuscle;

int main() {
    constexpr int CELLS = 40;
    constexpr double LENGTH = 0.5, WIDTH = LENGTH / CELLS, THICKNESS = 0.3e-3;  // [m]
    constexpr double PRESSURE = 20e3, DRAG = 200.0;                             // [Pa], [1/s]

    Points x;
    std::vector<Shell> shells;
    for (int i = 0; i <= CELLS; ++i)
        for (int j = 0; j < 2; ++j) x.push_back({LENGTH * i / CELLS, WIDTH * j, 0.0});
    for (int i = 0; i < CELLS; ++i)
        shells.push_back({i + 1, 0, {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}});
    Part part{.id = 1, .material = 0, .thickness = THICKNESS};
    fabric::Material cloth{1, "cloth", fabric::ElasticCard{.density = 750, .E = 300e6, .nu = 0.3}};
    std::vector<std::array<Vec3, 4>> reference;  // stress-free corners
    for (const Shell& s : shells)
        reference.push_back({x[s.nodes[0]], x[s.nodes[1]], x[s.nodes[2]], x[s.nodes[3]]});
    const std::vector<std::uint8_t> active(shells.size(), 1);
    const fabric::MembraneSetup setup{shells, {&part, 1}, {&cloth, 1}, reference, active, x.size()};
    fabric::Membranes membranes(setup);
    const Points zero(x.size(), Vec3::Zero());
    fabric::Nodes nodes{x, x, zero, zero, fabric::lumped_mass(setup)};

    for (double t = 0.0; t < 0.1;) {
        const double dt = 0.9 * membranes.stable_step().dt;
        nodes.f = zero;
        if (membranes.add_force(nodes.x, nodes.v, nodes.f) >= 0) return 3;
        for (const Shell& s : shells) {
            const auto& [a, b, c, d] = s.nodes;
            const Vec3 area = 0.5 * (nodes.x[c] - nodes.x[a]).cross(nodes.x[d] - nodes.x[b]);
            for (const Index n : s.nodes) nodes.f[n] += PRESSURE / 4.0 * area;
        }
        for (std::size_t n = 0; n < x.size(); ++n) nodes.f[n] -= DRAG * nodes.mass[n] * nodes.v[n];
        nodes.kick(dt);
        for (Vec3& v : nodes.v) v.y() = 0.0;  // plane strain
        for (const Index n : {0, 1, 2 * CELLS, 2 * CELLS + 1}) nodes.v[n].setZero();
        nodes.drift(dt);
        nodes.x.swap(nodes.x_1);
        t += dt;
    }

    const double rise = nodes.x[CELLS].z();
    const double radius = (rise * rise + LENGTH * LENGTH / 4.0) / (2.0 * rise);
    std::vector<std::array<float, 3>> stress(shells.size()), strain(shells.size());
    membranes.stress_strain(nodes.x, stress, strain);
    const double force =
        stress[CELLS / 2][0] * THICKNESS / std::sqrt(1.0 + 2.0 * strain[CELLS / 2][0]);
    std::printf("rise %.1f mm, p R %.0f N/m, N %.0f N/m\n", 1e3 * rise, PRESSURE * radius, force);
}
