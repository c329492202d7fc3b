// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/rim.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "contact/broad_phase/bounds.hpp"
#include "solver/base/simd.hpp"

namespace corpuscle::contact {
std::vector<Index> rim_of(std::span<const Triangle> triangles, std::vector<Index>& forks) {
    forks.clear();
    using Edge = std::pair<Index, Index>;
    std::vector<Edge> edges, rim;  // by where they begin
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(t[k], t[(k + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return {};
    for (const auto& [from, to] : edges)
        if (!std::binary_search(edges.begin(), edges.end(), Edge(to, from)))
            rim.emplace_back(from, to);
    for (std::size_t i = 1; i < rim.size(); ++i)
        if (rim[i].first == rim[i - 1].first) forks.push_back(rim[i].first);
    std::vector<Index> corners;
    if (rim.empty() || !forks.empty()) return corners;
    auto at = rim.begin();
    do {  // as many edges end at a corner as begin there: one
        corners.push_back(at->first);
        at = std::lower_bound(rim.begin(), rim.end(), Edge(at->second, 0));
    } while (at != rim.begin());
    return corners.size() == rim.size() ? corners : std::vector<Index>();
}

float least_height_square(const PlanePoints& at, std::span<const Triangle> triangles) {
    float least = INFINITY;
    for (const auto& [a, b, c] : triangles) {
        const float u_x = at.x[b] - at.x[a], u_y = at.y[b] - at.y[a], v_x = at.x[c] - at.x[a],
                    v_y = at.y[c] - at.y[a], w_x = v_x - u_x, w_y = v_y - u_y;
        const float twice_area = u_x * v_y - u_y * v_x;
        if (!(twice_area > 0.0F)) return 0.0F;
        const float longest =
            std::max({u_x * u_x + u_y * u_y, v_x * v_x + v_y * v_y, w_x * w_x + w_y * w_y});
        least = std::min(least, twice_area * twice_area / longest);
    }
    return least;
}

namespace {

/// Box round corners first ... last, and `margin` more.
Bounds box_of(const PlanePoints& at, std::int32_t first, std::int32_t last, float margin) {
    const auto [left, right] = std::minmax_element(&at.x[first], &at.x[last] + 1);
    const auto [lower, upper] = std::minmax_element(&at.y[first], &at.y[last] + 1);
    return {{*left - margin, *lower - margin, 0.0F}, {*right + margin, *upper + margin, 0.0F}};
}

}  // namespace

float rim_distance_square(const PlanePoints& at, std::size_t corners, float most) {
    thread_local PlanePoints rim;  // and the first corner again: edge i goes from i to i + 1
    for (const auto& [from, to] : {std::pair(&at.x, &rim.x), std::pair(&at.y, &rim.y)}) {
        to->assign(from->begin(), from->begin() + static_cast<std::ptrdiff_t>(corners));
        to->resize(corners + EIGHT + 1, from->front());
    }
    const auto last = static_cast<std::int32_t>(corners) - 1;
    thread_local std::vector<EightBounds> boxes;  // of eight edges each
    boxes.assign(corners / (EIGHT * EIGHT) + 1, {});
    for (std::int32_t j = 0, b = 0; j <= last; j += EIGHT, ++b)
        boxes[b / EIGHT].set(b % EIGHT, box_of(rim, j, j + EIGHT, 0.0F));
    const float reach = 1.001F * std::sqrt(most);  // beyond rounding
    Eight least = all_eight(most);
    for (std::int32_t i = 0; i <= last; ++i) {
        const std::int32_t before = i > 0 ? i - 1 : last, after = i < last ? i + 1 : 0;
        const float along_x = rim.x[i + 1] - rim.x[i], along_y = rim.y[i + 1] - rim.y[i];
        EightBits crossing{};
        const auto meet = [&](std::int32_t j) {
            const EightBits edge = j + EightBits{0, 1, 2, 3, 4, 5, 6, 7};
            const Eight from_x = load_eight(&rim.x[j]), from_y = load_eight(&rim.y[j]);
            const Eight edge_x = load_eight(&rim.x[j + 1]) - from_x,
                        edge_y = load_eight(&rim.y[j + 1]) - from_y, x = rim.x[i] - from_x,
                        y = rim.y[i] - from_y;
            const EightBits is_mine = (edge == i) | (edge == before) | (edge > last);
            const Eight share =
                share_of((x * edge_x + y * edge_y) / (edge_x * edge_x + edge_y * edge_y));
            const Eight off_x = x - share * edge_x, off_y = y - share * edge_y;
            least = is_mine ? least : least_of(off_x * off_x + off_y * off_y, least);
            // On which side of theirs my ends are, and theirs of mine
            const Eight turn = along_x * edge_y - along_y * edge_x;
            const Eight begins = x * edge_y - y * edge_x, theirs = x * along_y - y * along_x;
            crossing |= ((begins > 0.0F) ^ (begins + turn > 0.0F)) &
                        ((theirs > 0.0F) ^ (theirs + turn > 0.0F)) & ~(is_mine | (edge == after));
        };
        const Bounds box = box_of(rim, i, i + 1, reach);
        for (std::size_t k = 0; k < boxes.size(); ++k)
            for (unsigned bits = boxes[k].overlapping(box); bits != 0; bits &= bits - 1)
                meet(EIGHT * (EIGHT * static_cast<std::int32_t>(k) + std::countr_zero(bits)));
        if (bits_of(crossing) != 0) return 0.0F;
    }
    return least_lane(least);
}

}  // namespace corpuscle::contact
