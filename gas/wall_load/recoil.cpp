// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/recoil.hpp"

#include <algorithm>

namespace corpuscle::gas {
namespace {

/// A disc of so many rings has 61 points; the smoother's kernel S has 1 / sum S² = 55 on an even
/// mesh.
constexpr int RINGS = 4;

/// Below this share of each node's mass there is no recoil: on wet cloth it would be less than a
/// thousandth.
constexpr double LIGHT = 0.05;

/// Of points round a side; a thread keeps its memory from one to the next.
struct Search {
    std::vector<std::uint64_t> seen;  ///< by point: the search that was there last
    std::uint64_t number = 0;
    std::vector<Index> ring, next;

    void begin(std::size_t points) {
        if (seen.size() < points) seen.resize(points, 0);
        ++number;
        ring.clear();
    }
};

}  // namespace

double Recoil::share(const WettedSurface& surface, std::size_t side,
                     const std::array<double, 3>& at, double m,
                     std::span<const double> link) const {
    if (mass_.empty()) return 1.0;
    bool is_light = true;
    double free = 0.0;  // share of the impulse that goes to nodes that are free
    for (int c = 0; c < 3; ++c) {
        const Index p = surface.points(side)[c];
        if (held_[p] != 0) continue;
        is_light = is_light && m < LIGHT * mass_[p];
        free += at[c];
    }
    if (is_light) return 1.0;
    // The impulse free J on M: energy (free J)² / 2M, as J on M / free².
    const double M = mass_around(surface, side, link);
    return M / (M + free * free * m);
}

void Recoil::set_right(const WettedSurface& surface, std::span<Hit> hits,
                       std::span<const Index> sides, double m, std::span<const double> link,
                       const Vec3& x, Vec3& v) const {
    Vec3 flown = v;  // velocity before each hit, in flight
    for (const Hit& hit : hits) flown += hit.impulse / m;
    Vec3 lacks = Vec3::Zero();
    const auto energy = [&] { return m * (flown.dot(lacks) + 0.5 * lacks.squaredNorm()); };
    for (std::size_t k = 0; k < hits.size(); ++k) {
        Hit& hit = hits[k];
        const double f = share(surface, static_cast<std::size_t>(sides[k]), hit.at, m, link);
        const Vec3 thrown = hit.impulse;
        const double before = energy();
        flown = k + 1 == hits.size() ? v : Vec3(flown - thrown / m);
        if (f == 1.0 && lacks.isZero(0.0)) continue;
        const double J = thrown.norm();
        if (J == 0.0) continue;
        const double along = lacks.dot(thrown) / J;
        hit.impulse *= f * std::max(0.0, 1.0 + 2.0 * m * along / J);
        lacks += (thrown - hit.impulse) / m;
        hit.moment = (hit.where - x).cross(thrown - hit.impulse);
        hit.energy += before - energy();
    }
    v += lacks;
}

double Recoil::mass_around(const WettedSurface& surface, std::size_t side,
                           std::span<const double> link) const {
    thread_local Search search;
    search.begin(mass_.size());
    double sum = 0.0;
    const auto reach = [&](Index p, std::vector<Index>& ring) {
        if (held_[p] != 0 || search.seen[p] == search.number) return;
        search.seen[p] = search.number;
        sum += mass_[p];
        ring.push_back(p);
    };
    for (const Index p : surface.points(side)) reach(p, search.ring);
    for (int k = 0; k < RINGS && !search.ring.empty(); ++k) {
        search.next.clear();
        for (const Index p : search.ring)
            for (const auto& [q, edge] : surface.neighbours(p))
                if (link[edge] > 0.0) reach(q, search.next);
        search.ring.swap(search.next);
    }
    return sum;
}

}  // namespace corpuscle::gas
