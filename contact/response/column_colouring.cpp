// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/column_colouring.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace corpuscle::contact {
namespace {

/// In edge lengths: two edges that cross reach some 0.7 from their mean, half of this is allowed.
constexpr double WIDTH = 2.2;
constexpr double FARTHEST = 1e9;  ///< columns from the origin that have a name

constexpr std::size_t FEW_CHUNKS = 8, COLUMNS = 16;  ///< of contacts; a chunk

constexpr unsigned ACROSS = 16;  ///< names along each axis, then they are used again: even

/// ColumnColouring of one colour are next to each other; the colour tells even from odd along both axes.
std::uint16_t name(unsigned i, unsigned j) {
    const unsigned colour = (i & 1U) | (j & 1U) << 1U;
    return static_cast<std::uint16_t>(colour << 6U | i >> 1U << 3U | j >> 1U);
}

}  // namespace

void ColumnColouring::lay(const Points& x) {
    per_width_ = cloth_.mean_edge > 0.0 ? 1.0 / (WIDTH * cloth_.mean_edge) : 0.0;
    Vec3 low = Vec3::Constant(INF), high = -low;
    for (const Index n : cloth_.nodes) {
        low = low.cwiseMin(x[n]);
        high = high.cwiseMax(x[n]);
    }
    int thinnest = 0;
    (high - low).minCoeff(&thinnest);
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
        at[k] = static_cast<unsigned>(static_cast<int>(column)) % ACROSS;
    }
    return name(at[0], at[1]);
}

void ColumnColouring::sort(const ContactList& contacts) {
    const std::size_t chunks = contacts.chunks();
    next_.resize(chunks);
    contacts.for_each_chunk([&](std::size_t c) {
        next_[c].fill(0);
        for (const auto& brief : contacts.briefs(c)) ++next_[c][brief.column];
    });
    const auto each_column = [&](auto&& body) {
        parallel::for_each(COUNT + 1, body, chunks > FEW_CHUNKS ? COLUMNS : COUNT + 1);
    };
    start_[0] = 0;
    each_column([&](std::size_t column) {
        std::size_t sum = 0;
        for (std::size_t c = 0; c < chunks; ++c) sum += next_[c][column];
        start_[column + 1] = sum;
    });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    each_column([&](std::size_t column) {
        std::size_t next = start_[column];
        for (std::size_t c = 0; c < chunks; ++c)
            next += std::exchange(next_[c][column], static_cast<std::uint32_t>(next));
    });
    order_.resize(start_.back());
    contacts.for_each_chunk([&](std::size_t c) {
        std::uint32_t row = 0;
        for (const auto& brief : contacts.briefs(c))
            order_[next_[c][brief.column]++] = {static_cast<std::uint32_t>(c), row++};
    });
}

}  // namespace corpuscle::contact
