// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>

#include "solver/base/surface.hpp"
#include "solver/loads.hpp"

using namespace corpuscle;

namespace {

constexpr double PRESSURE = 3e4;

/// Forces of a pressure on one facet.
Points pressed(const std::array<Index, 4>& facet, const Points& x) {
    Model model;
    model.x = x;
    PressureLoad load;
    load.facets = {facet};
    load.scale = PRESSURE;
    model.pressure_loads = {load};
    Points f(x.size());
    Loads(model).find_force(0.0, x, std::vector<double>(x.size(), 1.0), f);
    return f;
}

}  // namespace

TEST_CASE("pressure on a flat facet does the work of the pressure in any linear motion",
          "[loads]") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> by(-0.3, 0.3);
    const bool is_quad = GENERATE(true, false);
    for (int i = 0; i < 200; ++i) {
        Points x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        for (Vec3& corner : x) corner += Vec3(by(random), by(random), 0.0);
        const Points f = pressed({0, 1, 2, is_quad ? 3 : 2}, x);
        Vec3 area = vector_area(x[0], x[1], x[2]), first = area.z() / 3.0 * (x[0] + x[1] + x[2]);
        if (is_quad) {
            const Vec3 other = vector_area(x[0], x[2], x[3]);
            first += other.z() / 3.0 * (x[0] + x[2] + x[3]);
            area += other;
        }
        Vec3 sum = Vec3::Zero();
        Eigen::Matrix3d work = Eigen::Matrix3d::Zero();  // of unit gradients of displacement
        for (std::size_t k = 0; k < x.size(); ++k) {
            sum += f[k];
            work += f[k] * x[k].transpose();
        }
        REQUIRE((sum + PRESSURE * area).norm() < 1e-9 * PRESSURE);
        REQUIRE((work + PRESSURE * Vec3::UnitZ() * first.transpose()).norm() < 1e-9 * PRESSURE);
    }
}

TEST_CASE("pressure on a quad knows no first corner, and gives a square's a quarter each",
          "[loads]") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> by(-0.3, 0.3);
    Points x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const Vec3& corner : pressed({0, 1, 2, 3}, x))
        CHECK((corner + 0.25 * PRESSURE * Vec3::UnitZ()).norm() < 1e-9 * PRESSURE);
    for (Vec3& corner : x) corner += Vec3(by(random), by(random), by(random));
    const Points f = pressed({0, 1, 2, 3}, x);
    for (Index first = 1; first < 4; ++first) {
        const Points turned =
            pressed({first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4}, x);
        for (std::size_t k = 0; k < 4; ++k) CHECK((turned[k] - f[k]).norm() < 1e-9 * PRESSURE);
    }
}

TEST_CASE("where there is contact, pressure acts on a quad's triangles as contact sees them",
          "[loads]") {
    Model model;
    model.x = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    Shell shell;
    shell.nodes = {1, 2, 3, 0};
    model.shells = {shell};
    model.contacts.emplace_back();
    const Index first = GENERATE(0, 1, 2, 3);  // of a segment on that shell
    PressureLoad load;
    load.facets = {{first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4}};
    load.scale = PRESSURE;
    model.pressure_loads = {load};
    Points f(model.x.size());
    Loads(model).find_force(0.0, model.x, std::vector<double>(f.size(), 1.0), f);
    for (std::size_t k = 0; k < f.size(); ++k) {
        const double share = k % 2 == 1 ? 1.0 / 3.0 : 1.0 / 6.0;  // nodes 1 and 3: both triangles
        CHECK((f[k] + share * PRESSURE * Vec3::UnitZ()).norm() < 1e-9 * PRESSURE);
    }
}
