// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/convex_region.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

constexpr double BORDER = 1e-9;  ///< in extents of the region

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double area_of(const std::vector<Vec2>& corner) {
    double twice = 0.0;
    for (std::size_t k = 2; k < corner.size(); ++k)
        twice += cross(corner[k - 1] - corner[0], corner[k] - corner[0]);
    return 0.5 * std::abs(twice);
}

/// One side of the hull of sorted points after the other [Andrew 1979].
std::vector<Vec2> hull_of(const std::vector<Vec2>& sorted) {
    std::vector<Vec2> hull;
    const auto add = [&](const Vec2& p, std::size_t keep) {
        while (hull.size() >= keep + 2 &&
               cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Vec2& p : sorted) add(p, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = sorted.size() - 1; i-- > 0;) add(sorted[i], lower);
    if (!hull.empty()) hull.pop_back();
    return hull;
}

}  // namespace

ConvexRegion::ConvexRegion(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    if (points.empty()) return;
    corner_ = hull_of(points);
    area_ = area_of(corner_);
    for (std::size_t k = 0; k < corner_.size(); ++k) {
        const Vec2 along = corner_[(k + 1) % corner_.size()] - corner_[k];
        border_ = std::max(border_, BORDER * along.norm());
        inward_.push_back(Vec2(-along.y(), along.x()).normalized());
        offset_.push_back(inward_.back().dot(corner_[k]));
    }
}

ConvexRegion::Part ConvexRegion::part_within(const std::array<Vec2, 3>& triangle) const {
    Part part = Part::ALL;
    for (std::size_t k = 0; k < corner_.size(); ++k) {
        const double a = depth(k, triangle[0]), b = depth(k, triangle[1]),
                     c = depth(k, triangle[2]);
        if (std::max({a, b, c}) <= 0.0) return Part::NONE;
        if (std::min({a, b, c}) <= border_) part = Part::SOME;
    }
    return part;
}

/// Cuts the triangle at one border after the other [Sutherland, Hodgman 1974].
double ConvexRegion::area_within(const std::array<Vec2, 3>& triangle) const {
    std::vector<Vec2> part(triangle.begin(), triangle.end()), cut;
    for (std::size_t k = 0; k < corner_.size(); ++k) {
        const auto is_within = [&](const Vec2& p) { return depth(k, p) >= 0.0; };
        if (std::all_of(part.begin(), part.end(), is_within)) continue;
        cut.clear();
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Vec2 &a = part[i], &b = part[(i + 1) % part.size()];
            const double da = depth(k, a), db = depth(k, b);
            if (da >= 0.0) cut.push_back(a);
            if ((da >= 0.0) != (db >= 0.0)) cut.push_back(a + da / (da - db) * (b - a));
        }
        part.swap(cut);
    }
    return area_of(part);
}

bool ConvexRegion::is_crossed(const Vec2& a, const Vec2& b) const {
    double first = 0.0, last = 1.0;
    for (std::size_t k = 0; k < corner_.size(); ++k) {
        const double da = depth(k, a) - border_, db = depth(k, b) - border_;
        if (da <= 0.0 && db <= 0.0) return false;
        if (da < 0.0) first = std::max(first, da / (da - db));
        if (db < 0.0) last = std::min(last, da / (da - db));
    }
    return first < last;
}

}  // namespace corpuscle::contact
