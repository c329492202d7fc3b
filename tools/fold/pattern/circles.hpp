// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/plan.hpp"

namespace corpuscle::fold {

struct Circle {
    Vec3 middle;
    double radius;
};

/// A circle that is the border of a region.
struct Cut {
    Circle circle;
    int region;
};

/// Area of the cells of a region. [m^2]
[[nodiscard]] double area_of(const Sheet& sheet, int region);

/// Cuts along circles, outer before inner, with the areas of the drawing; `part` is the Region.
[[nodiscard]] Sheet cut_holes(const std::vector<Cut>& cuts, double size, const Sheet& whole);

/// What is within the radius.
[[nodiscard]] Sheet cut_rim(double radius, double size, const Sheet& whole);

}  // namespace corpuscle::fold
