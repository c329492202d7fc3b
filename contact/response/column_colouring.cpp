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
constexpr double WIDTH = 2.2;
constexpr double FARTHEST = 1e9;  ///< columns from the origin that have a name

constexpr std::size_t CHUNKS = 4;                    ///< of contacts that are sorted together
constexpr std::size_t FEW_GROUPS = 8, COLUMNS = 16;  ///< of those; a chunk

constexpr unsigned APART = 2;           ///< from a column to the next of its colour
constexpr unsigned ACROSS = 8 * APART;  ///< names along each axis, then they are used again

/// Columns of one colour are next to each other.
std::uint16_t name(unsigned i, unsigned j) {
    const unsigned colour = i % APART + APART * (j % APART);
    return static_cast<std::uint16_t>(64 * colour + 8 * (i / APART) + j / APART);
}

}  // namespace

void ColumnColouring::lay(const Points& x) {
    per_width_ = cloth_.mean_edge > 0.0 ? 1.0 / (WIDTH * cloth_.mean_edge) : 0.0;
    const Box all = parallel::fold(
        cloth_.nodes.size(), Box{},
        [&](Box& box, std::size_t i) { box.include(x[cloth_.nodes[i]]); },
        [](Box& box, const Box& more) { box.include(more); });
    int thinnest = 0;
    (all.high - all.low).minCoeff(&thinnest);
    axis_ = {(thinnest + 1) % 3, (thinnest + 2) % 3};
}

std::uint16_t ColumnColouring::of(const Contact& contact, const Points& x) const {
    if (contact.on_body) return Contact::ALONE;
    std::array<unsigned, 2> at{};
    for (std::size_t k = 0; k < 2; ++k) {
        std::array<double, 4> u;
        for (std::size_t i = 0; i < 4; ++i) u[i] = per_width_ * x[contact.node[i]][axis_[k]];
        const double column = std::floor(0.25 * (u[0] + u[1] + u[2] + u[3]));
        const auto [least, most] = std::minmax_element(u.begin(), u.end());
        const bool is_within = *least >= column - 0.5 && *most < column + 1.5;
        if (!is_within || std::abs(column) > FARTHEST) return Contact::ALONE;
        const int place = static_cast<int>(column) % static_cast<int>(ACROSS);
        at[k] = static_cast<unsigned>(place < 0 ? place + static_cast<int>(ACROSS) : place);
    }
    return name(at[0], at[1]);
}

void ColumnColouring::sort(const ContactList& contacts) {
    const std::size_t groups = parallel::chunk_count(contacts.chunks(), CHUNKS);
    next_.resize(groups);
    const auto each_group = [&](auto&& body) {
        parallel::for_chunks(contacts.chunks(), body, CHUNKS);
    };
    const auto each_column = [&](auto&& body) {
        parallel::for_each(COUNT + 1, body, groups > FEW_GROUPS ? COLUMNS : COUNT + 1);
    };
    each_group([&](std::size_t begin, std::size_t end, std::size_t group) {
        next_[group].fill(0);
        for (std::size_t c = begin; c < end; ++c)
            for (const auto& brief : contacts.briefs(c)) ++next_[group][brief.column];
    });
    start_[0] = 0;
    each_column([&](std::size_t column) {
        std::size_t sum = 0;
        for (const auto& next : next_) sum += next[column];
        start_[column + 1] = sum;
    });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sort_by_size();
    each_column([&](std::size_t column) {
        std::size_t to = start_[column];
        for (auto& next : next_) to += std::exchange(next[column], static_cast<std::uint32_t>(to));
    });
    order_.resize(start_.back());
    each_group([&](std::size_t begin, std::size_t end, std::size_t group) {
        for (std::size_t c = begin; c < end; ++c) {
            std::uint32_t row = 0;
            for (const auto& brief : contacts.briefs(c))
                order_[next_[group][brief.column]++] = {static_cast<std::uint32_t>(c), row++};
        }
    });
}

/// By size to half an octave, those of one size in the order of their names; the empty ones last.
void ColumnColouring::sort_by_size() {
    constexpr std::size_t SIZES = 2 * 64 + 2;
    const auto rank = [&](std::size_t column) -> std::size_t {
        const std::size_t n = size(column);
        const auto width = static_cast<std::size_t>(std::bit_width(n));
        return SIZES - 1 - (width < 2 ? width : 2 * width + (n >> (width - 2) & 1U));
    };
    for (std::size_t colour = 0; colour < COLOURS; ++colour) {
        const std::size_t first = colour * PER_COLOUR;
        std::array<std::uint8_t, SIZES + 1> start{};
        for (std::size_t c = first; c < first + PER_COLOUR; ++c) ++start[rank(c) + 1];
        filled_[colour] = PER_COLOUR - start[SIZES];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (std::size_t c = first; c < first + PER_COLOUR; ++c)
            by_size_[first + start[rank(c)]++] = static_cast<std::uint16_t>(c);
    }
}

}  // namespace corpuscle::contact
