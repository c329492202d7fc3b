// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/impulse_store.hpp"

#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

ImpulseStore::ImpulseStore(std::size_t node_count, std::span<const Index> nodes,
                           const Enclosure& enclosure, std::span<const std::uint8_t> held,
                           double time, bool is_quiet)
    : nodes_(nodes.begin(), nodes.end()),
      surface_(enclosure.nodes().begin(), enclosure.nodes().end()),
      is_quiet_(node_count, 0),
      time_(time),
      expected_(node_count, enclosure, time),
      arrived_(node_count, Vec3::Zero()),
      owed_(node_count, Vec3::Zero()),
      beyond_(node_count, Vec3::Zero()),
      force_(node_count, Vec3::Zero()) {
    for (const Index n : nodes_) held_.push_back(held[n]);
    for (const Index n : surface_) is_quiet_[n] = is_quiet && !held[n];
    if (!is_quiet) expected_.stop();
}

void ImpulseStore::receive(const FlightResult& flight, std::span<const Triangle> triangles) {
    for (const auto& hits : flight.hits)
        for (const Hit& hit : hits)
            for (int c = 0; c < 3; ++c)
                arrived_[triangles[hit.facet][c]] += hit.at[c] * hit.impulse;
}

void ImpulseStore::begin_with(double pressure, std::span<const Vec3> area) {
    expected_.begin_with(pressure, area);
}

void ImpulseStore::release(double span, std::span<const Vec3> area, std::span<Vec3> f) {
    const double late = -std::expm1(-span / time_), later = -std::expm1(-span / (PATIENCE * time_));
    if (expected_.is_on()) expected_.update(span, arrived_, area);
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        const Index n = nodes_[i];
        (is_quiet_[n] ? beyond_[n] : owed_[n]) += arrived_[n];
        arrived_[n].setZero();
        const double share = held_[i] ? 1.0 : late;
        const Vec3 given = share * owed_[n], corrected = later * beyond_[n];
        owed_[n] -= given;
        beyond_[n] -= corrected;
        force_[n] = (given + corrected) / span;
    });
    if (expected_.is_on())
        parallel::for_each(surface_.size(), [&](std::size_t i) {
            const Index n = surface_[i];
            if (!is_quiet_[n]) return;
            const Vec3 push = expected_[i] * area[n];
            beyond_[n] -= span * push;
            force_[n] += push;
        });
    parallel::for_each(nodes_.size(), [&](std::size_t i) { f[nodes_[i]] += force_[nodes_[i]]; });
}

double ImpulseStore::work(std::span<const Vec3> v_mid, double span) const {
    return span * parallel::sum(nodes_.size(), 0.0, [&](std::size_t i) {
               return force_[nodes_[i]].dot(v_mid[nodes_[i]]);
           });
}

Vec3 ImpulseStore::owed() const {
    return parallel::sum(nodes_.size(), Vec3(Vec3::Zero()), [&](std::size_t i) {
        const Index n = nodes_[i];
        return Vec3(arrived_[n] + owed_[n] + beyond_[n]);
    });
}

}  // namespace corpuscle::gas
