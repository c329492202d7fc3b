// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/expected_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// More: quieter, but a jet's foot is blurred over more cloth until the owed impulse corrects it.
constexpr int PASSES = 10;

}  // namespace

ExpectedPressure::ExpectedPressure(std::size_t node_count, const Enclosure& enclosure, double time)
    : nodes_(enclosure.nodes().begin(), enclosure.nodes().end()),
      time_(time),
      force_(nodes_.size(), 0.0),
      pressure_(nodes_.size(), 0.0),
      field_(nodes_.size()),
      next_(nodes_.size()) {
    std::vector<Index> place(node_count, -1);
    for (std::size_t i = 0; i < nodes_.size(); ++i) place[nodes_[i]] = static_cast<Index>(i);
    std::vector<std::pair<Index, Index>> edges;  // both ways; each edge belongs to two triangles
    for (const Triangle& t : enclosure.triangles())
        for (int c = 0; c < 3; ++c) edges.emplace_back(place[t[c]], place[t[(c + 1) % 3]]);
    for (std::size_t e = edges.size(); e-- > 0;)
        edges.emplace_back(edges[e].second, edges[e].first);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    start_.assign(nodes_.size() + 1, 0);
    for (const auto& [from, to] : edges) {
        ++start_[from + 1];
        neighbour_.push_back(to);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) start_[i + 1] += start_[i];
}

void ExpectedPressure::update(double span, std::span<const Vec3> arrived,
                              std::span<const Vec3> area) {
    const double fresh = -std::expm1(-span / time_);
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        const Vec3& a = area[nodes_[i]];
        const double size = a.norm();
        const double push = size > 0.0 ? arrived[nodes_[i]].dot(a) / size : 0.0;
        force_[i] += fresh * (push / span - force_[i]);
        field_[i] = {force_[i], size};
    });
    spread();
    if (less_.empty()) return;
    parallel::for_each(nodes_.size(), [&](std::size_t i) { pressure_[i] *= 1.0 - less_[i]; });
}

void ExpectedPressure::feel_motion(std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
                                   std::span<const Vec3> area, double share_per_speed) {
    less_.resize(nodes_.size());
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        const Index n = nodes_[i];
        const double swept = (x_1[n] - x_0[n]).dot(area[n]) / dt;
        const double size = area[n].norm();
        less_[i] = size > 0.0 ? swept / size : 0.0;
        field_[i] = {swept, size};
    });
    spread();
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        less_[i] = share_per_speed * (less_[i] - pressure_[i]);
    });
}

void ExpectedPressure::spread() {
    for (int pass = 0; pass < PASSES; ++pass) {
        parallel::for_each(nodes_.size(), [&](std::size_t i) {
            ForceAndArea sum = field_[i];
            for (Index k = start_[i]; k < start_[i + 1]; ++k) {
                sum.force += field_[neighbour_[k]].force;
                sum.area += field_[neighbour_[k]].area;
            }
            const double each = 1.0 / static_cast<double>(1 + start_[i + 1] - start_[i]);
            next_[i] = {each * sum.force, each * sum.area};
        });
        field_.swap(next_);
    }
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        pressure_[i] = field_[i].area > 0.0 ? field_[i].force / field_[i].area : 0.0;
    });
}

void ExpectedPressure::begin_with(double pressure, std::span<const Vec3> area) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        force_[i] = pressure * area[nodes_[i]].norm();
        pressure_[i] = pressure;
    }
}

}  // namespace corpuscle::gas
