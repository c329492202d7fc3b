// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/impulse_store.hpp"

#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

ImpulseStore::ImpulseStore(std::size_t node_count, std::span<const Index> nodes,
                           std::span<const std::uint8_t> held, double time)
    : nodes_(nodes.begin(), nodes.end()),
      time_(time),
      owed_(node_count, Vec3::Zero()),
      force_(node_count, Vec3::Zero()) {
    for (const Index n : nodes_) held_.push_back(held[n]);
}

void ImpulseStore::receive(const FlightResult& flight, std::span<const Triangle> triangles) {
    for (const auto& hits : flight.hits)
        for (const Hit& hit : hits)
            for (int c = 0; c < 3; ++c) owed_[triangles[hit.facet][c]] += hit.at[c] * hit.impulse;
}

void ImpulseStore::release(double span, std::span<Vec3> f) {
    const double late = -std::expm1(-span / time_);
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        const Index n = nodes_[i];
        const double share = held_[i] ? 1.0 : late;
        force_[n] = share / span * owed_[n];
        owed_[n] -= share * owed_[n];
        f[n] += force_[n];
    });
}

double ImpulseStore::work(std::span<const Vec3> v_mid, double span) const {
    return span * parallel::sum(nodes_.size(), 0.0, [&](std::size_t i) {
               return force_[nodes_[i]].dot(v_mid[nodes_[i]]);
           });
}

Vec3 ImpulseStore::owed() const {
    return parallel::sum(nodes_.size(), Vec3(Vec3::Zero()),
                         [&](std::size_t i) { return owed_[nodes_[i]]; });
}

}  // namespace corpuscle::gas
