// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/loading_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace corpuscle::fabric {

namespace {

/// Between two knots of the curves ρ is no straight line: so many are laid through it.
constexpr int PIECES = 4;
constexpr double ROUNDING = 1e-9;

/// 0, the knots of both curves up to `end`, and places between.
std::vector<double> places(const StressCurve& load, const Curve& unload, double end) {
    std::vector<double> knots{0.0, end};
    for (const auto& all : {load.strains(), unload.x})
        for (const double e : all)
            if (e > 0.0 && e < end) knots.push_back(e);
    std::sort(knots.begin(), knots.end());
    std::vector<double> out{0.0};
    for (std::size_t i = 1; i < knots.size(); ++i)
        for (int k = 1; k <= PIECES && knots[i] > knots[i - 1] * (1.0 + ROUNDING); ++k)
            out.push_back(knots[i - 1] + (knots[i] - knots[i - 1]) * k / PIECES);
    return out;
}

}  // namespace

LoadingLoop::LoadingLoop(StressCurve load, const Curve& unload, double reload)
    : load_(std::move(load)), meets_(crossing(unload)), reload_(reload) {
    const std::vector<double> at = places(load_, unload, meets_);
    std::vector<double> share(at.size(), 1.0);
    const double at_end = unload(meets_) / load_.at(meets_).stress;  // 1 where they meet
    for (std::size_t i = at.size() - 1; i-- > 0;) {
        const double on = load_.at(at[i]).stress;
        // At 0, and where loading is slack, the share is that of the next place
        share[i] = on > 0.0 ? unload(at[i]) / on / at_end : share[i + 1];
        if (on > 0.0) is_above_ |= share[i] > 1.0 + ROUNDING;
    }
    share_at_0_ = share.front();
    Curve shape;
    for (std::size_t i = 0; i < at.size(); ++i) {
        shape.x.push_back(at[i] / meets_);
        shape.y.push_back(share[i] - share_at_0_);
    }
    share_.emplace(shape, Below::STRAIGHT);
}

/// The greatest strain where U crosses L from below, or U's end.
double LoadingLoop::crossing(const Curve& unload) const {
    std::vector<double> knots;
    for (const double e : load_.strains())
        if (e > 0.0 && e < unload.x.back()) knots.push_back(e);
    for (const double e : unload.x)
        if (e > 0.0) knots.push_back(e);
    std::sort(knots.begin(), knots.end());
    const auto above = [&](double e) { return unload(e) - load_.at(e).stress; };
    double before = 0.0, meets = unload.x.back();
    for (const double e : knots) {
        const double low = above(before), high = above(e);
        if (low < 0.0 && high >= 0.0) meets = before + (e - before) * low / (low - high);
        before = e;
    }
    return meets;
}

LoadingLoop::Answer LoadingLoop::move(double strain, LoopMemory& memory) const {
    if (!share_ || !std::isfinite(strain)) {
        const StressCurve::Point on = load_.at(strain);
        return {on.stress, on.energy, 0.0};
    }
    double lost = 0.0;
    if (!memory.unloading && strain < memory.strain && memory.most > 0.0) {
        memory.unloading = true;
        memory.back = memory.most;
        const double comes_back = work(0.0, memory.most, memory);
        lost = memory.stored - comes_back;
        memory.stored = comes_back;
    }
    const double down = std::max(0.0, strain);
    if (memory.unloading && down < memory.back) {
        // Down to e_r along the way that led here, on along that of unloading
        memory.stored += work(std::max(0.0, memory.strain), memory.back, memory);
        const double left = memory.back;
        memory.back = down;
        memory.stored += work(left, down, {memory.most, memory.most, 0.0, 0.0, true});
    } else if (memory.unloading) {
        const double up = std::min(down, memory.most);
        memory.stored += work(std::max(0.0, memory.strain), up, memory);
    }
    if (strain >= memory.most) {
        memory.stored += load_.at(strain).energy - load_.at(memory.most).energy;
        memory.unloading = false;
        memory.most = memory.back = strain;
    }
    memory.strain = strain;
    const StressCurve::Point on = load_.at(std::min(strain, 0.0));
    const double stress = strain <= 0.0 ? on.stress : path(strain, memory);
    return {stress, memory.stored + on.energy, lost};
}

/// Stress at a strain from 0 to e_m.
double LoadingLoop::path(double strain, const LoopMemory& at) const {
    const double on = load_.at(strain).stress;
    if (!at.unloading) return on;
    const auto unloaded = [&](double e, double stress) {
        return stress * (share_at_0_ + share_->at(e / at.most).stress);
    };
    const double low = unloaded(strain, on);
    if (reload_ == 0.0 || strain <= at.back || at.back >= at.most) return low;
    const double from = unloaded(at.back, load_.at(at.back).stress);
    const double chord =
        from + (load_.at(at.most).stress - from) * (strain - at.back) / (at.most - at.back);
    return low + reload_ * std::max(0.0, chord - low);
}

/// ∫ path from one strain to another: between knots it is a parabola, which Simpson's rule meets.
double LoadingLoop::work(double from, double to, const LoopMemory& at) const {
    if (from > to) return -work(to, from, at);
    const auto knot_after = [](const StressCurve& curve, double e) {
        const auto& knots = curve.strains();
        const auto next = std::upper_bound(knots.begin(), knots.end(), e);
        return next == knots.end() ? INF : *next;
    };
    double sum = 0.0;
    for (double e = from; e < to;) {
        double end =
            std::min({to, knot_after(load_, e), knot_after(*share_, e / at.most) * at.most});
        if (end <= e) end = std::min(to, std::nextafter(e, INF));
        sum += (end - e) / 6.0 * (path(e, at) + 4.0 * path(0.5 * (e + end), at) + path(end, at));
        e = end;
    }
    return sum;
}

double LoadingLoop::steepest() const {
    const double load = load_.steepest();
    if (!share_) return load;
    const auto& knots = share_->strains();
    double most = 1.0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (const double at : {knots[i], knots[i + 1]})
            if (at >= 0.0 && knots[i + 1] > 0.0)
                most = std::max(most, share_at_0_ + share_->at(at).stress +
                                          at * std::max(0.0, share_->slope(i)));
    return load * most;
}

/// Going on from e_m to e_m + d and back to any e loses d ∫ L ρ' ξ de/e_m from e to e_m.
bool LoadingLoop::loops_lose(double most) const {
    constexpr int STEPS = 400;
    double sum = 0.0, slack = 0.0;  // slack: of rounding
    for (int i = STEPS; i-- > 0;) {
        const double low = double(i) / STEPS, high = double(i + 1) / STEPS,
                     mid = 0.5 * (low + high);
        const double rise = share_->at(high).stress - share_->at(low).stress;
        const double all = load_.at(mid * most).stress * mid;
        sum += all * rise;
        slack += std::abs(all) * (1e-6 * std::abs(rise) + 1e-12);
        if (sum < -slack) return false;
    }
    return true;
}

std::string LoadingLoop::fault() const {
    if (!share_) return {};
    if (is_above_) return "a curve that nowhere exceeds that of loading before they meet";
    constexpr int STEPS = 60;
    const double end = 2.0 * std::max(meets_, load_.strains().back());
    for (int i = 1; i <= STEPS; ++i) {
        const double most = end * i / STEPS;
        if (!loops_lose(most))
            return fmt::format("a curve along which a loop to a strain of {:.3g} gives no energy",
                               most);
    }
    return {};
}

}  // namespace corpuscle::fabric
