// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/swarm.hpp"

#include <numeric>
#include <utility>

namespace corpuscle::gas {

void Swarm::gather(std::span<const Index> rows, const Mixture& mixture,
                   const Particles& particles) {
    const std::size_t n = rows.size();
    c.resize(n);
    m.resize(n);
    e.resize(n);
    species.resize(n);
    mass = 0.0;
    is_mixed_ = false;
    internal_at_ = {};
    Vec3 momentum = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        const Index row = rows[i];
        species[i] = particles.species[row];
        is_mixed_ |= species[i] != species[0];
        c[i] = particles.v[row];
        e[i] = particles.e[row];
        m[i] = mixture.particle_mass(species[i]);
        mass += m[i];
        momentum += m[i] * c[i];
        internal_at_ += mixture.particle_internal(species[i]);
    }
    U = momentum / mass;

    // Twice: what rounding left in the first mean would weigh in a jet much faster than it is hot.
    Vec3 rest = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        c[i] -= U;
        rest += m[i] * c[i];
    }
    rest /= mass;
    U += rest;
    for (Vec3& ci : c) ci -= rest;
}

void Swarm::scatter(std::span<const Index> rows, Particles& particles) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        particles.v[rows[i]] = U + c[i];
        particles.e[rows[i]] = e[i];
    }
}

double Swarm::translational() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size(); ++i) sum += m[i] * c[i].squaredNorm();
    return 0.5 * sum;
}

double Swarm::internal() const {
    return std::accumulate(e.begin(), e.end(), 0.0);
}

void Swarm::scale(double factor) {
    for (Vec3& ci : c) ci *= factor;
}

void Swarm::collide_pairs(Random& draw) {
    const auto n = static_cast<std::uint32_t>(size());
    shuffled_.resize(n);
    std::iota(shuffled_.begin(), shuffled_.end(), 0);
    for (std::uint32_t i = 0; i + 1 < n; i += 2) {
        std::swap(shuffled_[i], shuffled_[i + draw.below(n - i)]);
        std::swap(shuffled_[i + 1], shuffled_[i + 1 + draw.below(n - i - 1)]);
        const Index p = shuffled_[i], q = shuffled_[i + 1];
        const double share = m[q] / (m[p] + m[q]);
        const Vec3 apart = c[p] - c[q];
        const Vec3 centre = c[q] + (1.0 - share) * apart;
        const Vec3 turned = apart.norm() * draw.direction();
        c[p] = centre + share * turned;
        c[q] = centre - (1.0 - share) * turned;
    }
}

}  // namespace corpuscle::gas
