// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/sheet_limits.hpp"

#include <cmath>
#include <limits>

namespace corpuscle::contact {
namespace {

constexpr std::size_t BLOCKS = Charts::MOST_BLOCKS;
constexpr double ROUNDING = 1e-4;  ///< of mu in single precision, on the safe side
constexpr double NEVER = -1.0;

/// Of some lanes; NEVER if one of them is below 0, or no number.
double least_of_lanes(const Eight& a, unsigned lanes) {
    if ((bits_of(a >= 0.0F) & lanes) != lanes) return NEVER;
    return static_cast<double>(
        least_lane(lanes_of(lanes) ? a : all_eight(std::numeric_limits<float>::max())));
}

unsigned lanes_in(std::uint64_t crossed, std::size_t block) {
    return static_cast<unsigned>(crossed >> (EIGHT * block) & 0xFF);
}

}  // namespace

SheetLimits::SheetLimits(const Charts& charts)
    : charts_(charts),
      limit_(charts.sheets(), -INF),
      block_limit_(BLOCKS * limit_.size(), -INF),
      frame_(charts.size()) {}

void SheetLimits::forget() {
    std::fill(limit_.begin(), limit_.end(), -INF);
    std::fill(block_limit_.begin(), block_limit_.end(), -INF);
}

const EightEdges& SheetLimits::Edges::operator[](std::size_t block) {
    EightEdges& out = edges_[block];
    if (is_known_[block]) return out;
    is_known_[block] = true;
    const auto& corner = blocks_[block].corner;
    for (int lane = 0; lane < EIGHT; ++lane) {
        const Vec3& from = x_[corner[0][lane]];
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3 edge = x_[corner[k + 1][lane]] - from;
            for (int i = 0; i < 3; ++i) out[k][i][lane] = static_cast<float>(edge[i]);
        }
    }
    return out;
}

double SheetLimits::look_at_block(const Spread& spread, Index patch, std::uint64_t crossed,
                                  std::size_t block, Edges& edges) const {
    return least_of_lanes(spread.allowed(charts_.blocks(patch)[block].edge, edges[block]),
                          lanes_in(crossed, block));
}

void SheetLimits::look(Index patch, const Charts::Place& at, double soon, Edges& edges,
                       const PatchMotion& motion) {
    const Charts::Chart& chart = charts_[at.chart];
    const Spread spread(chart.axis, frame_[at.chart], static_cast<float>(chart.least + ROUNDING));
    const auto row = static_cast<std::size_t>(at.row);
    double least = INF;
    for (std::size_t b = 0; b < charts_.blocks(patch).size(); ++b) {
        if (lanes_in(at.crossed, b) == 0) continue;
        double& limit = block_limit_[BLOCKS * row + b];
        if (limit < soon)
            limit = motion.gone(patch).flutter + look_at_block(spread, patch, at.crossed, b, edges);
        least = std::min(least, limit);
    }
    limit_[row] = least;
}

void SheetLimits::turn(Index c, std::uint64_t sheets, const Points& x, const PatchMotion& motion) {
    const Charts::Chart& chart = charts_[c];
    const auto blocks = charts_.blocks(c);
    Edges edges(blocks, x);
    const EightPoints along = all_eight(chart.axis[0]), across = all_eight(chart.axis[1]);
    Vec3 g = Vec3::Zero(), h = Vec3::Zero();
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const auto& [u, v] = blocks[b].edge;
        const auto& [e, f] = edges[b];
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
        frame_[c][0][i] = static_cast<float>(first[i]);
        frame_[c][1][i] = static_cast<float>(second[i]);
    }
    for (const Charts::Sheet& sheet : chart.sheets) {
        const auto row = static_cast<std::size_t>(sheet.row);
        limit_[row] = -INF;
        std::fill_n(&block_limit_[BLOCKS * row], BLOCKS, -INF);
    }
    for_each_bit(sheets, [&](std::size_t at) {
        const auto& [patch, row, crossed] = chart.sheets[at];
        Edges of_sheet(charts_.blocks(patch), x);
        look(patch, {c, static_cast<Index>(at), row, crossed}, INF, of_sheet, motion);
    });
}

std::uint64_t SheetLimits::short_of(Index c, std::uint64_t sheets, const Lookahead& ahead,
                                    const PatchMotion& motion) const {
    std::uint64_t out = 0;
    for_each_bit(sheets, [&](std::size_t s) {
        const Charts::Sheet& sheet = charts_[c].sheets[s];
        if (is_short(sheet.row, sheet.patch, ahead, motion)) out |= std::uint64_t{1} << s;
    });
    return out;
}

double SheetLimits::spare(Index c, std::uint64_t sheets, const Points& x) const {
    const Spread spread(charts_[c].axis, frame_[c], static_cast<float>(charts_[c].least));
    double least = INF;
    for_each_bit(sheets, [&](std::size_t s) {
        const auto& [patch, row, crossed] = charts_[c].sheets[s];
        Edges edges(charts_.blocks(patch), x);
        for (std::size_t b = 0; b < charts_.blocks(patch).size(); ++b)
            if (lanes_in(crossed, b) != 0)
                least = std::min(least, look_at_block(spread, patch, crossed, b, edges));
    });
    return least;
}

}  // namespace corpuscle::contact
