// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/area_shares.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace corpuscle::contact {
namespace {

constexpr double DEEP = 0.5;       ///< gap over rest, below which an area only grows to its first
constexpr double LEAST = 1e-3;     ///< area over the first one
constexpr double MOST = 4.0;       ///< likewise: all that its nodes have
constexpr int PASSES = 2;          ///< a step; the areas live on
constexpr double STRONGEST = 2.0;  ///< change of an area in a pass

}  // namespace

AreaShares::AreaShares(const Cloth& cloth)
    : cloth_(cloth),
      area_(cloth.inverse_mass.size(), 0.0),
      normal_(area_.size(), Vec3::Zero()),
      vector_area_(cloth.triangles.size()),
      in_contact_(area_.size(), 0),
      sum_(area_.size()),
      looked_at_(area_.size(), 0) {
    for (const Triangle& t : cloth.triangles) {
        const auto& x = cloth.reference_x;
        const double third = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm() / 6.0;
        for (const Index n : t) area_[n] += third;
    }
}

void AreaShares::find(const Points& x, const ColumnColouring& columns, ContactList& contacts) {
    if (columns.size() == 0) return;
    set_sides(x, contacts);
    for (int pass = 0; pass < PASSES; ++pass) {
        add_up(columns, contacts);
        contacts.for_each_apart([&](Contact& c) {
            if (c.exposure == 0.0) return;
            if (c.is_known && c.gap < DEEP * c.rest) {
                if (pass == 0)
                    c.area = std::max(c.area, std::min(STRONGEST * c.area, first_area(c)));
                return;
            }
            std::array<double, 2> ratio{};
            for (int i = 0; i < 4; ++i) {
                double sum = sum_[c.node[i]][c.sides >> i & 1U];
                if (c.gap >= c.rest) sum += std::abs(c.weight[i]) * c.area * c.exposure;
                if (c.weight[i] != 0.0 && sum > 0.0)
                    ratio[c.weight[i] > 0.0 ? 0 : 1] +=
                        std::abs(c.weight[i]) * area_[c.node[i]] / sum;
            }
            c.area *= std::clamp(std::min(ratio[0], ratio[1]), 1.0 / STRONGEST, STRONGEST);
            const double first = first_area(c);
            c.area = std::clamp(c.area, LEAST * first, MOST * first);
        });
    }
}

/// On which side of its nodes each contact is, from these nodes' normals; and a first area for those
/// that are new.
void AreaShares::set_sides(const Points& x, ContactList& contacts) {
    constexpr std::size_t CHUNKS = 8, A_CHUNK = 256;
    const auto mark = [&](std::size_t chunk) {
        for (const ContactList::Brief& brief : contacts.briefs(chunk))
            for (const Index node : brief.node)
                std::atomic_ref(in_contact_[node]).store(1, std::memory_order_relaxed);
    };
    const auto measure = [&](std::size_t t) {
        const Triangle& n = cloth_.triangles[t];
        if ((in_contact_[n[0]] | in_contact_[n[1]] | in_contact_[n[2]]) != 0)
            vector_area_[t] = (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]);
    };
    const auto sum_up = [&](std::size_t i) {
        const Index node = cloth_.nodes[i];
        if (std::exchange(in_contact_[node], 0) == 0) return;
        Vec3 sum = Vec3::Zero();
        for (const Index t : cloth_.triangles_of(node)) sum += vector_area_[t];
        normal_[node] = sum;
    };
    const auto set = [&](std::size_t chunk) {
        for (Contact& c : contacts.chunk(chunk)) set_side(c);
    };
    parallel::in_turn(parallel::each(contacts.chunks(), mark, parallel::Cut(CHUNKS)),
                      parallel::each(cloth_.triangles.size(), measure, parallel::Cut(A_CHUNK)),
                      parallel::each(cloth_.nodes.size(), sum_up, parallel::Cut(A_CHUNK)),
                      parallel::each(contacts.chunks(), set, parallel::Cut(1)));
}

/// A quarter of the area of the nodes of its smaller place.
double AreaShares::first_area(const Contact& c) const {
    std::array<double, 2> mean{};
    for (int i = 0; i < 4; ++i)
        mean[c.weight[i] > 0.0 ? 0 : 1] += std::abs(c.weight[i]) * area_[c.node[i]];
    return 0.25 * std::min(mean[0], mean[1]);
}

void AreaShares::set_side(Contact& c) const {
    c.sides = 0;
    c.is_known = c.area > 0.0 && c.exposure > 0.0;
    for (int i = 0; i < 4; ++i) {
        const bool is_first = c.weight[i] > 0.0;
        const bool is_above = (normal_[c.node[i]].dot(c.normal) > 0.0) != is_first;
        c.sides |= static_cast<std::uint8_t>((is_above ? 1U : 0U) << static_cast<unsigned>(i));
    }
    if (!c.is_known) c.area = first_area(c);
}

void AreaShares::add_up(const ColumnColouring& columns, const ContactList& contacts) {
    ++look_;
    columns.for_each(contacts, [&](const Contact& c) {
        for (int i = 0; i < 4; ++i) {
            if (is_first_look(c.node[i])) sum_[c.node[i]] = {};
            if (c.gap < c.rest)
                sum_[c.node[i]][c.sides >> i & 1U] += std::abs(c.weight[i]) * c.area * c.exposure;
        }
    });
}

}  // namespace corpuscle::contact
