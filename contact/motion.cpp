// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/motion.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t CHUNK = 16;  ///< patches

template <class Value>
Vec3 mean_over(const std::vector<Index>& nodes, Value&& value) {
    const auto term = [&](std::size_t i) -> Vec3 { return value(nodes[i]); };
    return parallel::sum(nodes.size(), Vec3(Vec3::Zero()), term) /
           static_cast<double>(nodes.size());
}

}  // namespace

Motion::Motion(const Cloth& cloth)
    : cloth_(cloth),
      nodes_(cloth.patch_node),
      way_(cloth.patches.size(), 0.0),
      ahead_(way_.size()),
      stray_(way_.size()),
      node_ahead_(cloth.inverse_mass.size(), 0.0),
      velocity_(way_.size(), Vec3::Zero()),
      mean_(way_.size()) {
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

void Motion::start(const Points& x, double t) {
    base_ = last_ = x;
    t_ = t;
}

void Motion::follow(const Points& x, double t) {
    age_ += t - t_;
    t_ = t;
    const Vec3 common = mean_over(nodes_, [&](Index n) -> Vec3 { return x[n] - last_[n]; });
    common_ += common;
    const auto measure = [&](std::size_t p) {
        double farthest = 0.0;
        for (const Index n : cloth_.nodes_of_patch(p))
            farthest = std::max(farthest, (x[n] - last_[n] - common).squaredNorm());
        way_[p] += std::sqrt(farthest);
    };
    parallel::for_each(way_.size(), measure, CHUNK);
    for (const Index n : nodes_) last_[n] = x[n];
}

void Motion::foresee(const Points& x, const Points& v, double dt) {
    const Vec3 common = mean_over(nodes_, [&](Index n) -> Vec3 { return v[n]; });
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        node_ahead_[nodes_[i]] = dt * (v[nodes_[i]] - common).norm();
    });
    const auto measure = [&](std::size_t p) {
        const Vec3 predicted = common_ + dt * common + (age_ + dt) * velocity_[p];
        double farthest = 0.0, stray = 0.0;
        Vec3 sum = Vec3::Zero();
        for (const Index n : cloth_.nodes_of_patch(p)) {
            farthest = std::max(farthest, node_ahead_[n]);
            stray = std::max(stray, (x[n] + dt * v[n] - base_[n] - predicted).squaredNorm());
            sum += v[n] - common;
        }
        ahead_[p] = farthest;
        stray_[p] = std::sqrt(stray);
        mean_[p] = sum / static_cast<double>(cloth_.nodes_of_patch(p).size());
    };
    parallel::for_each(way_.size(), measure, CHUNK);
}

void Motion::restart(const Points& x) {
    for (const Index n : nodes_) base_[n] = x[n];
    common_.setZero();
    age_ = 0.0;
    velocity_ = mean_;
}

}  // namespace corpuscle::contact
