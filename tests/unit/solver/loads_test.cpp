// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "solver/loads.hpp"

using namespace corpuscle;

namespace {

using Facets = std::vector<std::array<Index, 4>>;

/// Forces of a pressure of 1 on facets.
Points pressed(const Points& x, const Facets& facets) {
    Model model;
    model.x = x;
    PressureLoad load;
    load.facets = facets;
    model.pressure_loads = {load};
    Points f(x.size(), Vec3::Zero());
    Loads(model).find_force(0.0, x, std::vector<double>(x.size(), 1.0), f);
    return f;
}

/// Volume in quads, mean of both ways to cut them.
double volume_of(const Points& x, const Facets& quads) {
    double sum = 0.0;
    for (const auto& q : quads) {
        const auto cone = [&](int a, int b, int c) {
            return x[q[a]].dot(x[q[b]].cross(x[q[c]])) / 6.0;
        };
        sum += 0.5 * (cone(0, 1, 2) + cone(0, 2, 3) + cone(0, 1, 3) + cone(1, 2, 3));
    }
    return sum;
}

}  // namespace

TEST_CASE("pressure loads the corners of a square alike", "[solver]") {
    const Points x{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (const Vec3& f : pressed(x, {{0, 1, 2, 3}})) CHECK((f - Vec3(0, 0, -1)).norm() < 1e-15);
}

TEST_CASE("pressure on warped quads does the work p dV", "[solver]") {
    Points x{{0.1, 0, 0}, {1, 0.2, 0}, {1, 1, -0.1},  {0, 1.2, 0.1},
             {0, 0, 1.1}, {1.2, 0, 1}, {0.9, 1, 1.3}, {0, 0.8, 1}};
    const Facets outward{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                         {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const Points f = pressed(x, outward);
    constexpr double STEP = 0.01;  // the volume is linear in each coordinate
    for (std::size_t n = 0; n < x.size(); ++n)
        for (int axis = 0; axis < 3; ++axis) {
            Points up = x, down = x;
            up[n][axis] += STEP;
            down[n][axis] -= STEP;
            const double slope = (volume_of(up, outward) - volume_of(down, outward)) / (2 * STEP);
            CHECK(f[n][axis] == Approx(-slope).margin(1e-12));
        }
}
