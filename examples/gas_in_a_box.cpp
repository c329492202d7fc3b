// Gas in a box of twelve triangles, one wall of which moves out slowly: T V^(gamma - 1) stays.
#include <corpuscle/gas/bag_gas.hpp>

#include <cmath>
#include <cstdio>

using namespace corpuscle;

int main() {
    constexpr double SIDE = 0.1, SPEED = 5.0, DT = 5e-6;  // [m], [m/s], [s]
    constexpr int STEPS = 2000;

    Points x;  // node i + 2 j + 4 k at (i, j, k) SIDE
    for (int n = 0; n < 8; ++n) x.push_back(SIDE * Vec3(n & 1, n >> 1 & 1, n >> 2));
    gas::BagWalls walls;  // normals outward
    for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 2, 3, 1},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 4, 6, 2},
                                     {1, 3, 7, 5}}) {
        walls.triangles.push_back({a, b, c});
        walls.triangles.push_back({a, c, d});
    }
    walls.closing = walls.triangles.size();
    walls.shell = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    walls.part.assign(walls.closing, 0);
    walls.part_ids = {1};
    walls.part_rows = {0};
    walls.reference_area = {6.0 * SIDE * SIDE};

    gas::BagCard card;
    card.id = 1;
    card.particles = 20000;
    card.p_atm = 0.0;
    card.air = gas::InitialAirCard{.species = {.molar_mass = 0.029, .A = 29.1},
                                   .pressure = 2e5,
                                   .temperature = 400.0,
                                   .is_particles = true};
    const std::vector<int> node_id{1, 2, 3, 4, 5, 6, 7, 8};  // for messages
    const std::vector<std::uint8_t> held(8, 1);
    gas::BagGas bag(card, walls, {}, node_id, held, x, /*seed=*/1);

    const double gamma = 29.1 / (29.1 - 8.314), V_0 = SIDE * SIDE * SIDE;
    for (int step = 0; step <= STEPS; ++step) {
        const double t = step * DT;
        if (step % 500 == 0) {
            const gas::GasState now = bag.state(x);
            std::printf("t %4.1f ms, V %.3f l, p %6.2f kPa, T %.1f K, adiabat %.1f K\n", 1e3 * t,
                        1e3 * now.volume, 1e-3 * now.pressure, now.temperature,
                        400.0 * std::pow(V_0 / now.volume, gamma - 1.0));
        }
        Points x_1 = x;  // the wall at x = SIDE moves out
        for (const Index n : {1, 3, 5, 7}) x_1[n].x() += SPEED * DT;
        bag.prepare(DT, x, x_1);
        bag.collide(DT, x);
        bag.inject(t, DT, x, x_1);
        bag.fly(t, DT, x, x_1);
        x = x_1;
    }
}
