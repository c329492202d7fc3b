// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/particles.hpp"
#include "gas/species.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

/// The particles of one group, gathered, and seen from their common centre: what collision models
/// work on. Keeps its memory from group to group.
class Swarm {
public:
    void gather(std::span<const Index> rows, const Mixture& mixture, const Particles& particles);

    /// Writes v = U + c and e back.
    void scatter(std::span<const Index> rows, Particles& particles) const;

    [[nodiscard]] std::size_t size() const { return c.size(); }
    [[nodiscard]] bool is_mixed() const { return is_mixed_; }

    /// Sum of m c² / 2.                                                                    [J]
    [[nodiscard]] double translational() const;
    /// Sum of e.                                                                            [J]
    [[nodiscard]] double internal() const;

    /// Internal energy at equilibrium, as it grows with temperature.
    [[nodiscard]] const EnergyPolynomial& internal_at() const { return internal_at_; }

    /// c *= factor.
    void scale(double factor);

    /// Every particle collides with one other: pairs are drawn at random and leave in a random
    /// direction.
    ///     c1' = C + m2/(m1+m2) g n,  c2' = C - m1/(m1+m2) g n,  g = |c1 - c2|, n even on the
    ///     sphere
    void collide_pairs(Random& draw);

    Vec3 U;                    ///< mean velocity, by mass                               [m/s]
    double mass = 0.0;         ///< of all                                               [kg]
    std::vector<Vec3> c;       ///< v - U, or less where a model takes out more          [m/s]
    std::vector<double> m, e;  ///< [kg], [J]
    std::vector<std::int32_t> species;

private:
    bool is_mixed_ = false;
    EnergyPolynomial internal_at_;
    std::vector<Index> shuffled_;
};

}  // namespace corpuscle::gas
