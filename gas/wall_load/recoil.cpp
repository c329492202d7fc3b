// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/recoil.hpp"

#include <algorithm>

namespace corpuscle::gas {
namespace {

/// Below this share of each node's mass there is no recoil: on wet cloth it would be less than a
/// thousandth.
constexpr double LIGHT = 0.05;

/// Velocity that one particle's hits in one step bring the cloth, given at once. A thread keeps
/// its memory from one particle to the next.
class Kicked {
public:
    void begin(std::size_t points) {
        for (const Index p : touched_) velocity_[p].setZero();
        touched_.clear();
        velocity_.resize(std::max(velocity_.size(), points), Vec3::Zero());
    }
    /// At the place of a hit.                                                               [m/s]
    [[nodiscard]] Vec3 at(const PlaceSpread& place) const {
        Vec3 sum = Vec3::Zero();
        for (const Index p : place.points()) sum += place.share(p) * velocity_[p];
        return sum;
    }
    void add(const PlaceSpread& place, const Vec3& impulse, std::span<const double> mass) {
        for (const Index p : place.points()) {
            velocity_[p] += place.share(p) / mass[p] * impulse;
            touched_.push_back(p);
        }
    }

private:
    std::vector<Vec3> velocity_;  ///< by point                                             [m/s]
    std::vector<Index> touched_;
};

}  // namespace

bool Recoil::is_heavy(double m, const std::array<Index, 3>& points) const {
    return std::any_of(points.begin(), points.end(),
                       [&](Index p) { return held_[p] == 0 && m >= LIGHT * mass_[p]; });
}

void Recoil::set_right(const WettedSurface& surface, const PointSmoother& smoother,
                       std::span<Hit> hits, std::span<const Index> sides, double m, const Vec3& x,
                       Vec3& v) const {
    if (mass_.empty()) return;
    thread_local Kicked kicked;
    thread_local PlaceSpread place;
    kicked.begin(mass_.size());
    Vec3 flown = v;  // velocity before each hit, in flight
    for (const Hit& hit : hits) flown += hit.impulse / m;
    Vec3 lacks = Vec3::Zero();
    const auto energy = [&] { return m * (flown.dot(lacks) + 0.5 * lacks.squaredNorm()); };
    for (std::size_t k = 0; k < hits.size(); ++k) {
        Hit& hit = hits[k];
        const std::array<Index, 3>& points = surface.points(static_cast<std::size_t>(sides[k]));
        const Vec3 thrown = hit.impulse;
        const double before = energy(), J = thrown.norm();
        flown = k + 1 == hits.size() ? v : Vec3(flown - thrown / m);
        const bool recoils = is_heavy(m, points);
        if ((!recoils && lacks.isZero(0.0)) || J == 0.0) continue;
        place.begin(mass_.size());
        for (int c = 0; recoils && c < 3; ++c)
            if (held_[points[c]] == 0) place.add(points[c], hit.at[c]);
        smoother.spread(surface, place);
        double per_mass = 0.0;  // 1 / M
        for (const Index p : place.points()) per_mass += place.share(p) * place.share(p) / mass_[p];
        const double along = (lacks - kicked.at(place)).dot(thrown) / J;
        hit.impulse *= std::max(0.0, 1.0 + 2.0 * m * along / J) / (1.0 + m * per_mass);
        kicked.add(place, hit.impulse, mass_);
        lacks += (thrown - hit.impulse) / m;
        hit.moment = (hit.where - x).cross(thrown - hit.impulse);
        hit.energy += before - energy();
    }
    v += lacks;
}

}  // namespace corpuscle::gas
