// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/random_surroundings.hpp"

#include <fmt/format.h>

#include <array>

#include "tests/support/draw.hpp"

namespace corpuscle::support {
namespace {

/// A rigid octahedron of steel plate, above the bag, on its way down.
std::string body(const Plan& plan, Draw& draw) {
    constexpr int FIRST = 200001, PART = 50;
    const double radius = draw.in(0.15, 0.4) * plan.side.minCoeff();
    const double across = draw.in(0.3, 0.7), along = draw.in(0.3, 0.7);
    const Vec3 centre(across * plan.side[0], along * plan.side[1],
                      plan.side[2] + radius + draw.in(0.002, 0.02));
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
        text += fmt::format(
            "*RIGIDWALL_PLANAR\n0\n{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.3g}\n", at[0],
            at[1], at[2], to[0], to[1], to[2], draw.in(0.0, 0.5));
        words += ", a wall";
    }
    if (draw.chance(0.2) && !plan.is_free) {
        text += fmt::format("*DEFINE_CURVE\n900\n0.0, {0:.4g}\n1.0, {0:.4g}\n*LOAD_BODY_Z\n900\n",
                            draw.in(5.0, 50.0));
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

}  // namespace corpuscle::support
