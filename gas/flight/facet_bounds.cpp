// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/facet_bounds.hpp"

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Places that single precision takes reach from the grid's middle to three times its half: a
/// particle inside, and a way no longer than the grid.
constexpr float REACH = 3.0F;

/// Of the largest coordinate: some 60 units in the last place of a float.
constexpr float BOUNDS_ROUNDING = 4e-6F;

constexpr std::size_t EIGHTS_A_CHUNK = 8;

EightPoints cross_product(const EightPoints& a, const EightPoints& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Eight sum_of_components(const EightPoints& a) {
    Eight sum{};
    for (const Eight& component : a) sum += greatest_of(component, -component);
    return sum;
}

Eight root(const Eight& a) {
    Eight out;
    for (int l = 0; l < EIGHT; ++l) out[l] = std::sqrt(a[l]);
    return out;
}

/// Three corners of eight facets, at t and at t + dt.
struct EightTriangles {
    std::array<EightPoints, 6> at;
    [[nodiscard]] std::array<Eight, 6> heights(const EightHeights& over) const {
        std::array<Eight, 6> out;
        for (int c = 0; c < 6; ++c) out[c] = over.at(at[c]);
        return out;
    }
};
Eight least(const std::array<Eight, 6>& of) {
    Eight out = of[0];
    for (const Eight& a : of) out = least_of(out, a);
    return out;
}
Eight greatest(const std::array<Eight, 6>& of) {
    Eight out = of[0];
    for (const Eight& a : of) out = greatest_of(out, a);
    return out;
}

}  // namespace

/// Along the mean of the eight normals, all turned alike.
void FacetBounds::Bound::set_planes(const std::array<EightPoints, 6>& corners, const EightPoints& n,
                                    float slack) {
    const EightPoints first = all_eight({n[0][0], n[1][0], n[2][0]});
    const Eight turned = dot(n, first) < Eight{} ? all_eight(-1.0F) : all_eight(1.0F);
    float sum = 0.0F;
    for (int a = 0; a < 3; ++a) {
        normal[a] = 0.0F;
        for (int lane = 0; lane < EIGHT; ++lane) normal[a] += turned[lane] * n[a][lane] / EIGHT;
        sum += std::abs(normal[a]);
    }
    const EightHeights along{all_eight(normal), Eight{}};
    Eight least = along.at(corners[0]), most = least;
    for (const EightPoints& x : corners) {
        least = least_of(least, along.at(x));
        most = greatest_of(most, along.at(x));
    }
    float high = most[0];
    low = least[0];
    for (int lane = 1; lane < EIGHT; ++lane) {
        low = std::min(low, least[lane]);
        high = std::max(high, most[lane]);
    }
    low -= slack * sum;
    thick = high + slack * sum - low;
}

void FacetBounds::update(const FacetLists& lists, std::span<const Vec3> x_0,
                         std::span<const Vec3> x_1) {
    const Grid& grid = lists.grid();
    const Vec3 half = 0.5 * grid.edge * Vec3(grid.count[0], grid.count[1], grid.count[2]);
    origin_ = grid.low + half;
    size_ = REACH * static_cast<float>(half.maxCoeff());
    slack_ = BOUNDS_ROUNDING * size_;
    node_.resize(static_cast<std::size_t>(lists.nodes().back()) + 1);
    prisms_.resize(lists.eights().size());
    bound_.resize(lists.eights().size());
    in_.resize(lists.eights_in().size());
    const auto set_node = [&](std::size_t i) {
        const Index n = lists.nodes()[i];
        for (int a = 0; a < 3; ++a) {
            node_[n][0][a] = static_cast<float>(x_0[n][a] - origin_[a]);
            node_[n][1][a] = static_cast<float>(x_1[n][a] - origin_[a]);
        }
    };
    const auto set_eight = [&](std::size_t e) { set_prisms(lists, e); };
    const auto set_in = [&](std::size_t k) { in_[k] = bounds_of(lists.eights_in()[k]); };
    parallel::in_turn(parallel::each(lists.nodes().size(), set_node),
                      parallel::each(lists.eights().size(), set_eight, EIGHTS_A_CHUNK),
                      parallel::each(in_.size(), set_in, EIGHTS_A_CHUNK));
}

EightsBounds FacetBounds::bounds_of(const FacetLists::EightEights& eights) const {
    EightsBounds out;
    for (int lane = 0; lane < EIGHT && eights[lane] >= 0; ++lane) {
        const Bound& bound = bound_[eights[lane]];
        out.box.set(lane, bound.box);
        for (int a = 0; a < 3; ++a) out.normal.gradient[a][lane] = bound.normal[a];
        out.normal.offset[lane] = bound.low;
        out.thick[lane] = bound.thick;
    }
    return out;
}

void FacetBounds::set_prisms(const FacetLists& lists, std::size_t eight) {
    const std::array<Index, EIGHT>& facets = lists.eights().facet[eight];
    EightTriangles x;
    for (int lane = 0; lane < EIGHT; ++lane) {
        // A lane without a facet is its eight's first: no larger box, and never met (below).
        const Triangle& nodes = lists.triangles()[facets[lane] < 0 ? facets[0] : facets[lane]];
        for (int c = 0; c < 6; ++c)
            for (int a = 0; a < 3; ++a) x.at[c][a][lane] = node_[nodes[c % 3]][c / 3][a];
    }
    contact::Bounds& box = bound_[eight].box;
    for (int a = 0; a < 3; ++a) {
        std::array<Eight, 6> along;
        for (int c = 0; c < 6; ++c) along[c] = x.at[c][a];
        const Eight low = least(along), high = greatest(along);
        box.low[a] = low[0];
        box.high[a] = high[0];
        for (int lane = 1; lane < EIGHT; ++lane) {
            box.low[a] = std::min(box.low[a], low[lane]);
            box.high[a] = std::max(box.high[a], high[lane]);
        }
        box.low[a] -= slack_;
        box.high[a] += slack_;
    }

    const EightPoints ab = x.at[1] - x.at[0], ac = x.at[2] - x.at[0], N = cross_product(ab, ac);
    const Eight square = dot(N, N), zero{}, one = all_eight(1.0F);
    // Of a facet all but without area the gradients are naught: no path is told apart.
    const auto is_flat = square > all_eight(std::numeric_limits<float>::min());
    const Eight per_length = is_flat ? one / root(is_flat ? square : one) : zero;
    const EightPoints n = per_length * N;
    bound_[eight].set_planes(x.at, n, slack_);
    EightPrisms& out = prisms_[eight];
    out.normal.gradient = n;
    out.b.gradient = per_length * cross_product(ac, n);
    out.c.gradient = per_length * cross_product(n, ab);
    const auto rounding = [&](const EightHeights& of) {
        return slack_ * sum_of_components(of.gradient);
    };
    for (EightHeights* one_of : {&out.normal, &out.b, &out.c}) one_of->offset = zero;
    const auto normal = x.heights(out.normal), b = x.heights(out.b), c = x.heights(out.c);
    out.normal.offset = least(normal) - rounding(out.normal);
    out.thick = greatest(normal) + rounding(out.normal) - out.normal.offset;
    out.b.offset = least(b) - rounding(out.b);
    out.c.offset = least(c) - rounding(out.c);
    std::array<Eight, 6> both;
    for (int k = 0; k < 6; ++k) both[k] = (b[k] - out.b.offset) + (c[k] - out.c.offset);
    out.d = greatest(both) + rounding(out.b) + rounding(out.c);
    for (int lane = 0; lane < EIGHT; ++lane)
        if (facets[lane] < 0) out.d[lane] = -std::numeric_limits<float>::infinity();
}

}  // namespace corpuscle::gas
