// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/energy/growth_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle {

Index GrowthMonitor::zigzag(const Points& f, const std::vector<double>& mass, double span) {
    const auto found = parallel::least(nodes_.size(), 0.0, [&](std::size_t i) {
        const Index n = nodes_[i];
        const Vec3 kick = span / mass[n] * f[n];
        const Vec3 change = kick - kick_[n];
        const double now = change.squaredNorm();
        Trace& trace = trace_[n];
        if (change.dot(change_[n]) < 0.0 && now > change_[n].squaredNorm()) {
            if (trace.turns++ == 0) trace.first = now;
        } else {
            trace.turns = 0;
        }
        kick_[n] = kick;
        change_[n] = change;
        // A place that swings by ±X from step to step changes its kick by 8 X / span at the limit
        const double swing = 0.125 * span * std::sqrt(now);
        const bool is_unstable =
            trace.turns >= TURNS && now > GROWN * GROWN * trace.first && swing > SWING * size_[n];
        return is_unstable ? -1.0 : 0.0;
    });
    return found.value < 0.0 ? nodes_[found.at] : -1;
}

bool GrowthMonitor::gains(const Instant& now, const std::vector<double>& mass, const Points& v_0,
                          const Points& v_1) {
    if (nodes_.empty()) return false;  // all held: what it has was given to it
    using Sums = Eigen::Matrix<double, 5, 1>;
    // before the kick, of both, after, of the fabric's own kick, of that and before
    const Sums kinetic = parallel::sum(nodes_.size(), Sums(Sums::Zero()), [&](std::size_t i) {
        const Index n = nodes_[i];
        const Vec3 &a = v_0[n], &b = v_1[n], &k = kick_[n];
        return Sums(0.5 * mass[n] *
                    Sums{a.squaredNorm(), a.dot(b), b.squaredNorm(), k.squaredNorm(), k.dot(a)});
    });
    if (!is_open_) {
        // The start's velocities live at t and its kick k is half of one: as if v_0 - k came before
        start_ = 2.0 * kinetic[1] - kinetic[2] + now.strain;
        given_ = 2.0 * (kinetic[2] - kinetic[1]) - 2.0 * now.inner_work + now.inner_early;
        scale_ = kinetic[0] + now.strain;
        kinetic_ = kinetic[2];
        open_ = scale_;
        is_open_ = true;
        return false;
    }
    given_ += kinetic[0] - kinetic_;  // by walls and touching fabric since the last kick
    kinetic_ = kinetic[2];
    // what moves as it is told has given half of its work in this kick already
    const double by_driven = kinetic[4] - 0.5 * now.inner_early;
    scale_ = std::max(scale_, open_ + std::max({0.0, given_, given_ + by_driven}));
    gained_ = kinetic[0] + 0.5 * now.inner_early + now.strain - start_ - given_;
    given_ += kinetic[2] - kinetic[0] - now.inner_work;
    const double swing = 0.25 * kinetic[3];
    const bool is_grown = gained_ > MOST * scale_;
    spurious_ = is_grown ? gained_ : gained_ + swing;
    return is_grown || spurious_ > MOST_WITH_SWING * scale_;
}

Index GrowthMonitor::most_kicked(const std::vector<double>& mass) const {
    const auto most = parallel::least(nodes_.size(), 0.0, [&](std::size_t i) {
        return -mass[nodes_[i]] * kick_[nodes_[i]].squaredNorm();
    });
    return nodes_[std::min(most.at, nodes_.size() - 1)];
}

}  // namespace corpuscle
