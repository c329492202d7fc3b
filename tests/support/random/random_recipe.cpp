// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random/random_recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tests/support/draw.hpp"

namespace corpuscle::support {
namespace {

struct Range {
    double low, high;
};
constexpr Range FINE{9.0, 14.0}, COARSE{14.0, 18.0};

std::string pattern(Draw& draw, double& half, Range elements = FINE, double largest = 300.0) {
    const double element = draw.in(elements.low, elements.high), gap = draw.in(0.5, 1.2);
    half = draw.in(200.0, largest);
    std::string size = draw.below(2)
                           ? fmt::format("kind = \"disc\"\ndiameter = {}\n", 2.0 * half)
                           : fmt::format("kind = \"rectangle\"\nlength = {}\nwidth = {}\n",
                                         2.0 * half, draw.in(1.6, 2.4) * half);
    return fmt::format("[pattern]\n{}element = {}\ngap = {}\n", size, element, gap);
}

std::string hole_and_vents(Draw& draw) {
    std::string text;
    if (draw.below(2))
        text += fmt::format("[hole]\ndiameter = {}\nreinforcement = {}\n", 60.0,
                            draw.below(2) ? 100.0 : 0.0);
    for (int i = draw.below(3); i > 0; --i)
        text += fmt::format("[[vent]]\nat = [{}, {}]\ndiameter = {}\n", i == 1 ? 90.0 : -90.0,
                            draw.in(60.0, 100.0), draw.in(25.0, 40.0));
    if (draw.below(3) == 0)
        text += fmt::format("[[tether]]\nfrom = [{}, 0]\nlength = {}\nwidth = {}\n",
                            draw.in(-110.0, -90.0), draw.in(150.0, 220.0), draw.in(35.0, 60.0));
    return text;
}

std::string fold(Draw& draw, double half, double angle) {
    const char* onto = draw.below(2) ? "front" : "back";
    const char* side = draw.below(2) ? "right" : "left";
    std::string text = fmt::format("[[fold]]\nangle = {}\nonto = \"{}\"\n", angle, onto);
    switch (draw.below(4)) {
        case 0:
            return text + fmt::format("kind = \"half\"\nside = \"{}\"\nat = {}\n", side,
                                      draw.in(-0.1, 0.3) * half);
        case 1:
            return text +
                   fmt::format("kind = \"zigzag\"\nside = \"both\"\nstart = {}\nwidth = {}\n",
                               draw.in(60.0, 90.0), draw.in(50.0, 75.0));
        case 2:
            return text +
                   fmt::format("kind = \"zigzag\"\nside = \"{}\"\nstart = {}\npleats = [{}, {}]\n",
                               side, draw.in(-0.3, -0.1) * half, draw.in(60.0, 100.0),
                               draw.in(50.0, 90.0));
        default:
            return text +
                   fmt::format(
                       "kind = \"roll\"\nside = \"{}\"\nstart = {}\nwidth = {}\ncount = {}\n", side,
                       draw.in(0.6, 0.8) * half, draw.in(45.0, 70.0), 1 + draw.below(3));
    }
}

/// Over the front and clear of the middle, so that the dish stays where it is.
std::string fold_beside_middle(Draw& draw, double half, double angle) {
    const char* side = std::array{"right", "left", "both"}[static_cast<std::size_t>(draw.below(3))];
    std::string text = fmt::format("[[fold]]\nangle = {}\nonto = \"front\"\n", angle);
    switch (draw.below(3)) {
        case 0:
            return text + fmt::format("kind = \"half\"\nside = \"{}\"\nat = {}\n",
                                      draw.below(2) ? "right" : "left",
                                      std::max(70.0, draw.in(0.3, 0.5) * half));
        case 1:
            return text + fmt::format("kind = \"zigzag\"\nside = \"{}\"\nstart = {}\nwidth = {}\n",
                                      side, draw.in(70.0, 90.0), draw.in(55.0, 75.0));
        default: {
            const double width = draw.in(45.0, 70.0);
            const int most = 1 + static_cast<int>((0.8 * half - 75.0) / width);
            const int count = 1 + draw.below(std::min(3, most));
            const double start = std::min(0.85 * half, 75.0 + width * (count - 1) + draw.in(0, 40));
            return text +
                   fmt::format(
                       "kind = \"roll\"\nside = \"{}\"\nstart = {}\nwidth = {}\ncount = {}\n", side,
                       start, width, count);
        }
    }
}

/// The same of a bag of SmallBag, in metres; `onto_back`: over the other panel.
std::string small_fold(Draw& draw, double half, double angle, bool onto_back) {
    constexpr double CLEAR = 0.048;  ///< of the middle                                      [m]
    const char* side = std::array{"right", "left", "both"}[static_cast<std::size_t>(draw.below(3))];
    std::string text =
        fmt::format("[[fold]]\nangle = {}\nonto = \"{}\"\n", angle, onto_back ? "back" : "front");
    switch (draw.below(3)) {
        case 0:
            return text + fmt::format("kind = \"half\"\nside = \"{}\"\nat = {}\n",
                                      draw.below(2) > 0 ? "right" : "left",
                                      std::max(CLEAR, draw.in(0.3, 0.5) * half));
        case 1: {
            const double start = draw.in(CLEAR, 0.06);
            return text + fmt::format("kind = \"zigzag\"\nside = \"{}\"\nstart = {}\nwidth = {}\n",
                                      side, start, draw.in(0.035, 0.05));
        }
        default: {
            const double width = draw.in(0.03, 0.045);
            const int most = 1 + static_cast<int>((0.8 * half - CLEAR) / width);
            const int count = 1 + draw.below(std::min(3, most));
            const double start =
                std::min(0.85 * half, CLEAR + width * (count - 1) + draw.in(0.0, 0.02));
            return text +
                   fmt::format(
                       "kind = \"roll\"\nside = \"{}\"\nstart = {}\nwidth = {}\ncount = {}\n", side,
                       start, width, count);
        }
    }
}

}  // namespace

std::string random_recipe(unsigned seed, bool is_oblique) {
    Draw draw(seed);
    double half = 0.0;
    std::string text = pattern(draw, half) + hole_and_vents(draw);
    const int folds = 1 + draw.below(is_oblique ? 2 : 3);
    for (int i = 0, axis = draw.below(2); i < folds; ++i, axis = 1 - axis)
        text += fold(draw, half, is_oblique ? draw.in(-90.0, 90.0) : 90.0 * axis);
    return text;
}

std::string random_tuck_recipe(unsigned seed) {
    Draw draw(seed);
    double half = 0.0;
    std::string text = pattern(draw, half);
    const int axis = draw.below(2);
    const char* side = std::array{"right", "left", "both"}[static_cast<std::size_t>(draw.below(3))];
    text += fmt::format("[[fold]]\nkind = \"tuck\"\nangle = {}\nside = \"{}\"\nat = {}\n",
                        90.0 * axis, side, draw.in(0.55, 0.75) * half);
    return text + fold(draw, half, 90.0 * (1 - axis));
}

std::string random_airbag_recipe(unsigned seed) {
    Draw draw(seed);
    double half = 0.0;
    std::string text = pattern(draw, half, COARSE, 320.0);
    text += fmt::format("[hole]\ndiameter = 60.0\nreinforcement = {}\ndepth = 20.0\n",
                        draw.below(2) ? 110.0 : 0.0);
    for (int i = draw.below(3); i > 0; --i)
        text += fmt::format("[[vent]]\nat = [{}, {}]\ndiameter = {}\n", i == 1 ? 100.0 : -100.0,
                            draw.in(70.0, 110.0), draw.in(36.0, 50.0));
    if (draw.below(3) == 0)
        text += fmt::format("[[tether]]\nfrom = [{}, 0]\nlength = {}\nwidth = {}\n",
                            draw.in(-120.0, -100.0), draw.in(200.0, 240.0), draw.in(35.0, 60.0));
    const bool is_oblique = draw.below(3) == 0;
    const int folds = 1 + draw.below(is_oblique ? 2 : 3);
    for (int i = 0, axis = draw.below(2); i < folds; ++i, axis = 1 - axis)
        text += fold_beside_middle(draw, half, is_oblique ? draw.in(-90.0, 90.0) : 90.0 * axis);
    return text;
}

std::string random_small_recipe(unsigned seed, SmallBag kind) {
    Draw draw(seed);
    const double element = draw.in(0.020, 0.0243), gap = draw.in(0.7e-3, 1.2e-3);
    const double half = draw.in(0.11, 0.17);
    std::string text = "[pattern]\n";
    if (draw.below(2) > 0)
        text += fmt::format("kind = \"disc\"\ndiameter = {}\n", 2.0 * half);
    else
        text += fmt::format("kind = \"rectangle\"\nlength = {}\nwidth = {}\n", 2.0 * half,
                            draw.in(1.6, 2.4) * half);
    text += fmt::format("element = {}\ngap = {}\n", element, gap);
    text += fmt::format(
        "[parts]\nfront = {}\nback = {}\nmodule = {}\nreinforcement = {}\nvent = {}\ntether = "
        "{}\n",
        kind.front, kind.back, kind.module, kind.reinforcement, kind.vent, kind.tether);
    const int place = kind.has_cover ? draw.below(2) : draw.below(4);
    if (place < 2)
        text += fmt::format("[hole]\ndiameter = 0.06\nreinforcement = {}\ndepth = {}\n",
                            draw.below(2) > 0 ? 0.085 : 0.0, place == 0 ? 0.015 : 0.0);
    if (place == 2) text += "[inflator]\nat = [0.0, 0.0]\ndiameter = 0.08\n";
    for (int i = kind.has_vents ? 1 + draw.below(2) : 0; i > 0; --i)
        text += fmt::format("[[vent]]\nat = [{}, 0.06]\ndiameter = {}\n", i == 1 ? 0.045 : -0.045,
                            draw.in(2.2, 2.4) * element);
    if (draw.below(4) == 0) {
        const double length = draw.in(0.13, 0.15);
        text += fmt::format("[[tether]]\nfrom = [{}, 0]\nlength = {}\nwidth = {}\n", -0.5 * length,
                            length, draw.in(0.025, 0.04));
    }
    const bool is_oblique = draw.below(4) == 0;
    const int folds = 1 + draw.below(2) + (draw.chance(0.15) ? 1 : 0);
    for (int i = 0, axis = draw.below(2); i < folds; ++i, axis = 1 - axis)
        text += small_fold(draw, half, is_oblique ? draw.in(-90.0, 90.0) : 90.0 * axis,
                           place == 3 && draw.below(3) == 0);
    return text;
}

}  // namespace corpuscle::support
