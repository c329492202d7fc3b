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
    const auto step = [&](std::size_t i) {
        const Index n = pieces_.nodes[i];
        node_stepped_[n] = (x[n] - last_[n] - common - since * velocity_[n]).norm();
        last_[n] = x[n];
    };
    const auto displace = [&](std::size_t i) {
        const Index triangle = pieces_.triangles[i];
        const Triangle& nodes = cloth_.triangles[triangle];
        displacement_[triangle] += greatest(node_stepped_, nodes);
        displacement_bound_[triangle] =
            displacement_[triangle] + dt * greatest(node_deviation_, nodes);
    };
    parallel::in_turn(parallel::each(pieces_.nodes.size(), step),
                      parallel::each(pieces_.triangles.size(), displace));
}

void Motion::foresee(const Points& x, const Points& v, double dt) {
    stray_ = 0.0;
    if (pieces_.nodes.empty()) return;
    const Vec3 common = mean_over(pieces_.nodes, [&](Index n) -> Vec3 { return v[n]; });
    const Vec3 moved = common_ + dt * common;
    std::vector<double>& strays = chunk_stray_;
    const std::size_t count = pieces_.nodes.size();
    strays.assign(std::max<std::size_t>(1, parallel::chunk_count(count)), 0.0);
    const auto stray = [&](std::size_t i) {
        const Index n = pieces_.nodes[i];
        relative_[n] = v[n] - common;
        node_speed_[n] = relative_[n].norm();
        node_deviation_[n] = (relative_[n] - velocity_[n]).norm();
        const Vec3 predicted = base_[n] + moved + (age_ + dt) * velocity_[n];
        strays_[n] = (x[n] + dt * v[n] - predicted).norm();
        double& most = strays[i / parallel::CHUNK];
        most = std::max(most, strays_[n] / slack_[n]);
    };
    const auto bound = [&](std::size_t i) {
        const Index triangle = pieces_.triangles[i];
        displacement_bound_[triangle] =
            displacement_[triangle] + dt * greatest(node_speed_, cloth_.triangles[triangle]);
    };
    parallel::in_turn(parallel::each(count, stray),
                      parallel::each(pieces_.triangles.size(), bound));
    stray_ = *std::max_element(strays.begin(), strays.end());
}

double Motion::fastest() const {
    const auto& nodes = pieces_.nodes;
    return std::sqrt(parallel::fold(
        nodes.size(), 0.0,
        [&](double& most, std::size_t i) {
            most = std::max(most, velocity_[nodes[i]].squaredNorm());
        },
        [](double& all, double most) { all = std::max(all, most); }));
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
    parallel::for_each(pieces_.nodes.size(), [&](std::size_t i) {
        const Index n = pieces_.nodes[i];
        slack_[n] = strays_[n] > USED * budget * slack_[n]
                        ? std::min(MOST_SLACK, MORE_SLACK * slack_[n])
                        : std::max(1.0, LESS_SLACK * slack_[n]);
        base_[n] = last_[n] = x[n];
        velocity_[n] = relative_[n] = v[n] - common;
    });
    std::fill(strays_.begin(), strays_.end(), 0.0);
    common_.setZero();
    age_ = age_ahead_ = stray_ = 0.0;
}

}  // namespace corpuscle::contact
