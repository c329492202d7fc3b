// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/planar_wall.hpp"

#include <algorithm>

namespace corpuscle::contact {

PlanarWall::PlanarWall(const PlanarWallCard& card) : card_(card) {}

void PlanarWall::hold(const Points& x, std::span<const double> mass, double t, double dt,
                      Points& v) {
    force_.setZero();
    touching_.clear();
    if (t < card_.birth || t > card_.death) return;
    if (is_behind_.size() != card_.nodes.size()) note_nodes_behind(x);

    Vec3 impulse = Vec3::Zero();
    for (std::size_t i = 0; i < card_.nodes.size(); ++i) {
        const Index node = card_.nodes[i];
        const double ahead = gap(x[node]);
        if (is_behind_[i] && ahead >= 0.0) is_behind_[i] = 0;
        const double slowest = -ahead / dt;
        const double normal_rate = card_.normal.dot(v[node]);
        if (is_behind_[i] || normal_rate >= slowest) continue;

        const Vec3 slid = v[node] + (slowest - normal_rate) * card_.normal;
        const Vec3 after = rubbed(slid, slowest - normal_rate);
        stopping_energy_ += 0.5 * mass[node] * (v[node].squaredNorm() - slid.squaredNorm());
        friction_energy_ += 0.5 * mass[node] * (slid.squaredNorm() - after.squaredNorm());
        impulse += mass[node] * (v[node] - after);
        touching_.push_back(node);
        v[node] = after;
    }
    force_ = impulse / dt;
}

/// Velocity after friction, `stop` being the normal velocity that the wall took away.
Vec3 PlanarWall::rubbed(const Vec3& v, double stop) const {
    const Vec3 normal = card_.normal.dot(v) * card_.normal;
    const Vec3 sliding = v - normal;
    const double speed = sliding.norm();
    if (card_.friction == 1.0 || speed <= card_.friction * stop) return normal;
    return normal + (1.0 - card_.friction * stop / speed) * sliding;
}

void PlanarWall::note_nodes_behind(const Points& x) {
    is_behind_.clear();
    for (const Index node : card_.nodes) is_behind_.push_back(gap(x[node]) < 0.0);
}

std::vector<Index> PlanarWall::nodes_behind() const {
    std::vector<Index> behind;
    for (std::size_t i = 0; i < is_behind_.size(); ++i)
        if (is_behind_[i]) behind.push_back(card_.nodes[i]);
    return behind;
}

}  // namespace corpuscle::contact
