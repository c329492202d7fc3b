// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Volumes, areas and insides of a wetted surface as it lies.

#include <numbers>

#include "gas/enclosure/inside.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {
void WettedSurface::volumes(std::span<const Vec3> x, std::vector<double>& volume) const {
    volume.assign(rooms_, 0.0);
    const Vec3 origin = x[triangles_[0][0]];  // near the bag: no cancellation far from (0, 0, 0)
    for (std::size_t r = 0; r < rooms_; ++r)
        volume[r] = parallel::sum(sides(), 0.0, [&](std::size_t s) {
            if (room_[s] != static_cast<Index>(r)) return 0.0;
            const Triangle& t = triangles_[facet_[s]];
            return sign(s) * signed_volume(x[t[0]] - origin, x[t[1]] - origin, x[t[2]] - origin);
        });
}

std::vector<Vec3> WettedSurface::mean_way(std::span<const Vec3> x_0,
                                          std::span<const Vec3> x_1) const {
    struct Sums {
        Vec3 way = Vec3::Zero();  ///< [m^3]
        double area = 0.0;        ///< [m^2]
        Sums& operator+=(const Sums& o) {
            way += o.way;
            area += o.area;
            return *this;
        }
    };
    std::vector<Vec3> way(rooms_, Vec3::Zero());
    for (std::size_t r = 0; r < rooms_; ++r) {
        const Sums all = parallel::sum(sides(), Sums{}, [&](std::size_t s) {
            Sums own;
            if (room_[s] != static_cast<Index>(r)) return own;
            const auto& [a, b, c] = triangles_[facet_[s]];
            own.area = vector_area(x_0[a], x_0[b], x_0[c]).norm();
            own.way = own.area / 3.0 * (x_1[a] - x_0[a] + x_1[b] - x_0[b] + x_1[c] - x_0[c]);
            return own;
        });
        if (all.area > 0.0) way[r] = all.way / all.area;
    }
    return way;
}

std::vector<Index> WettedSurface::rooms_of(std::span<const Vec3> points,
                                           std::span<const Vec3> x) const {
    std::vector<Index> found(points.size(), 0);
    if (rooms_ == 1) return found;
    std::vector<std::vector<Triangle>> walls;
    std::vector<InsideTest> tests;
    for (std::size_t r = 0; r < rooms_; ++r) tests.emplace_back(walls.emplace_back(wall(r)), x);
    parallel::for_each(points.size(), [&](std::size_t i) {
        for (std::size_t r = 0; r < tests.size(); ++r) {
            const auto winding = tests[r].winding(points[i]);
            if (winding ? *winding > 0
                        : solid_angle(walls[r], points[i], x) > 2.0 * std::numbers::pi) {
                found[i] = static_cast<Index>(r);
                return;
            }
        }
    });
    return found;
}

void WettedSurface::point_areas(std::span<const Vec3> x, std::span<Vec3> area) const {
    thread_local Points kept;  // no memory is asked for in each step
    Points& of_facet = kept;
    of_facet.resize(triangles_.size());
    parallel::in_turn(
        parallel::each(triangles_.size(), [&](std::size_t t) { of_facet[t] = facet_area(t, x); }),
        parallel::each(points(), [&](std::size_t p) { area[p] = point_area(p, of_facet); }));
}

}  // namespace corpuscle::gas
