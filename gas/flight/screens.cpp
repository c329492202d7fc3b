// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/screens.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {
namespace {

/// One point four times over.
FourPoints four_times(const Vec3& p) {
    return {all_four(p[0]), all_four(p[1]), all_four(p[2])};
}

Four least_of_four(const Four& a, const Four& b) {
    return a < b ? a : b;
}
Four greatest_of_four(const Four& a, const Four& b) {
    return a > b ? a : b;
}

/// Word `lane` of a row of fours.
std::uint64_t word_at(const std::vector<FourBits>& words, std::size_t lane) {
    return static_cast<std::uint64_t>(words[lane / FOUR][lane % FOUR]);
}

}  // namespace

/// From p along d, with p × d.
struct Screens::Line {
    FourPoints along, moment;
    Four length;
};

void Screens::begin(std::span<const Vec3> x, double reach) {
    reach_ = reach;
    origin_ = x.front();
    size_ = 0;
    over_.clear();
    under_.clear();
    edges_.clear();
    x_.assign((x.size() + FOUR - 1) / FOUR, FourPoints{});  // those beyond the last are the first
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int k = 0; k < 3; ++k) x_[i / FOUR][k][i % FOUR] = x[i][k] - origin_[k];
    height_.resize(x_.size());
}

void Screens::add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
    const double longest = std::sqrt(longest2), far = longest + reach_;
    const double plane_slack = CLOSE * reach_ * normal.norm() + ROUNDING * longest2 * far;
    if (!has_both_sides(normal, normal.dot(a - origin_), plane_slack)) return;
    note_sides(plane_slack);
    note_edges({a - origin_, b - origin_, c - origin_},
               CLOSE * reach_ * longest + ROUNDING * far * far);
    ++size_;
}

/// Measures how high the particles are; false if all are strictly on one side.
bool Screens::has_both_sides(const Vec3& normal, double offset, double slack) {
    const FourPoints n = four_times(normal);
    Four least = all_four(INF), greatest = all_four(-INF);
    for (std::size_t k = 0; k < x_.size(); ++k) {
        const Four height = dot(n, x_[k]) - offset;
        height_[k] = height;
        least = least_of_four(least, height);
        greatest = greatest_of_four(greatest, height);
    }
    const double low = std::min({least[0], least[1], least[2], least[3]});
    const double high = std::max({greatest[0], greatest[1], greatest[2], greatest[3]});
    return !(low > slack || high < -slack);
}

void Screens::note_sides(double slack) {
    const std::size_t at = size_ / BITS * x_.size();
    if (size_ % BITS == 0) {
        over_.resize(at + x_.size(), FourBits{});
        under_.resize(at + x_.size(), FourBits{});
    }
    const auto bit = static_cast<std::int64_t>(std::uint64_t{1} << size_ % BITS);
    const FourBits bits{bit, bit, bit, bit};
    for (std::size_t k = 0; k < x_.size(); ++k) {
        over_[at + k] |= (height_[k] > slack) & bits;
        under_[at + k] |= (height_[k] < -slack) & bits;
    }
}

void Screens::note_edges(const std::array<Vec3, 3>& corner, double slack) {
    const std::size_t lane = size_ % FOUR;
    if (lane == 0) edges_.emplace_back();
    Edges& edges = edges_.back();
    edges.slack[lane] = slack;
    for (std::size_t e = 0; e < 3; ++e) {
        const Vec3 &from = corner[e], &to = corner[(e + 1) % 3];
        const Vec3 along = to - from, moment = from.cross(to);
        for (int k = 0; k < 3; ++k) {
            edges.along[e][k][lane] = along[k];
            edges.moment[e][k][lane] = moment[k];
        }
    }
}

bool Screens::touches(std::size_t i) const {
    const std::size_t stride = x_.size() * FOUR;
    for (std::size_t w = 0; w * BITS < size_; ++w)
        if ((word_at(over_, w * stride + i) | word_at(under_, w * stride + i)) != all(w))
            return true;
    return false;
}

bool Screens::are_alike(std::size_t i, std::size_t j) const {
    const std::size_t stride = x_.size() * FOUR;
    for (std::size_t w = 0; w * BITS < size_; ++w) {
        const std::size_t at = w * stride;
        if (word_at(over_, at + i) != word_at(over_, at + j) ||
            word_at(under_, at + i) != word_at(under_, at + j))
            return false;
    }
    return true;
}

bool Screens::is_free(std::size_t i, std::size_t j) const {
    const auto place = [&](std::size_t p) {
        const FourPoints& four = x_[p / FOUR];
        return Vec3(four[0][p % FOUR], four[1][p % FOUR], four[2][p % FOUR]);
    };
    const Vec3 p = place(i), d = place(j) - p;
    const Line line{four_times(d), four_times(p.cross(d)), all_four(d.norm())};
    const std::size_t stride = x_.size() * FOUR;
    for (std::size_t w = 0; w * BITS < size_; ++w) {
        const std::size_t at = w * stride;
        const std::uint64_t both = (word_at(over_, at + i) & word_at(over_, at + j)) |
                                   (word_at(under_, at + i) & word_at(under_, at + j));
        std::size_t four = w * BITS / FOUR;
        for (std::uint64_t between = ~both & all(w); between != 0; between >>= FOUR, ++four) {
            const auto asked = static_cast<unsigned>(between & 0xFU);
            if (asked != 0 && (asked & blocks(edges_[four], line)) != 0) return false;
        }
    }
    return true;
}

/// Bit l: facet l of four may be in the way of a line that meets its plane.
unsigned Screens::blocks(const Edges& edges, const Line& line) {
    std::array<Four, 3> side;
    for (std::size_t e = 0; e < 3; ++e)
        side[e] = dot(line.along, edges.moment[e]) + dot(line.moment, edges.along[e]);
    const Four least = least_of_four(least_of_four(side[0], side[1]), side[2]);
    const Four greatest = greatest_of_four(greatest_of_four(side[0], side[1]), side[2]);
    const Four slack = edges.slack * line.length;
    return bits_of(FourBits((least >= -slack) | (greatest <= slack)));
}

}  // namespace corpuscle::gas
