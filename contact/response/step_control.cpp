// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

/// What a stopped pair takes from the step: times the part that it is of the contacts that touch,
/// below FEW of so many; in a step at most.
constexpr double LOSS = 50.0, MOST_LOST = 0.05;
constexpr std::size_t FEW = 20'000;

/// Gain of the step in a step, after so many steps without a stopped pair.
constexpr double GAIN = 0.001;
constexpr std::uint64_t HOLD = 500;

/// Over the step taken: where a limit no longer says anything.
constexpr double FORGOTTEN = 4.0;

/// Steps for which a pair counts that is stopped again and again; steps after which it is new.
constexpr std::uint64_t PATIENCE = 300, PAUSE = 2000;

}  // namespace

/// Pairs of `stopped` that have not been stopped for long.
std::size_t StepControl::count_new(std::vector<Nodes>& stopped) {
    if (stopped.empty()) return 0;
    std::sort(stopped.begin(), stopped.end());
    stopped.erase(std::unique(stopped.begin(), stopped.end()), stopped.end());
    std::erase_if(held_, [&](const Held& pair) { return pair.last + PAUSE < step_; });
    std::vector<Held> all;
    all.reserve(held_.size() + stopped.size());
    std::size_t count = 0;
    auto old = held_.begin();
    for (const Nodes& nodes : stopped) {
        while (old != held_.end() && old->nodes < nodes) all.push_back(*old++);
        const bool is_known = old != held_.end() && old->nodes == nodes;
        all.push_back({nodes, is_known ? old->since : step_, step_});
        if (is_known) ++old;
        count += step_ - all.back().since <= PATIENCE;
    }
    all.insert(all.end(), old, held_.end());
    held_.swap(all);
    return count;
}

void StepControl::follow(double dt, std::vector<Nodes>& stopped, std::size_t touching, int card) {
    ++step_;
    if (stopped.empty() && longest_ == INF) return;
    const std::size_t count = count_new(stopped);
    if (count > 0) {
        const double part =
            static_cast<double>(count) / static_cast<double>(std::max(touching, FEW));
        longest_ = std::min(longest_, dt) * std::exp(-std::min(LOSS * part, MOST_LOST));
        card_ = card;
        lost_at_ = step_;
    } else if (step_ > lost_at_ + HOLD) {
        longest_ *= std::exp(GAIN);
    }
    if (longest_ > FORGOTTEN * dt) longest_ = INF;
}

}  // namespace corpuscle::contact
