// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/orifices.hpp"

#include <algorithm>
#include <cmath>

#include "gas/crossing.hpp"

namespace corpuscle::gas {
namespace {

constexpr double OFF_THE_WALL =
    1e-3;  ///< of the facets' size: inside, yet at the wall for any purpose

}  // namespace

Orifices::Orifices(const std::vector<OrificeCard>& cards, const std::vector<Triangle>& outward,
                   const std::vector<Triangle>& given, const std::vector<Index>& shell)
    : cards_(cards), on_(cards.size()) {
    for (std::size_t o = 0; o < cards_.size(); ++o)
        for (std::size_t t = 0; t < outward.size(); ++t) {
            const Triangle& c = outward[t];
            const bool touches = cards_[o].shell >= 0
                                     ? shell[t] == cards_[o].shell
                                     : std::find(c.begin(), c.end(), cards_[o].node) != c.end();
            if (touches) on_[o].push_back({c, given[t]});
        }
}

Vec3 Orifices::place(std::size_t orifice, std::span<const Vec3> x) const {
    const OrificeCard& card = cards_[orifice];
    if (on_[orifice].empty()) return x[card.node];
    Vec3 centre = Vec3::Zero(), out = Vec3::Zero();
    double area = 0.0;
    for (const Facet& facet : on_[orifice]) {
        const auto& [a, b, c] = facet.outward;
        const Vec3 part = vector_area(x[a], x[b], x[c]);
        centre += part.norm() / 3.0 * (x[a] + x[b] + x[c]);
        area += part.norm();
        out += part;
    }
    const Vec3 at = card.shell >= 0 ? Vec3(centre / area) : x[card.node];
    return at - OFF_THE_WALL * std::sqrt(area) * out.normalized();
}

void Orifices::axes(std::span<const Vec3> x, std::vector<Vec3>& out) const {
    out.resize(size());
    for (std::size_t o = 0; o < size(); ++o) {
        out[o] = cards_[o].direction.value_or(Vec3::Zero());
        if (cards_[o].shell < 0) continue;
        Vec3 normal = Vec3::Zero();
        for (const Facet& facet : on_[o])
            normal += vector_area(x[facet.given[0]], x[facet.given[1]], x[facet.given[2]]);
        out[o] = cards_[o].normal_sign * normal.normalized();
    }
}

int Orifices::passed_by_fabric(const FacetLists& lists, std::span<const Vec3> x_0,
                               std::span<const Vec3> x_1) const {
    for (std::size_t o = 0; o < size(); ++o) {
        if (!on_[o].empty()) continue;
        const Path path{place(o, x_0), place(o, x_1)};
        for (const Vec3& end : {path.at_0, path.at_1})
            for (const Index facet : lists.in(lists.grid().cell_of(end)))
                if (cross(path, lists.triangles()[facet], x_0.data(), x_1.data()))
                    return static_cast<int>(o);
    }
    return -1;
}

}  // namespace corpuscle::gas
