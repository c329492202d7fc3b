// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/candidates.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

/// The budget grows while lists are short and shrinks while they are long, between these numbers of
/// candidates a triangle: in open cloth a wide list costs nothing, in folded cloth every thickness
/// adds a layer.
constexpr std::size_t FEW = 2, MANY = 20;
constexpr double LEAST_BUDGET = 0.5;     ///< in contact thicknesses
constexpr double GREATEST_BUDGET = 0.2;  ///< in edge lengths: neighbours on the cloth would come in

constexpr double LEAST_LIFE = 2.0, GREATEST_LIFE = 100.0;  ///< of the lists, in steps
constexpr double MOST_STRAYED = 0.02;  ///< part of the nodes that is predicted anew by itself
constexpr double ADAPTATION = 1.25;  ///< by which budget and life change from one build to the next

/// Half the gap that matters, by triangle: the greatest of all cards that hold for it or for what it
/// has on a border.                                                                        [m]
std::vector<double> margins(const Cloth& cloth, double reach) {
    std::vector<double> margin(cloth.triangles.size(), 0.0);
    for (std::size_t c = 0; c < cloth.thickness.size(); ++c)
        for (std::size_t t = 0; t < margin.size(); ++t)
            if (cloth.rules.concerns(static_cast<int>(c), cloth.part[t]))
                margin[t] = std::max(margin[t], 0.5 * reach * cloth.thickness[c][t]);
    for (std::size_t t = 0; t < margin.size(); ++t)
        for (const Index n : cloth.triangles[t])
            if (cloth.rules.is_combined(cloth.node_part[n]))
                margin[t] = std::max(margin[t], 0.5 * reach * cloth.node_thickness[n]);
    return margin;
}

}  // namespace

Candidates::Candidates(const Cloth& cloth, double reach)
    : cloth_(cloth),
      reach_(reach),
      patches_(cloth, margins(cloth, reach)),
      motion_(cloth, patches_.pieces()),
      search_(cloth, margins(cloth, reach), patches_.pieces()),
      budget_{cloth.greatest_thickness},
      node_box_(cloth.inverse_mass.size()),
      own_(node_box_.size(), 0.0) {}

void Candidates::foresee(const Points& x, const Points& v, double t, double dt) {
    patches_.foresee(v, dt);
    motion_.foresee(x, v, dt);
    const bool is_over = !patches_.pieces().nodes.empty() && motion_.age() + dt > budget_.life;
    if (is_over || !patches_.holds(x)) return build(x, v, t, dt);
    if (motion_.stray() <= budget_.stray) return;
    motion_.list_strayed(budget_.stray, renewal_.strayed);
    if (static_cast<double>(renewal_.strayed.size()) >
        MOST_STRAYED * static_cast<double>(patches_.pieces().nodes.size()))
        return build(x, v, t, dt);
    renew(x);
    motion_.foresee(x, v, dt);
}

double Candidates::thickness(std::size_t i) {
    Candidate& c = list_[i];
    if (!c.is_settled) {
        c.thickness = std::min(c.thickness, neighbours_thickness(c.pair));
        c.is_settled = true;
        verlet_.reach[i] = static_cast<float>(reach_ * c.thickness);
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
    // Two panels lie on each other in the reference shape; along the cloth, round the seam, they
    // are farther apart
    const auto height = [&](int i) { return cloth_.star_height[n[i]]; };
    const double along =
        pair.is_edges ? std::max(std::min(height(0), height(1)), std::min(height(2), height(3)))
                      : height(0);
    return 0.5 * std::max({along, nearest(pair, cloth_.reference_x).apart.norm(),
                           nearest(pair, cloth_.x0).apart.norm()});
}

PairMemory& Candidates::make_memory(std::size_t i) {
    if (list_[i].memory < 0) {
        list_[i].memory = static_cast<Index>(memories_.size());
        memories_.push_back({list_[i].key});
    }
    return memories_[list_[i].memory];
}

/// Budget and life of the next lists, from how the last ones ended.
void Candidates::set_budget(double dt) {
    if (builds_ > 0) {
        if (list_.size() < FEW * cloth_.triangles.size()) budget_.stray *= ADAPTATION;
        if (list_.size() > MANY * cloth_.triangles.size()) budget_.stray /= ADAPTATION;
        const bool is_worth_it =
            motion_.age() + dt > budget_.life && list_.size() <= MANY * cloth_.triangles.size();
        budget_.steps *= is_worth_it ? ADAPTATION : 1.0 / ADAPTATION;
    }
    const double least = LEAST_BUDGET * cloth_.greatest_thickness;
    budget_.stray =
        std::clamp(budget_.stray, least, std::max(least, GREATEST_BUDGET * cloth_.mean_edge));
    budget_.steps = std::clamp(budget_.steps, LEAST_LIFE, GREATEST_LIFE);
}

}  // namespace corpuscle::contact
