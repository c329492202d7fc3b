// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random_recipe.hpp"

#include <fmt/format.h>

#include <array>
#include <random>

namespace corpuscle::support {
namespace {

class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double in(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }
    int below(int n) { return static_cast<int>(in(0.0, n)); }

private:
    std::mt19937 random_;
};

std::string pattern(Draw& draw, double& half) {
    const double element = draw.in(9.0, 14.0), gap = draw.in(0.5, 1.2);
    half = draw.in(200.0, 300.0);
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

}  // namespace corpuscle::support
