// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/motion.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

/// A few nodes that flutter would end the lists of all: they get a slack of their own, up to MOST,
/// which grows while they use more than USED of it and shrinks else.
constexpr double MOST_SLACK = 32.0, USED = 0.5, MORE_SLACK = 2.0, LESS_SLACK = 0.8;

double greatest(const std::vector<double>& of, const Triangle& t) {
    return std::max({of[t[0]], of[t[1]], of[t[2]]});
}

template <class Value>
Vec3 mean_over(const std::vector<Index>& nodes, Value&& value) {
    const auto term = [&](std::size_t i) -> Vec3 { return value(nodes[i]); };
    return parallel::sum(nodes.size(), Vec3(Vec3::Zero()), term) /
           static_cast<double>(std::max<std::size_t>(1, nodes.size()));
}

}  // namespace

Motion::Motion(const Cloth& cloth, const Pieces& pieces)
    : cloth_(cloth),
      pieces_(pieces),
      velocity_(cloth.inverse_mass.size(), Vec3::Zero()),
      relative_(velocity_),
      displacement_(cloth.triangles.size(), 0.0),
      displacement_bound_(displacement_.size()),
      node_stepped_(velocity_.size(), 0.0),
      node_speed_(velocity_.size(), 0.0),
      node_deviation_(velocity_.size(), 0.0),
      slack_(velocity_.size(), 1.0),
      strays_(velocity_.size(), 0.0) {}

void Motion::start(const Points& x, double t) {
    base_ = last_ = x;
    t_ = t;
}

void Motion::follow(const Points& x, double t, double dt) {
    const double since = t - t_;
    age_ += since;
    age_ahead_ = age_ + dt;
    t_ = t;
    if (pieces_.nodes.empty()) return;
    const Vec3 common = mean_over(pieces_.nodes, [&](Index n) -> Vec3 { return x[n] - last_[n]; });
    common_ += common;
    parallel::for_each(pieces_.nodes.size(), [&](std::size_t i) {
        const Index n = pieces_.nodes[i];
        node_stepped_[n] = (x[n] - last_[n] - common - since * velocity_[n]).norm();
        last_[n] = x[n];
    });
    parallel::for_each(pieces_.triangles.size(), [&](std::size_t i) {
        const Index triangle = pieces_.triangles[i];
        const Triangle& nodes = cloth_.triangles[triangle];
        displacement_[triangle] += greatest(node_stepped_, nodes);
        displacement_bound_[triangle] =
            displacement_[triangle] + dt * greatest(node_deviation_, nodes);
    });
}

void Motion::foresee(const Points& x, const Points& v, double dt) {
    stray_ = 0.0;
    if (pieces_.nodes.empty()) return;
    const Vec3 common = mean_over(pieces_.nodes, [&](Index n) -> Vec3 { return v[n]; });
    const Vec3 moved = common_ + dt * common;
    std::vector<double>& strays = chunk_stray_;
    strays.assign(std::max<std::size_t>(1, parallel::chunk_count(pieces_.nodes.size())), 0.0);
    parallel::for_chunks(
        pieces_.nodes.size(), [&](std::size_t begin, std::size_t end, std::size_t c) {
            for (std::size_t i = begin; i < end; ++i) {
                const Index n = pieces_.nodes[i];
                relative_[n] = v[n] - common;
                node_speed_[n] = relative_[n].norm();
                node_deviation_[n] = (relative_[n] - velocity_[n]).norm();
                const Vec3 predicted = base_[n] + moved + (age_ + dt) * velocity_[n];
                strays_[n] = (x[n] + dt * v[n] - predicted).norm();
                strays[c] = std::max(strays[c], strays_[n] / slack_[n]);
            }
        });
    stray_ = *std::max_element(strays.begin(), strays.end());
    parallel::for_each(pieces_.triangles.size(), [&](std::size_t i) {
        const Index triangle = pieces_.triangles[i];
        displacement_bound_[triangle] =
            displacement_[triangle] + dt * greatest(node_speed_, cloth_.triangles[triangle]);
    });
}

double Motion::fastest() const {
    double square = 0.0;
    for (const Index n : pieces_.nodes) square = std::max(square, velocity_[n].squaredNorm());
    return std::sqrt(square);
}

void Motion::list_strayed(double budget, std::vector<Index>& out) const {
    out.clear();
    for (const Index n : pieces_.nodes)
        if (strays_[n] > budget * slack_[n]) out.push_back(n);
}

void Motion::renew(std::span<const Index> nodes, const Points& x) {
    for (const Index n : nodes) {
        slack_[n] = std::min(MOST_SLACK, MORE_SLACK * slack_[n]);
        velocity_[n] = relative_[n];
        base_[n] = x[n] - common_ - age_ * velocity_[n];
    }
}

void Motion::restart(const Points& x, const Points& v, double budget) {
    const Vec3 common = mean_over(pieces_.nodes, [&](Index n) -> Vec3 { return v[n]; });
    for (const Index n : pieces_.nodes) {
        slack_[n] = strays_[n] > USED * budget * slack_[n]
                        ? std::min(MOST_SLACK, MORE_SLACK * slack_[n])
                        : std::max(1.0, LESS_SLACK * slack_[n]);
        base_[n] = last_[n] = x[n];
        velocity_[n] = relative_[n] = v[n] - common;
    }
    std::fill(strays_.begin(), strays_.end(), 0.0);
    common_.setZero();
    age_ = age_ahead_ = stray_ = 0.0;
}

}  // namespace corpuscle::contact
