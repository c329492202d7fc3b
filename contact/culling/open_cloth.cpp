// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/open_cloth.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t CHUNK = 1;  ///< patches
/// What does not hold for so many steps is looked at anew if its patch is; it is not left out, and
/// its chart is turned.
constexpr double LEAST = 12.0, SOON = 2.0;
constexpr double SPARE = 0.04;     ///< in edge lengths: way left to what is left out
constexpr std::uint8_t PAUSE = 4;  ///< calls after one in which nothing of a chart lay open

}  // namespace

OpenCloth::OpenCloth(const Cloth& cloth, std::span<const double> margin)
    : charts_(cloth, margin),
      limits_(charts_),
      least_limit_(charts_.size(), INF),
      used_(charts_.size(), 0),
      pause_(charts_.size(), 0),
      spare_(SPARE * cloth.mean_edge) {}

/// Looks at these patches in all charts that want them.
void OpenCloth::look_at_patches(std::span<const Index> patches,
                                const std::vector<std::uint64_t>& wanted, const Points& x,
                                PatchMotion& motion) {
    const auto look_at_one = [&](std::size_t i) {
        const Index r = patches[i];
        motion.mark_shape(r, x);
        const Lookahead ahead{LEAST, spare_};
        SheetLimits::Edges edges(charts_.blocks(r), x);
        for (const Charts::Place& at : charts_.places(r))
            if (wanted[at.chart] >> at.sheet & 1U && limits_.is_short(at.row, r, ahead, motion))
                limits_.look(r, at, motion.gone(r).flutter + ahead.of(r, motion), edges, motion);
    };
    parallel::for_each(patches.size(), look_at_one, CHUNK);
}

double OpenCloth::spare(Index p, Index q, const Points& x) const {
    const auto [c, cover] = charts_.link(p, q);
    return c < 0 ? INF : limits_.spare(c, cover, x);
}

double OpenCloth::known_spare(Index p, Index q, const PatchMotion& motion) const {
    const auto [c, cover] = charts_.link(p, q);
    double least = INF;
    for_each_bit(cover, [&](std::size_t s) {
        const Charts::Sheet& sheet = charts_[c].sheets[s];
        least = std::min(least, limits_[sheet.row] - motion.gone(sheet.patch).flutter);
    });
    return least;
}

void OpenCloth::find_least_limit(Index patch) {
    double least = INF;
    for (const Charts::Place& at : charts_.places(patch))
        if (used_[at.chart] >> at.sheet & 1U) least = std::min(least, limits_[at.row]);
    least_limit_[patch] = least;
}

void OpenCloth::drop_open(const Points& x, PatchMotion& motion,
                          std::vector<std::pair<Index, Index>>& pairs) {
    wanted_.assign(charts_.size(), 0);
    for (const auto& [p, q] : pairs) {
        const auto [chart, cover] = charts_.link(p, q);
        if (chart >= 0 && pause_[chart] == 0) wanted_[chart] |= cover;
    }
    for (std::uint8_t& pause : pause_)
        if (pause > 0) --pause;
    look_at_charts(x, motion);

    used_.assign(charts_.size(), 0);
    std::vector<std::uint64_t> missing(charts_.size());
    for (std::size_t c = 0; c < missing.size(); ++c)
        missing[c] = ~wanted_[c] |
                     limits_.short_of(static_cast<Index>(c), wanted_[c], {SOON, spare_}, motion);
    std::erase_if(pairs, [&](const auto& pair) {
        const auto [chart, cover] = charts_.link(pair.first, pair.second);
        if (chart < 0 || (cover & missing[chart]) != 0) return false;
        used_[chart] |= cover;
        return true;
    });
    for (std::size_t c = 0; c < used_.size(); ++c)
        if (wanted_[c] != 0 && used_[c] == 0) pause_[c] = PAUSE;
    for (std::size_t r = 0; r < least_limit_.size(); ++r) find_least_limit(static_cast<Index>(r));
}

/// Looks at what is wanted and does not hold for long, as charts lie; turns those where that is not
/// enough.
void OpenCloth::look_at_charts(const Points& x, PatchMotion& motion) {
    const auto is_short_for = [&](Index r) {
        const auto places = charts_.places(r);
        return std::any_of(places.begin(), places.end(), [&](const Charts::Place& at) {
            return (wanted_[at.chart] >> at.sheet & 1U) != 0 &&
                   limits_.is_short(at.row, r, {SOON, spare_}, motion);
        });
    };
    list_due(is_short_for, x, motion);
    look_at_patches(due_, wanted_, x, motion);

    turned_.clear();
    for (std::size_t i = 0; i < wanted_.size(); ++i)
        if (const auto c = static_cast<Index>(i);
            limits_.short_of(c, wanted_[i], {SOON, spare_}, motion) != 0)
            turned_.push_back(c);
    mark_sheets(wanted_, x, motion);
    const auto turn_one = [&](std::size_t i) {
        limits_.turn(turned_[i], wanted_[turned_[i]], x, motion);
    };
    parallel::for_each(turned_.size(), turn_one, CHUNK);
}

/// Lists patches that are due by what they have come to, which is measured where it seems so.
template <class IsDue>
void OpenCloth::list_due(IsDue&& is_due, const Points& x, PatchMotion& motion) {
    due_.clear();
    for (std::size_t i = 0; i < charts_.size(); ++i)
        if (const auto r = static_cast<Index>(i); is_due(r)) due_.push_back(r);
    parallel::for_each(
        due_.size(), [&](std::size_t i) { motion.measure_flutter(due_[i], x); }, CHUNK);
    std::erase_if(due_, [&](Index r) { return !is_due(r); });
}

/// Marks the shapes of all patches that lie in charts that are turned.
void OpenCloth::mark_sheets(const std::vector<std::uint64_t>& wanted, const Points& x,
                            PatchMotion& motion) {
    is_due_.assign(charts_.size(), 0);
    for (const Index c : turned_)
        for_each_bit(wanted[c], [&](std::size_t s) { is_due_[charts_[c].sheets[s].patch] = 1; });
    due_.clear();
    for (std::size_t r = 0; r < is_due_.size(); ++r)
        if (is_due_[r]) due_.push_back(static_cast<Index>(r));
    parallel::for_each(
        due_.size(), [&](std::size_t i) { motion.mark_shape(due_[i], x); }, CHUNK);
}

bool OpenCloth::holds(const Points& x, PatchMotion& motion) {
    const auto is_over = [&](Index r) {
        return motion.gone(r).flutter + motion.ahead(r).flutter > least_limit_[r];
    };
    list_due(is_over, x, motion);
    if (due_.empty()) return true;
    look_at_patches(due_, used_, x, motion);
    for (const Index r : due_) find_least_limit(r);

    turned_.clear();
    for (const Index r : due_)
        for (const auto& [c, sheet, row, crossed] : charts_.places(r))
            if (used_[c] >> sheet & 1U && limits_.is_short(row, r, {SOON}, motion) &&
                !has_turned(c))
                turned_.push_back(c);
    if (turned_.empty()) return true;
    mark_sheets(used_, x, motion);
    bool is_open = true;
    for (const Index c : turned_) {
        limits_.turn(c, used_[c], x, motion);
        is_open &= limits_.short_of(c, used_[c], {1.0}, motion) == 0;
    }
    for (const Index r : due_) find_least_limit(r);
    return is_open;
}

}  // namespace corpuscle::contact
