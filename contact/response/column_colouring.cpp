// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/column_colouring.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace corpuscle::contact {
namespace {

/// In edge lengths: two edges that cross reach some 0.7 from their mean, half of this is allowed.
/// Narrower: more columns at once, more contacts in wide ones. Cloth that is wider than all names has
/// wider ones, lest columns share.
constexpr double NARROWEST = 1.1, WIDEST = 2.2;
constexpr double FARTHEST = 1e9;  ///< columns from the origin that have a name

constexpr std::size_t SORT_CHUNKS = 8;               ///< of contacts that are sorted together
constexpr std::size_t FEW_GROUPS = 8, COLUMNS = 16;  ///< of those; a chunk

}  // namespace

void ColumnColouring::lay(const Points& x) {
    const Box all = parallel::fold(
        cloth_.nodes.size(), Box{},
        [&](Box& box, std::size_t i) { box.include(x[cloth_.nodes[i]]); },
        [](Box& box, const Box& more) { box.include(more); });
    int thinnest = 0;
    (all.high - all.low).minCoeff(&thinnest);
    axis_ = {(thinnest + 1) % 3, (thinnest + 2) % 3};
    for (std::size_t k = 0; k < 2; ++k) {
        const double across = (all.high - all.low)[axis_[k]] / ACROSS, edge = cloth_.mean_edge;
        per_width_[k] =
            edge > 0.0 ? 1.0 / std::clamp(across, NARROWEST * edge, WIDEST * edge) : 0.0;
    }
}

std::uint16_t ColumnColouring::of(const Contact& contact, const Points& x) const {
    if (contact.on_body) return Contact::ALONE;
    for (const Width& width : {NARROW, WIDE}) {
        const double share = static_cast<double>(width.across) / ACROSS;
        std::array<unsigned, 2> at{};
        bool is_within = true;
        for (std::size_t k = 0; k < 2; ++k) {
            std::array<double, 4> u;
            for (std::size_t i = 0; i < 4; ++i)
                u[i] = share * per_width_[k] * x[contact.node[i]][axis_[k]];
            const double column = std::floor(0.25 * (u[0] + u[1] + u[2] + u[3]));
            const auto [least, most] = std::minmax_element(u.begin(), u.end());
            is_within = is_within && *least >= column - 0.5 && *most < column + 1.5 &&
                        std::abs(column) <= FARTHEST;
            if (!is_within) break;
            const int across = static_cast<int>(width.across);
            const int place = static_cast<int>(column) % across;
            at[k] = static_cast<unsigned>(place < 0 ? place + across : place);
        }
        if (is_within) return width.name(at[0], at[1]);
    }
    return Contact::ALONE;
}

void ColumnColouring::sort(const ContactList& contacts) {
    const std::size_t chunks = contacts.chunks();
    const std::size_t groups = parallel::chunk_count(chunks, SORT_CHUNKS);
    const std::size_t columns_a_chunk = groups > FEW_GROUPS ? COLUMNS : COUNT + 1;
    next_.resize(groups);
    const auto for_each_row = [&](std::size_t group, auto&& visit) {
        for (std::size_t c = group * SORT_CHUNKS; c < std::min(chunks, (group + 1) * SORT_CHUNKS);
             ++c) {
            std::uint32_t row = 0;
            for (const std::uint16_t column : contacts.columns(c))
                visit(column, Slot{static_cast<std::uint32_t>(c), row++});
        }
    };
    const auto count = [&](std::size_t group) {
        next_[group].fill(0);
        for_each_row(group, [&](std::uint16_t column, Slot) { ++next_[group][column]; });
    };
    const auto add_up = [&](std::size_t column) {
        std::size_t sum = 0;
        for (const auto& next : next_) sum += next[column];
        start_[column + 1] = sum;
    };
    const auto find_starts = [&] {
        start_[0] = 0;
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        sort_by_size();
        deal_out();
        order_.resize(start_.back());
    };
    const auto share_out = [&](std::size_t column) {
        std::size_t to = start_[column];
        for (auto& next : next_) to += std::exchange(next[column], static_cast<std::uint32_t>(to));
    };
    const auto write = [&](std::size_t group) {
        for_each_row(
            group, [&](std::uint16_t column, Slot slot) { order_[next_[group][column]++] = slot; });
    };
    parallel::in_turn(
        parallel::each(groups, count, 1), parallel::each(COUNT + 1, add_up, columns_a_chunk),
        parallel::alone(find_starts), parallel::each(COUNT + 1, share_out, columns_a_chunk),
        parallel::each(groups, write, 1));
}

/// Colour by colour, in each by size to half an octave, those of one size in the order of their
/// names.
void ColumnColouring::sort_by_size() {
    filled_ = 0;
    task_of_.fill(NONE);
    for (const Width& width : {NARROW, WIDE})
        for (unsigned colour = 0; colour < Width::colours(); ++colour)
            sort_by_size(width.first + colour * width.of_one(), width.of_one());
}

/// Those of one colour.
void ColumnColouring::sort_by_size(std::size_t first, std::size_t count) {
    constexpr std::size_t SIZES = 2 * 64 + 2;
    const auto rank = [&](std::size_t column) -> std::size_t {
        const std::size_t n = size(column);
        const auto width = static_cast<std::size_t>(std::bit_width(n));
        return SIZES - 1 - (width < 2 ? width : 2 * width + (n >> (width - 2) & 1U));
    };
    std::array<std::uint8_t, SIZES + 1> start{};
    std::array<std::uint8_t, NARROW.of_one()> rank_of;
    for (std::size_t c = 0; c < count; ++c) {
        rank_of[c] = static_cast<std::uint8_t>(rank(first + c));
        ++start[rank_of[c] + 1U];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (std::size_t c = 0; c < count; ++c) {
        if (size(first + c) == 0) continue;
        const std::size_t task = filled_ + start[rank_of[c]]++;
        task_[task] = static_cast<std::uint16_t>(first + c);
        task_of_[first + c] = static_cast<std::uint16_t>(task);
    }
    filled_ += start[SIZES - 1];
}

/// To the threads, block by block: along a Z-curve [Morton 1966] over the names of wide columns, each
/// of which comes after the four narrow ones in it.
void ColumnColouring::deal_out() {
    constexpr std::size_t IN_ONE = 4;
    const auto task_at = [&](std::size_t place) -> std::size_t {
        const std::size_t z = place / (IN_ONE + 1), k = place % (IN_ONE + 1);
        unsigned i = 0, j = 0;
        for (unsigned bit = 0; WIDE.across >> bit > 1; ++bit) {
            i |= static_cast<unsigned>(z >> 2 * bit & 1U) << bit;
            j |= static_cast<unsigned>(z >> (2 * bit + 1) & 1U) << bit;
        }
        const auto within = static_cast<unsigned>(k);
        const std::uint16_t task =
            task_of_[k < IN_ONE ? NARROW.name(2 * i + within % 2, 2 * j + within / 2)
                                : WIDE.name(i, j)];
        return task == NONE ? parallel::TaskShares::NONE : std::size_t{task};
    };
    shares_.deal(COUNT, task_at,
                 [&](std::size_t task) { return static_cast<double>(size(task_[task])); });
}

}  // namespace corpuscle::contact
