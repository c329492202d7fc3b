// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/motion.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {
constexpr std::size_t CHUNK = 16;  ///< patches
}

Motion::Motion(const Cloth& cloth)
    : cloth_(cloth),
      nodes_(cloth.patch_node),
      way_(cloth.patches.size()),
      step_(way_.size()),
      stray_(way_.size()),
      stray_step_(way_.size()),
      velocity_(way_.size(), Vec3::Zero()),
      mean_step_(way_.size()) {
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

/// Sets common_step_, and step_ and mean_step_ of each patch.
template <class Displacement>
void Motion::measure_step(Displacement&& of) {
    const auto displacement = [&](std::size_t i) -> Vec3 { return of(nodes_[i]); };
    common_step_ = parallel::sum(nodes_.size(), Vec3(Vec3::Zero()), displacement) /
                   static_cast<double>(nodes_.size());
    const auto measure = [&](std::size_t p) {
        double farthest = 0.0;
        Vec3 sum = Vec3::Zero();
        for (const Index node : cloth_.nodes_of_patch(p)) {
            const Vec3 moved = of(node) - common_step_;
            sum += moved;
            farthest = std::max(farthest, moved.squaredNorm());
        }
        step_[p] = std::sqrt(farthest);
        mean_step_[p] = sum / static_cast<double>(cloth_.nodes_of_patch(p).size());
    };
    parallel::for_each(step_.size(), measure, CHUNK);
}

void Motion::start(const Points& x, const Points& v, double t, double dt) {
    last_ = x;
    base_ = x;
    t_ = t;
    dt_ = dt;
    measure_step([&](Index node) -> Vec3 { return dt * v[node]; });
    restart();
}

void Motion::follow(const Points& x, double t) {
    dt_ = t - t_;
    t_ = t;
    age_ += dt_;
    measure_step([&](Index node) -> Vec3 { return x[node] - last_[node]; });
    common_ += common_step_;
    const auto compare = [&](std::size_t p) {
        way_[p] += step_[p];
        double farthest = 0.0, farthest_step = 0.0;
        const Vec3 predicted = common_ + age_ * velocity_[p];
        const Vec3 predicted_step = common_step_ + dt_ * velocity_[p];
        for (const Index node : cloth_.nodes_of_patch(p)) {
            farthest = std::max(farthest, (x[node] - base_[node] - predicted).squaredNorm());
            farthest_step =
                std::max(farthest_step, (x[node] - last_[node] - predicted_step).squaredNorm());
        }
        stray_[p] = std::sqrt(farthest);
        stray_step_[p] = std::sqrt(farthest_step);
    };
    parallel::for_each(way_.size(), compare, CHUNK);
    for (const Index node : nodes_) last_[node] = x[node];
}

void Motion::restart() {
    for (const Index node : nodes_) base_[node] = last_[node];
    common_.setZero();
    age_ = 0.0;
    for (std::size_t p = 0; p < velocity_.size(); ++p)
        velocity_[p] = dt_ > 0.0 ? Vec3(mean_step_[p] / dt_) : Vec3(Vec3::Zero());
    std::fill(stray_.begin(), stray_.end(), 0.0);
}

}  // namespace corpuscle::contact
