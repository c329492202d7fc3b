// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random/random_surroundings.hpp"

#include <fmt/format.h>

#include <array>

#include "tests/support/draw.hpp"

namespace corpuscle::support {
namespace {

/// A rigid octahedron of steel plate, on its way down.
std::string octahedron(const Vec3& centre, double radius, Draw& draw) {
    constexpr int FIRST = 200001, PART = 50;
    std::string text = "*NODE\n";
    for (int i = 0; i < 6; ++i) {
        Vec3 x = centre;
        x[i / 2] += i % 2 == 0 ? radius : -radius;
        text += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", FIRST + i, x[0], x[1], x[2]);
    }
    text += "*ELEMENT_SHELL\n";
    constexpr std::array<std::array<int, 3>, 8> FACETS{
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int i = 0; i < 8; ++i) {
        const auto& [a, b, c] = FACETS[static_cast<std::size_t>(i)];
        text += fmt::format("{}, {}, {}, {}, {}, {}\n", FIRST + i, PART, FIRST + a, FIRST + b,
                            FIRST + c, FIRST + c);
    }
    const double plate = draw.log_in(2e-4, 4e-3);
    const std::array v{draw.in(-2.0, 2.0), draw.in(-2.0, 2.0), -draw.in(1.0, 15.0)};
    return text + fmt::format(
                      "*PART\nbody\n{0}, {0}, {0}\n*SECTION_SHELL\n{0}, 2\n{1:.4g}, "
                      "{1:.4g}, {1:.4g}, {1:.4g}\n*MAT_RIGID\n{0}, 7800.0, 2.1e11, "
                      "0.3\n,\n,\n*INITIAL_VELOCITY_RIGID_BODY\n{0}, {2:.3g}, {3:.3g}, "
                      "{4:.3g}\n",
                      PART, plate, v[0], v[1], v[2]);
}

/// One above the bag.
std::string body(const Plan& plan, Draw& draw) {
    const double radius = draw.in(0.15, 0.4) * plan.side.minCoeff();
    const double across = draw.in(0.3, 0.7), along = draw.in(0.3, 0.7);
    const Vec3 centre(across * plan.side[0], along * plan.side[1],
                      plan.side[2] + radius + draw.in(0.002, 0.02));
    return octahedron(centre, radius, draw);
}

std::string plane(const Vec3& at, const Vec3& to, double friction) {
    return fmt::format(
        "*RIGIDWALL_PLANAR\n0\n{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.3g}\n", at[0],
        at[1], at[2], to[0], to[1], to[2], friction);
}

std::string gravity(Draw& draw) {
    return fmt::format("*DEFINE_CURVE\n900\n0.0, {0:.4g}\n1.0, {0:.4g}\n*LOAD_BODY_Z\n900\n",
                       draw.in(5.0, 50.0));
}

}  // namespace

std::string surroundings(const Plan& plan, unsigned seed, std::string& words) {
    Draw draw(seed + 0x5000'0000U);
    std::string text;
    if (plan.is_rigid) return text;
    const bool has_wall = draw.chance(0.3) && !plan.is_free;
    if (has_wall) {
        const int axis = draw.below(2) == 0 ? 2 : 1;
        Vec3 at = 0.5 * plan.side, to = at;
        at[axis] = draw.in(1.02, 1.1) * plan.side[axis];
        to[axis] = 0.0;
        text += plane(at, to, draw.in(0.0, 0.5));
        words += ", a wall";
    }
    if (draw.chance(0.2) && !plan.is_free) {
        text += gravity(draw);
        words += ", gravity";
    }
    if (plan.is_free) text += "*INITIAL_VELOCITY_GENERATION\n1, 1, 0, 3.0, -2.0, 1.0\n,\n";
    Draw apart(seed + 0x6000'0000U);
    if (!has_wall && apart.chance(0.4)) {
        text += body(plan, apart);
        words += ", a body";
    }
    return text;
}

std::string surroundings_of_pack(const Plan& plan, const Eigen::AlignedBox3d& pack, Draw& draw,
                                 std::string& words) {
    const Vec3 middle = pack.center(), up = Vec3::UnitZ();
    const auto at_height = [&](double z) { return Vec3(middle[0], middle[1], z); };
    std::string text;
    if (!plan.is_free && draw.chance(0.4)) {
        const Vec3 at = at_height(pack.min().z() - draw.in(0.5e-3, 5e-3));
        text += plane(at, at + up, draw.in(0.0, 0.5));
        words += ", a floor";
    }
    const int above = draw.below(4);
    if (above == 0) {
        const double radius = draw.in(0.015, 0.05);
        const double across = draw.in(-0.3, 0.3), along = draw.in(-0.3, 0.3);
        const Vec3 aside(across * pack.sizes().x(), along * pack.sizes().y(),
                         radius + draw.in(0.002, 0.02));
        text += octahedron(at_height(pack.max().z()) + aside, radius, draw);
        words += ", a body";
    } else if (above == 1 && !plan.is_free) {
        const Vec3 at = at_height(pack.max().z() + draw.in(0.005, 0.05));
        text += plane(at, at - up, draw.in(0.0, 0.5));
        words += ", a wall";
    } else if (above == 2 && !plan.is_free) {
        // driven down, but not into the pack as it was
        const double clearance = draw.in(0.005, 0.05), z = pack.max().z() + clearance;
        text += fmt::format(
            "*DEFINE_CURVE\n901\n0.0, 0.0\n{:.6g}, {:.6g}\n*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n0\n"
            "{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.3g}\n0.0, 0.0, 0.0, 0.0, 0.0\n"
            "901, 1, 0.0, 0.0, -1.0\n",
            plan.end, 0.8 * clearance, middle[0], middle[1], z, middle[0], middle[1], z - 1.0,
            draw.in(0.0, 0.5));
        words += ", a driven wall";
    }
    if (!plan.is_free && draw.chance(0.2)) {
        text += gravity(draw);
        words += ", gravity";
    }
    return text;
}

}  // namespace corpuscle::support
