// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/open_cloth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t CHUNK = 4;  ///< patches
/// What does not hold for so many steps is looked at anew if its patch is; it is not left out, and
/// its chart is turned.
constexpr double LEAST = 12.0, SOON = 2.0;
constexpr double SPARE = 0.04;     ///< in edge lengths: way left to what is left out
constexpr std::uint8_t PAUSE = 4;  ///< calls after one in which nothing of a chart lay open
constexpr double ROUNDING = 1e-4;  ///< of mu in single precision, on the safe side
constexpr double NEVER = -1.0;

/// Of some lanes; NEVER if one of them is below 0, or no number.
double least_of_lanes(const Eight& a, unsigned lanes) {
    if ((bits_of(a >= 0.0F) & lanes) != lanes) return NEVER;
    return static_cast<double>(
        least_lane(lanes_of(lanes) ? a : all_eight(std::numeric_limits<float>::max())));
}

template <class Visit>
void for_each_bit(std::uint64_t bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

OpenCloth::OpenCloth(const Cloth& cloth, std::span<const double> margin)
    : charts_(cloth, margin),
      limit_(charts_.sheets(), -INF),
      block_limit_(BLOCKS * limit_.size(), -INF),
      frame_(charts_.size()),
      least_limit_(charts_.size(), INF),
      used_(charts_.size(), 0),
      pause_(charts_.size(), 0),
      spare_(SPARE * cloth.mean_edge) {}

/// Two edges of a block of a patch's triangles, from their first corner on.
const EightEdges& OpenCloth::take_edges(Index patch, std::size_t b, const Points& x,
                                        Edges& edges) const {
    EightEdges& out = edges.of[b];
    if (edges.is_known[b]) return out;
    edges.is_known[b] = true;
    const auto& corner = charts_.blocks(patch)[b].corner;
    for (int lane = 0; lane < EIGHT; ++lane) {
        const Vec3& from = x[corner[0][lane]];
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3 edge = x[corner[k + 1][lane]] - from;
            for (int i = 0; i < 3; ++i) out[k][i][lane] = static_cast<float>(edge[i]);
        }
    }
    return out;
}

/// Looks at a patch as a sheet of a chart: at the blocks that do not hold for long, or at all.
void OpenCloth::look(Index patch, const Charts::Place& at, bool is_all, const Points& x,
                     const PatchMotion& motion, Edges& edges) {
    const Charts::Chart& chart = charts_[at.chart];
    const Spread spread(chart.axis, frame_[at.chart], static_cast<float>(chart.least + ROUNDING));
    const auto blocks = charts_.blocks(patch);
    const double gone = motion.gone(patch).flutter;
    const double soon = gone + std::max(LEAST * motion.ahead(patch).flutter, spare_);
    const auto row = static_cast<std::size_t>(at.row);
    double least = INF;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const auto lanes = static_cast<unsigned>(at.crossed >> (EIGHT * b) & 0xFF);
        if (lanes == 0) continue;
        double& limit = block_limit_[BLOCKS * row + b];
        if (is_all || limit < soon)
            limit =
                gone + least_of_lanes(
                           spread.allowed(blocks[b].edge, take_edges(patch, b, x, edges)), lanes);
        least = std::min(least, limit);
    }
    limit_[row] = least;
}

/// Looks at these patches in all charts that want them.
void OpenCloth::look_at_patches(std::span<const Index> patches,
                                const std::vector<std::uint64_t>& wanted, const Points& x,
                                PatchMotion& motion) {
    const auto look_at_one = [&](std::size_t i) {
        const Index r = patches[i];
        motion.mark_shape(r, x);
        Edges edges;
        for (const Charts::Place& at : charts_.places(r))
            if (wanted[at.chart] >> at.sheet & 1U && is_short(at.row, r, LEAST, motion, spare_))
                look(r, at, false, x, motion, edges);
    };
    parallel::for_each(patches.size(), look_at_one, CHUNK);
}

/// Turns a chart to where its own patch lies now: Q = G (G^T G)^-1/2 of its mean gradient, each
/// triangle's by its area.
void OpenCloth::turn(Index p, std::uint64_t wanted, const Points& x, const PatchMotion& motion) {
    Edges edges;
    const Charts::Chart& chart = charts_[p];
    const EightPoints along = all_eight(chart.axis[0]), across = all_eight(chart.axis[1]);
    Vec3 g = Vec3::Zero(), h = Vec3::Zero();
    for (std::size_t b = 0; b < charts_.blocks(p).size(); ++b) {
        const auto& [u, v] = charts_.blocks(p)[b].edge;
        const auto& [e, f] = take_edges(p, b, x, edges);
        const Eight u0 = dot(along, u), u1 = dot(across, u);
        const Eight v0 = dot(along, v), v1 = dot(across, v);
        const Eight sign = u0 * v1 > v0 * u1 ? all_eight(1.0F) : all_eight(-1.0F);
        for (int i = 0; i < 3; ++i) {
            const Eight gs = sign * (e[i] * v1 - f[i] * u1), hs = sign * (f[i] * u0 - e[i] * v0);
            for (int lane = 0; lane < EIGHT; ++lane) {
                g[i] += static_cast<double>(gs[lane]);
                h[i] += static_cast<double>(hs[lane]);
            }
        }
    }
    // (G^T G)^1/2 = (G^T G + s 1) / t with s² = det G^T G, t² = tr G^T G + 2 s
    const double gg = g.squaredNorm(), hh = h.squaredNorm(), gh = g.dot(h);
    const double s = std::sqrt(std::max(0.0, gg * hh - gh * gh));
    const double t = std::sqrt(gg + hh + 2.0 * s), whole = (gg + s) * (hh + s) - gh * gh;
    const Vec3 first = t / whole * ((hh + s) * g - gh * h);
    const Vec3 second = t / whole * ((gg + s) * h - gh * g);
    for (int i = 0; i < 3; ++i) {
        frame_[p][0][i] = static_cast<float>(first[i]);
        frame_[p][1][i] = static_cast<float>(second[i]);
    }
    // what was seen from elsewhere says nothing any more
    for (const Charts::Sheet& sheet : chart.sheets) {
        limit_[sheet.row] = -INF;
        const auto row = static_cast<std::ptrdiff_t>(sheet.row);
        std::fill_n(block_limit_.begin() + row * static_cast<std::ptrdiff_t>(BLOCKS), BLOCKS, -INF);
    }
    for_each_bit(wanted, [&](std::size_t at) {
        const auto& [r, row, crossed] = chart.sheets[at];
        Edges of_sheet;
        look(r, {p, static_cast<Index>(at), row, crossed}, true, x, motion, of_sheet);
    });
}

/// Those of a chart's sheets that do not hold for so many steps.
std::uint64_t OpenCloth::short_of(Index p, std::uint64_t wanted, double steps,
                                  const PatchMotion& motion, double spare) const {
    std::uint64_t out = 0;
    for_each_bit(wanted, [&](std::size_t s) {
        const Charts::Sheet& sheet = charts_[p].sheets[s];
        if (is_short(sheet.row, sheet.patch, steps, motion, spare)) out |= std::uint64_t{1} << s;
    });
    return out;
}

double OpenCloth::spare(Index p, Index q, const Points& x) const {
    const auto [c, cover] = charts_.link(p, q);
    double least = INF;
    if (c < 0) return least;
    const Spread spread(charts_[c].axis, frame_[c], static_cast<float>(charts_[c].least));
    for_each_bit(cover, [&](std::size_t s) {
        const Charts::Sheet& sheet = charts_[c].sheets[s];
        const auto blocks = charts_.blocks(sheet.patch);
        Edges edges;
        for (std::size_t b = 0; b < blocks.size(); ++b)
            if (const auto lanes = static_cast<unsigned>(sheet.crossed >> (EIGHT * b) & 0xFF))
                least = std::min(
                    least, least_of_lanes(
                               spread.allowed(blocks[b].edge, take_edges(sheet.patch, b, x, edges)),
                               lanes));
    });
    return least;
}

double OpenCloth::known_spare(Index p, Index q, const PatchMotion& motion) const {
    const auto [c, cover] = charts_.link(p, q);
    double least = INF;
    for_each_bit(cover, [&](std::size_t s) {
        const Charts::Sheet& sheet = charts_[c].sheets[s];
        least = std::min(least, limit_[sheet.row] - motion.gone(sheet.patch).flutter);
    });
    return least;
}

void OpenCloth::find_least_limit(Index patch) {
    double least = INF;
    for (const Charts::Place& at : charts_.places(patch))
        if (used_[at.chart] >> at.sheet & 1U) least = std::min(least, limit_[at.row]);
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
        missing[c] =
            ~wanted_[c] | short_of(static_cast<Index>(c), wanted_[c], SOON, motion, spare_);
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
                   is_short(at.row, r, SOON, motion, spare_);
        });
    };
    list_due(is_short_for, x, motion);
    look_at_patches(due_, wanted_, x, motion);

    turned_.clear();
    for (std::size_t i = 0; i < wanted_.size(); ++i)
        if (const auto c = static_cast<Index>(i);
            short_of(c, wanted_[i], SOON, motion, spare_) != 0)
            turned_.push_back(c);
    mark_sheets(wanted_, x, motion);
    const auto turn_one = [&](std::size_t i) { turn(turned_[i], wanted_[turned_[i]], x, motion); };
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
            if (used_[c] >> sheet & 1U && is_short(row, r, SOON, motion) && !has_turned(c))
                turned_.push_back(c);
    if (turned_.empty()) return true;
    mark_sheets(used_, x, motion);
    bool is_open = true;
    for (const Index c : turned_) {
        turn(c, used_[c], x, motion);
        is_open &= short_of(c, used_[c], 1.0, motion) == 0;
    }
    for (const Index r : due_) find_least_limit(r);
    return is_open;
}

}  // namespace corpuscle::contact
