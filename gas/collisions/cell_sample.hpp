// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gas/collisions/deviation.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

/// Vectors by component. Filled up with zeros to a multiple of four, so that sums need no
/// remainder.
struct Columns {
    std::array<std::vector<double>, 3> along;

    [[nodiscard]] Vec3 operator[](std::size_t i) const {
        return {along[0][i], along[1][i], along[2][i]};
    }
    void set(std::size_t i, const Vec3& a) {
        for (int k = 0; k < 3; ++k) along[k][i] = a[k];
    }
    void resize(std::size_t n) {
        for (auto& column : along) column.resize(n);
    }
};

/// The particles of one group, gathered, and seen from their common centre: what collision models
/// work on. Keeps its memory from group to group.
class CellSample {
public:
    /// Everything but places.
    void gather(std::span<const Index> rows, const Mixture& mixture, const Particles& particles);

    /// dx. After gather().
    void gather_places(std::span<const Index> rows, const Particles& particles);

    /// Writes v = U + c and e back.
    void scatter(std::span<const Index> rows, Particles& particles) const;

    [[nodiscard]] std::size_t size() const { return n_; }
    [[nodiscard]] bool is_mixed() const { return is_mixed_; }

    [[nodiscard]] double least_mass() const;  ///< of a particle                        [kg]

    /// Sum of m c² / 2.                                                                    [J]
    [[nodiscard]] double translational() const;
    /// Sum of e.                                                                            [J]
    [[nodiscard]] double internal() const;
    /// Sum of m a bᵀ, over all particles.
    [[nodiscard]] Mat3 moment(const Columns& a, const Columns& b) const;

    /// Internal energy at equilibrium, as it grows with temperature.
    [[nodiscard]] const EnergyPolynomial& internal_at() const { return internal_at_; }
    /// What it can give when its temperature falls from T and its kinds of gas give by their heat
    /// capacities at T: until the first of them holds nothing.                              [J]
    [[nodiscard]] double can_give(double T, const Mixture& mixture) const;
    /// Sets the sum of e to its equilibrium at T and `more`, by heat capacities. Each e comes closer
    /// to its kind's mean, and none falls below zero (deviation.hpp).
    /// @param more    at least -can_give()                                                 [J]
    /// @param memory  share of deviations that is kept at most                              [-]
    void set_internal(double T, double more, double memory, const Mixture& mixture);

    void scale(double factor);         ///< c *= factor
    void add_internal(double energy);  ///< e += energy m / mass
    /// Gives `heat` to e alone, where it cannot be shared: by mass; what is taken, by a factor on e.
    /// More than e holds is not taken but `refused`.
    void heat_internal();
    void transform(const Mat3& A);     ///< c = A c
    void add_gradient(const Mat3& G);  ///< c += G dx

    /// Every particle collides with one other: pairs are drawn at random and leave in a random
    /// direction.
    ///     c1' = C + m2/(m1+m2) g n,  c2' = C - m1/(m1+m2) g n,  g = |c1 - c2|, n even on the
    ///     sphere
    void collide_pairs(Random& draw);

    /// The same for unlike particles alone, each with the nearest that is left: over so short a
    /// distance pairs conduct little heat. After gather_places().
    void collide_unlike(Random& draw);

    /// Two particles leave in a random direction, as above.
    void collide_pair(std::size_t p, std::size_t q, Random& draw);
    /// Two spheres that touch along the unit vector n: what they have towards each other turns
    /// round.
    void bounce(std::size_t p, std::size_t q, const Vec3& n);

    Vec3 U;                 ///< mean velocity, by mass                                   [m/s]
    double mass = 0.0;      ///< of all                                                   [kg]
    double heat = 0.0;      ///< that it gets at this step                                [J]
    double refused = 0.0;   ///< of a heat below 0: what it has not given                 [J]
    Columns c;              ///< v - U, or less where a model takes out more              [m/s]
    Columns dx;             ///< place from the centre of mass                            [m]
    std::vector<double> e;  ///< [J]

private:
    void centre(Columns& a, Vec3& mean) const;
    [[nodiscard]] std::size_t nearest_unlike(std::size_t p) const;

    std::size_t n_ = 0, padded_ = 0;
    std::vector<double> m_;              ///< [kg]
    std::vector<std::int32_t> species_;  ///< the first of each kind (Mixture::kind)
    bool is_mixed_ = false;
    EnergyPolynomial internal_at_;
    std::vector<Index> shuffled_;
    std::vector<double> unpaired_;  ///< kind of those that have no partner yet
    struct Kind {
        double count = 0.0, internal = 0.0, least = INF;  ///< [-]; of e: sum, least [J]
        Deviation<double> deviation{};
    };
    std::vector<Kind> kinds_;  ///< of a mixture
};

}  // namespace corpuscle::gas
