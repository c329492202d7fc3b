// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/collision_cells.hpp"
#include "gas/envelope.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/flight/flight.hpp"
#include "gas/gas_phase.hpp"
#include "gas/particles.hpp"
#include "gas/wall_load/roughness.hpp"

namespace corpuscle::gas {

/// What the particles of one gas hold in one room.
struct Holding {
    double count = 0, translational = 0, internal = 0;  ///< [-], [J], [J]
    double mass = 0;                                    ///< [kg]
    Vec3 momentum = Vec3::Zero();                       ///< [N s]

    [[nodiscard]] double all() const { return translational + internal; }
    /// That of the motion as a whole, P²/(2 m).                                               [J]
    [[nodiscard]] double bulk() const {
        return mass > 0.0 ? 0.5 * momentum.squaredNorm() / mass : 0.0;
    }
    /// The same where velocities are taken about w, E - P·w + m w²/2.          [m/s] -> [J]
    [[nodiscard]] double about(const Vec3& w) const {
        return all() - momentum.dot(w) + 0.5 * mass * w.squaredNorm();
    }
    Holding& operator+=(const Holding& o) {
        count += o.count;
        translational += o.translational;
        internal += o.internal;
        mass += o.mass;
        momentum += o.momentum;
        return *this;
    }
};

/// A bag's gas as particles, and initial air that is none (IAIR 1, -1): a pressure in each room.
///
/// A step: facet lists, collisions (particle_collide.cpp), inflow, flight, and what leaves or cools
/// (particle_outflow.cpp).
class ParticleGas final : public GasPhase {
public:
    /// @param bag  outlives this
    ParticleGas(Envelope& bag, std::span<const Curve> curves, const Points& x, std::uint64_t seed);

    void add_load(const Points& x, Points& f) override;
    [[nodiscard]] Vec3 load_on(Index node) const override {
        return air_force_.empty() ? Vec3(Vec3::Zero()) : air_force_[node];
    }
    void book_load(const Points& v_mid, double span) override;

    void prepare(double dt, const Points& x_0, const Points& x_1) override;
    void collide(double dt, const Points& x) override;
    void inject(double t, double dt, const Points& x_0, const Points& x_1) override;
    void fly(double t, double dt, const Points& x_0, const Points& x_1) override;
    /// Where particles are: their motion becomes heat, but for that at wall[room].          [m/s]
    void freeze(std::span<const Vec3> wall);

    [[nodiscard]] double stable_step() const override { return cells_.stable_step(); }
    [[nodiscard]] double energy() const override;
    [[nodiscard]] double pressure(std::size_t room) const override {
        return bag_.air.empty() ? 0.0 : bag_.air[room].pressure();
    }
    void describe(GasState& now) const override;
    void add_rooms(std::span<const double> volume, std::span<const Index> sum_of,
                   std::span<ChamberSum> sums) const override;

    [[nodiscard]] std::vector<Holding> holdings() const;  ///< rooms × species
    [[nodiscard]] const Particles& particles() const { return particles_; }
    [[nodiscard]] const Mixture& mixture() const { return collider_.mixture(); }
    [[nodiscard]] std::size_t lost() const { return lost_; }
    /// The first lost particles, with time and place.
    [[nodiscard]] const std::vector<std::string>& losses() const { return losses_; }
    [[nodiscard]] std::size_t hits() const { return hits_; }
    [[nodiscard]] std::size_t flights() const { return flights_; }
    /// Groups whose energy belonged to no temperature.
    [[nodiscard]] std::size_t unrelaxed() const { return unrelaxed_; }
    [[nodiscard]] std::uint64_t collision_steps() const { return cells_.steps(); }
    [[nodiscard]] std::size_t list_builds() const { return lists_.builds() + cells_.list_builds(); }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(lists_, cells_, particles_, roughness_, looked_at_, unrelaxed_, lost_, hits_,
                flights_, losses_);
    }

private:
    void fill_with_air(const Points& x, std::uint64_t seed);
    [[nodiscard]] std::vector<double> air_pressures() const;
    void let_in(const Entry& entry, double t, double dt, const Points& x_0, const Points& x_1);
    void exchange_heat_with_air(std::vector<Heat>& heat, std::vector<double>& after);
    void return_heat_to_air(std::span<const double> expected);
    void check_collided(double thermal) const;
    void look_inside(double dt, const Points& x_0, const Points& x_1);
    void look_at_openings();
    void pass_on();
    void let_out(double dt);
    void pass_air(double t, double dt);
    void cool(double t, double dt);
    void book_lost(double t);
    [[noreturn]] void stop_for(std::size_t particle, const char* when) const;
    [[noreturn]] void stop_for_air(std::size_t room) const;

    Envelope& bag_;
    FacetLists lists_;   ///< for flight: cells of the facets' size
    double facet_size_;  ///< mean edge of a facet                                     [m]
    Collider collider_;
    CollisionCells cells_;  ///< hold enough particles
    Roughness roughness_;
    Particles particles_;
    std::vector<Entry> entries_;  ///< of this step
    std::vector<double> born_;    ///< shares of the step at which they enter
    FlightResult flight_;
    std::vector<std::size_t> gone_;   ///< rows that left in this step
    std::vector<Inside> at_opening_;  ///< in this step
    double holes_of_air_ = 0.0;       ///< internal openings that initial air passes
    std::uint64_t looked_at_ = 0;     ///< collision step of the rooms' mean states
    Points air_force_;                ///< N × 3, of initial air                        [N]
    std::size_t unrelaxed_ = 0, lost_ = 0, hits_ = 0, flights_ = 0;
    std::vector<std::string> losses_;
};

}  // namespace corpuscle::gas
