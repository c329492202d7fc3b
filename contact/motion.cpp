// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/motion.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

Motion::Motion(const Cloth& cloth)
    : cloth_(cloth),
      nodes_(cloth.patch_node),
      way_(cloth.patches.size()),
      step_(cloth.patches.size()) {
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

template <class Displacement>
void Motion::measure(Displacement&& of) {
    const Vec3 common = parallel::sum(nodes_.size(), Vec3(Vec3::Zero()),
                                      [&](std::size_t i) { return of(nodes_[i]); }) /
                        static_cast<double>(nodes_.size());
    parallel::for_each(
        step_.size(),
        [&](std::size_t p) {
            double farthest = 0.0;
            for (Index i = cloth_.patch_node_start[p]; i < cloth_.patch_node_start[p + 1]; ++i)
                farthest = std::max(farthest, (of(cloth_.patch_node[i]) - common).squaredNorm());
            step_[p] = std::sqrt(farthest);
        },
        16);
}

void Motion::start(const Points& x, const Points& v, double dt) {
    last_ = x;
    std::fill(way_.begin(), way_.end(), 0.0);
    measure([&](Index node) -> Vec3 { return dt * v[node]; });
}

void Motion::follow(const Points& x) {
    measure([&](Index node) -> Vec3 { return x[node] - last_[node]; });
    for (std::size_t p = 0; p < way_.size(); ++p) way_[p] += step_[p];
    for (const Index node : nodes_) last_[node] = x[node];
}

}  // namespace corpuscle::contact
