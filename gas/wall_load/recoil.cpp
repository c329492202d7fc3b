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

}  // namespace

Recoil::Recoil(const WettedSurface& surface, std::span<const std::uint8_t> held)
    : held_(held.begin(), held.end()), seen_(surface.points(), 0) {}

void Recoil::weigh(const WettedSurface& surface, std::span<const double> node_mass) {
    mass_.resize(surface.points());
    for (std::size_t p = 0; p < mass_.size(); ++p) mass_[p] = node_mass[surface.node(p)];
}

double Recoil::share(const WettedSurface& surface, std::size_t side,
                     const std::array<double, 3>& at, double m, std::span<const double> link) {
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
                       Vec3& v) {
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
        hit.energy += before - energy();
    }
    v += lacks;
}

double Recoil::mass_around(const WettedSurface& surface, std::size_t side,
                           std::span<const double> link) {
    ++search_;
    double sum = 0.0;
    ring_.clear();
    const auto reach = [&](Index p, std::vector<Index>& ring) {
        if (held_[p] != 0 || seen_[p] == search_) return;
        seen_[p] = search_;
        sum += mass_[p];
        ring.push_back(p);
    };
    for (const Index p : surface.points(side)) reach(p, ring_);
    for (int k = 0; k < RINGS && !ring_.empty(); ++k) {
        next_.clear();
        for (const Index p : ring_)
            for (const auto& [q, edge] : surface.neighbours(p))
                if (link[edge] > 0.0) reach(q, next_);
        ring_.swap(next_);
    }
    return sum;
}

}  // namespace corpuscle::gas
