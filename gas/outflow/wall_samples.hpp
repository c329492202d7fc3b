// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "gas/enclosure/bag_walls.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/outflow/gas_state.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"
#include "gas/wall_load/wall_hits.hpp"

namespace corpuscle::gas {

/// The state of the gas at parts of the wall, from the particles that hit them there.
///
/// The wall of each room is cut into patches, each of one part of the bag; openings have samples of
/// their own round them. A sample has two memories of its hits, a quick one (a thousand hits, or
/// `longest`) and a steady one, 15 times `longest`, that begins anew where the quick one differs from
/// it by more than chance. It remembers what hits brought,
///
///     p_hits = sum J / integral A dt,
///
/// how that went with the pressure of the room, and the hits' energy. Hits scatter, p_hits with the
/// variance s² = sum J² / 2 / (integral)². Whether the gas differs from place to place shows between
/// the patches of a room: the variance of their p_hits about p_room beyond that of chance, S². The
/// best estimate of both is [James & Stein 1961; Efron & Morris 1973]
///
///     p = p_room + (p_hits - p_room) S² / (S² + s²),       error of p: s S / sqrt(S² + s²).
///
/// Gas that is stirred has S = 0 and everywhere the mean state of its room, without scatter; a
/// front, a jet or a part of the bag that gas has not reached has the state of its own hits. Beside a
/// hole that draws, hits press more than the gas has pressure; p_hits is without that (docs/theory/walls.md).
class WallSamples {
public:
    WallSamples() = default;
    /// @param longest  most that the quick memory of a sample reaches back                                      [s]
    /// @param passes   by facet: 1 where particles may pass without a full bounce
    WallSamples(std::shared_ptr<const WettedSurface> surface, const BagWalls& walls,
                std::span<const Species> species, std::span<const double> particle_mass,
                double gas_constant, double longest, std::span<const char> passes,
                std::span<const Vec3> x);

    /// What a hole beside a sample draws.
    struct Drawn {
        double flux = 0.0;  ///< [kg/(m² s)]
        double size = 1.0;  ///< of the hole, square root of its area                        [m]
    };

    [[nodiscard]] bool empty() const { return samples_.empty(); }
    /// Sides of each patch; patches do not cross the borders of parts or rooms.
    [[nodiscard]] const std::vector<std::vector<Index>>& patches() const { return patches_; }
    /// One more sample, over sides of one room. Returns its row; patches are the first rows.
    /// @param drifts  gas may flow past it, to a hole
    Index add(std::vector<Index> sides, bool drifts = false);

    void measure(std::span<const Vec3> x);  ///< areas, where no flight does
    /// Takes in a flight's hits, as they are to the walls, which go from x_0 to x_1. rooms: mean
    /// states at t.
    void receive(const WallHits& hits, double dt, std::span<const Vec3> x_0,
                 std::span<const Vec3> x_1, std::span<const Inside> rooms,
                 const Particles& particles);

    /// The gas at a sample: that of its room but for what its hits tell; come to rest, isentropically,
    /// from its drift along the wall, if the sample is one of a hole.
    /// @param drawn  what a hole beside it draws
    void state(std::size_t sample, const Inside& room, const Drawn& drawn, Inside& out) const;
    void state(std::size_t sample, const Inside& room, Inside& out) const {
        state(sample, room, {}, out);
    }

    [[nodiscard]] Index room(std::size_t sample) const { return samples_[sample].room; }
    [[nodiscard]] const std::vector<Index>& points(std::size_t sample) const {
        return samples_[sample].points;
    }
    [[nodiscard]] const std::vector<Index>& sides(std::size_t sample) const {
        return samples_[sample].sides;
    }
    [[nodiscard]] double area(std::size_t sample) const { return samples_[sample].area; }
    /// Has gas come to it lately?
    [[nodiscard]] bool is_reached(std::size_t sample) const {
        return samples_[sample].quick.count > 0.0;
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Sample& sample : samples_) archive(sample);
        archive(spread_);
    }

private:
    /// A pressure and its variance by chance.                                  [Pa], [Pa²]
    struct Known {
        double pressure, variance;
    };
    /// Sums over hits, of late.
    struct Memory {
        double exposure = 0.0;               ///< integral of A dt                      [m^2 s]
        double push = 0.0;                   ///< sum of J                              [N s]
        double room = 0.0;                   ///< integral of p_room A dt               [N s]
        double room2 = 0.0;                  ///< integral of p_room² A dt              [N² s/m²]
        double push_room = 0.0;              ///< sum of J p_room                       [N² s/m²]
        double push2 = 0.0;                  ///< sum of J²                             [N² s²]
        double count = 0.0;                  ///< hits
        double energy = 0.0, energy2 = 0.0;  ///< beyond what the room's gas carries    [J], [J²]
        double slope = 0.0;                  ///< sum of d(energy carried)/dT           [J/K]
        double mass = 0.0;                   ///< of hits                               [kg]
        Vec3 momentum = Vec3::Zero();        ///< of hits, past the wall                [N s]
        double square = 0.0;                 ///< sum of its squares                    [N² s²]
        std::vector<double> of;              ///< hits by species

        [[nodiscard]] double pressure() const { return push / exposure; }
        [[nodiscard]] double room_pressure() const { return room / exposure; }
        [[nodiscard]] double difference() const { return (push - room) / exposure; }
        [[nodiscard]] double variance() const { return 0.5 * push2 / (exposure * exposure); }
        /// Pressure here where the room's is so much, by the hits' line over the room's pressure.
        /// Needs an exposure above 0.
        [[nodiscard]] Known at(double room_pressure) const;
        void clear();
        /// What is remembered is multiplied by `kept`, `more` is added.
        void renew(double kept, const Memory& more);

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(exposure, push, room, room2, push_room, push2, count, energy, energy2, slope,
                    mass, momentum, square, of);
        }
    };
    struct Sample {
        std::vector<Index> sides, points;  ///< ascending
        bool drifts = false;               ///< gas may flow past it, to a hole
        Index room = 0;
        double area = 0.0;  ///< at the last flight                                     [m^2]
        bool tells = true;  ///< of differences in its room: all that come bounce
        Memory now, quick, steady;

        /// Pressure here where the room's is so much. Needs hits.
        [[nodiscard]] Known at(double room_pressure) const;

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(area, quick, steady);
        }
    };
    /// How the gas of a room differs from place to place, beyond chance: variances.
    struct Spread {
        double pressure = 0.0, temperature = 0.0;  ///< [Pa²], [K²]
        /// T² k / C, k of a particle, C of the particles before a unit of wall (by their share of
        /// the moles): their T fluctuates by so much.
        double fluctuation = 0.0;  ///< [K² m²]
        double common = 0.0;       ///< by which all hits seem warmer than the room           [K]
        template <class Archive>
        void visit_state(Archive& archive) {
            archive(pressure, temperature, fluctuation, common);
        }
        /// Variance by chance of the temperature that hits on a sample tell.                    [K²]
        [[nodiscard]] double chance(const Memory& hits, double area) const {
            return 0.5 * hits.energy2 / (hits.slope * hits.slope) + fluctuation / area;
        }
    };
    void cut_into_patches(const BagWalls& walls, std::span<const Vec3> x);
    void list_patches(const SidePatches& patches);
    void add(const Hit& hit, const Vec3& wall, const Particles& particles, Sample& sample) const;
    void remember(Sample& sample, double dt, const Inside& room);
    void find_spread(std::span<const Inside> rooms);
    [[nodiscard]] double temperature(std::size_t sample, const Inside& room, double weight) const;
    [[nodiscard]] double excess(const Inside& room, const Drawn& drawn) const;
    void mix(const Memory& q, const Inside& room, double own, double pressure, double T,
             Inside& out) const;
    /// Weights of a sample's own state against its room's.
    struct Own {
        double pressure, temperature;
    };
    void stagnate(const Memory& q, const Own& own, double& pressure, double& T, Inside& out) const;

    std::shared_ptr<const WettedSurface> surface_;
    std::vector<Species> species_;
    std::vector<double> particle_mass_;
    double gas_constant_ = 0.0, longest_ = 0.0, moles_each_ = 0.0;
    std::vector<std::vector<Index>> patches_;
    std::vector<Sample> samples_;
    std::vector<std::vector<Index>> patches_of_;  ///< of sides (WallHits), by sample
    std::vector<Spread> spread_;                  ///< by room
    std::vector<double> expected_, slope_;        ///< energy carried by a hit, by room × species
};

}  // namespace corpuscle::gas
