// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

enum class Kind {
    PLAIN,
    LINED,
    TENSION_FIELD,
    LINED_TENSION_FIELD,
    ISOTROPIC_TENSION_FIELD,
    ELASTIC
};
const Kind KINDS[] = {Kind::PLAIN,
                      Kind::LINED,
                      Kind::TENSION_FIELD,
                      Kind::LINED_TENSION_FIELD,
                      Kind::ISOTROPIC_TENSION_FIELD,
                      Kind::ELASTIC};

MaterialCard card(Kind kind) {
    FabricCard c = fabric_card();
    c.beta = 0.3;
    if (kind == Kind::ELASTIC) return ElasticCard{900.0, 200e6, 0.3};
    if (kind == Kind::ISOTROPIC_TENSION_FIELD) {
        c.E_weft = c.E_warp;
        c.G = 0.5 * c.E_warp / (1.0 + c.nu_ba);
    }
    c.no_compression = kind != Kind::PLAIN && kind != Kind::LINED;
    if (kind == Kind::LINED || kind == Kind::LINED_TENSION_FIELD) {
        c.liner_E = 50e6;
        c.liner_nu = 0.2;
        c.liner_ratio = 0.1;
    }
    return c;
}

Sheet jittered(Kind kind, Mesh mesh) {
    Sheet sheet = rectangle(card(kind), mesh, 4, 3, 0.4, 0.3);
    jitter(sheet, 0.02);
    return sheet;
}

}  // namespace

TEST_CASE("a rigid motion by any angle stores nothing and pushes nowhere", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const Kind kind = GENERATE(from_range(std::begin(KINDS), std::end(KINDS)));
    const double angle = GENERATE(0.0, 0.1, 1.5707963267948966, 2.5, 3.141592653589793);
    Sheet sheet = jittered(kind, mesh);
    Membranes membranes = sheet.membranes();
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Points x = moved(sheet.x, [&](const Vec3& p) { return Vec3(turn * p + Vec3(3, 1, -2)); });

    const double unit = 300e6 * 0.3e-3 * 0.1;  // force that one cell bears at a strain of 1
    CHECK(greatest(force(membranes, x)) < 1e-13 * unit);
    CHECK(membranes.strain_energy() < 1e-24 * unit);
}

TEST_CASE("the force is the energy's slope", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const Kind kind = GENERATE(from_range(std::begin(KINDS), std::end(KINDS)));
    const double amount = GENERATE(0.003, 0.03, 0.3);  // gently strained, wrinkled, crumpled
    Sheet sheet = jittered(kind, mesh);
    Membranes membranes = sheet.membranes();
    const Points x = plus(sheet.x, noise(sheet.x.size(), amount, 3));
    const Points f = force(membranes, x);

    const double step = 1e-6 * std::max(amount, 0.1);
    const double scale = greatest(f);
    for (std::size_t n = 0; n < x.size(); n += 3)
        for (int i = 0; i < 3; ++i) {
            Points ahead = x, back = x;
            ahead[n][i] += step;
            back[n][i] -= step;
            force(membranes, ahead);
            const double more = membranes.strain_energy();
            force(membranes, back);
            const double slope = (more - membranes.strain_energy()) / (2.0 * step);
            CHECK(-slope == Approx(f[n][i]).margin(3e-6 * scale).epsilon(1e-6));
        }
}

TEST_CASE("inner forces and their moments add up to nothing", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const Kind kind = GENERATE(from_range(std::begin(KINDS), std::end(KINDS)));
    Sheet sheet = jittered(kind, mesh);
    Membranes membranes = sheet.membranes();
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.05, 5));
    const Points f = force(membranes, x);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t n = 0; n < x.size(); ++n) {
        sum += f[n];
        moment += x[n].cross(f[n]);
    }
    CHECK(sum.norm() < 1e-13 * greatest(f));
    CHECK(moment.norm() < 1e-13 * greatest(f));
}

TEST_CASE("damping only dissipates, by what its forces take from the motion", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const unsigned seed = GENERATE(1u, 2u, 3u);
    FabricCard damped = fabric_card();
    damped.damping = 0.1;
    Sheet sheet = rectangle(damped, mesh, 4, 3, 0.4, 0.3);
    jitter(sheet, 0.02);
    Membranes membranes = sheet.membranes();
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.05, seed));
    const Points v = noise(x.size(), 10.0, seed + 10);
    const Points still = force(membranes, x);
    CHECK(membranes.damping_energy(v, v, 1.0) == 0.0);
    const Points moving = force(membranes, x, v);

    CHECK(membranes.damping_energy(v, v, 1.0) > 0.0);
    double power = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        CHECK((moving[n] - still[n] - membranes.damping_force()[n]).norm() <
              1e-12 * greatest(moving));
        power -= membranes.damping_force()[n].dot(v[n]);
    }
    CHECK(membranes.damping_energy(v, v, 0.5) == Approx(0.5 * power));

    // A rigid motion is not a strain rate
    const Mat3 spin = (Mat3() << 0, -3, 2, 3, 0, -1, -2, 1, 0).finished();
    const Points turning = moved(x, [&](const Vec3& p) { return Vec3(spin * p + Vec3(1, 2, 3)); });
    force(membranes, x, turning);
    Points rest(membranes.damping_force().begin(), membranes.damping_force().end());
    CHECK(greatest(rest) < 1e-12 * greatest(moving));
}

TEST_CASE("a reference shape that is warped is without stress", "[fabric]") {
    const Mesh mesh = GENERATE(Mesh::ONE_POINT, Mesh::FOUR_POINT);
    Sheet sheet = jittered(Kind::PLAIN, mesh);
    for (Vec3& p : sheet.x) p.z() += 0.5 * p.x() * p.y() + 0.3 * p.x() * p.x();
    Membranes membranes = sheet.membranes();
    CHECK(greatest(force(membranes, sheet.x)) < 1e-13 * 300e6 * 0.3e-3 * 0.1);
}

TEST_CASE("collapsed, flat and inverted elements give finite forces", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const Kind kind = GENERATE(from_range(std::begin(KINDS), std::end(KINDS)));
    Sheet sheet = jittered(kind, mesh);
    Membranes membranes = sheet.membranes();
    const auto is_fine = [&](const Points& x) {
        Points f = zeros(x.size());
        const Index broken = membranes.add_force(x, zeros(x.size()), f);
        return broken == -1 && std::isfinite(greatest(f)) &&
               std::isfinite(membranes.strain_energy());
    };
    CHECK(is_fine(moved(sheet.x, [](const Vec3&) { return Vec3(1, 1, 1); })));
    CHECK(is_fine(moved(sheet.x, [](const Vec3& p) { return Vec3(p.x(), 0, 0); })));
    CHECK(is_fine(moved(sheet.x, [](const Vec3& p) { return Vec3(-p.x(), p.y(), 0); })));
    CHECK(is_fine(
        moved(sheet.x, [](const Vec3& p) { return Vec3(std::abs(p.x() - 0.2), p.y(), 0); })));
    CHECK(is_fine(sheet.x));
}

TEST_CASE("the first shell that is not finite is named", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const Kind kind = GENERATE(from_range(std::begin(KINDS), std::end(KINDS)));
    const double bad = GENERATE(as<double>{}, NaN, INF, 1e200);
    Sheet sheet = jittered(kind, mesh);
    Membranes membranes = sheet.membranes();
    const std::size_t node = 7;
    Points x = sheet.x, f = zeros(x.size());
    x[node].y() = bad;
    Index first = -1;
    for (std::size_t e = 0; e < sheet.shells.size() && first < 0; ++e)
        for (const Index n : sheet.shells[e].nodes)
            if (n == static_cast<Index>(node)) first = static_cast<Index>(e);
    CHECK(membranes.add_force(x, zeros(x.size()), f) == first);
}

TEST_CASE("a velocity that is not finite is noticed where there is damping", "[fabric]") {
    FabricCard damped = fabric_card();
    damped.damping = 0.1;
    Sheet sheet = rectangle(damped, Mesh::MIXED, 4, 3, 0.4, 0.3);
    Membranes membranes = sheet.membranes();
    Points v = zeros(sheet.x.size()), f = v;
    v.back().x() = NaN;
    CHECK(membranes.add_force(sheet.x, v, f) == static_cast<Index>(sheet.shells.size()) - 1);
}
