// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr double STEPS = 100.0;  ///< greatest life of the lists
constexpr double SWEEP = 0.5;    ///< farthest that a patch may sweep in that time, in edge lengths
constexpr double LIVES = 2.0;    ///< steps like the one ahead for which any budget is enough

/// The common budget grows while lists are short and shrinks while they are long, between these
/// numbers of candidates a triangle: in open cloth a wide list costs nothing, in folded cloth every
/// thickness adds a layer.
constexpr std::size_t FEW = 2, MANY = 10;
constexpr double ADAPTATION = 1.3;
constexpr double LEAST = 1.0;  ///< common budget, in contact thicknesses
constexpr double GREATEST =
    0.2;  ///< likewise, in edge lengths: neighbours on the cloth would come in

}  // namespace

Candidates::Candidates(const Cloth& cloth, double reach)
    : cloth_(cloth),
      reach_(reach),
      motion_(cloth),
      near_triangles_(cloth.patches),
      most_budget_(4.0 * cloth.greatest_thickness),
      budget_(cloth.patches.size()),
      growth_(cloth.patches.size()),
      boxes_(cloth.triangles.size()) {}

void Candidates::foresee(const Points& x, const Points& v, double t, double dt) {
    motion_.foresee(x, v, dt);
    if (are_spent(dt)) build(x, v, t, dt);
}

/// Whether the lists might miss a pair in the step ahead.
bool Candidates::are_spent(double dt) const {
    if (motion_.age() + dt > life_) return true;
    for (std::size_t p = 0; p < budget_.size(); ++p)
        if (motion_.stray(static_cast<Index>(p)) > budget_[p]) return true;
    return false;
}

bool Candidates::may_meet(std::size_t i) const {
    const double distance = least_distance(i);
    const Watch& w = watch_[i];
    if (distance > motion_.ahead(w.first) + motion_.ahead(w.second)) return false;
    std::array<double, 4> ahead;
    for (int k = 0; k < 4; ++k) ahead[k] = motion_.node_ahead(list_[i].pair.node[k]);
    const double motion = list_[i].pair.is_edges
                              ? std::max(ahead[0], ahead[1]) + std::max(ahead[2], ahead[3])
                              : ahead[0] + std::max({ahead[1], ahead[2], ahead[3]});
    return distance <= motion;
}

double Candidates::thickness(std::size_t i) {
    Candidate& c = list_[i];
    if (!c.is_settled) {
        c.thickness = std::min(c.thickness, neighbours_thickness(c.pair));
        c.is_settled = true;
    }
    return c.thickness;
}

/// Neighbours on the cloth are as near as the mesh is fine: they push below half that distance
/// only.
double Candidates::neighbours_thickness(const Pair& pair) const {
    const auto& n = pair.node;
    const auto are_beside = [&](int i, int j) { return cloth_.are_beside(n[i], n[j]); };
    const bool is_neighbour =
        pair.is_edges ? are_beside(0, 2) || are_beside(0, 3) || are_beside(1, 2) || are_beside(1, 3)
                      : are_beside(0, 1) || are_beside(0, 2) || are_beside(0, 3);
    if (!is_neighbour) return INF;
    return 0.5 * std::max(nearest(pair, cloth_.reference_x).apart.norm(),
                          nearest(pair, cloth_.x0).apart.norm());
}

PairMemory& Candidates::make_memory(std::size_t i) {
    if (list_[i].memory < 0) {
        list_[i].memory = static_cast<Index>(memories_.size());
        memories_.push_back({list_[i].key});
    }
    return memories_[list_[i].memory];
}

/// Sweeps and budgets for the time ahead.
void Candidates::set_budgets(double dt) {
    const double h = cloth_.greatest_thickness;
    if (builds_ > 0 && list_.size() < FEW * cloth_.triangles.size()) most_budget_ *= ADAPTATION;
    if (list_.size() > MANY * cloth_.triangles.size()) most_budget_ /= ADAPTATION;
    most_budget_ =
        std::clamp(most_budget_, LEAST * h, std::max(LEAST * h, GREATEST * cloth_.mean_edge));

    double fastest = 0.0;
    for (std::size_t p = 0; p < budget_.size(); ++p)
        fastest = std::max(fastest, motion_.velocity(static_cast<Index>(p)).norm());
    life_ = STEPS * dt;
    if (fastest * life_ > SWEEP * cloth_.mean_edge) life_ = SWEEP * cloth_.mean_edge / fastest;
    life_ = std::max(life_, LIVES * dt);

    for (std::size_t p = 0; p < budget_.size(); ++p) {
        const auto patch = static_cast<Index>(p);
        budget_[p] = std::max(most_budget_, LIVES * motion_.stray(patch));
        // two boxes overlap where a gap may come within reach
        const Vec3 sweep = life_ * motion_.velocity(patch);
        const Vec3 margin = Vec3::Constant(0.5 * reach_ * h + budget_[p]);
        growth_[p] = {sweep.cwiseMin(0.0) - margin, sweep.cwiseMax(0.0) + margin};
    }
}

}  // namespace corpuscle::contact
