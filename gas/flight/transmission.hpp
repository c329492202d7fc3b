// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Transmission probabilities of facets for one step: all data of openings that flight needs.
///
/// A facet may belong to an opening (it is a hole, or leaks) and to the collar of a vent (closed
/// fabric around a hole, for outflow beyond the hole's own arrivals).
struct Transmission {
    struct Chances {
        bool is_internal = false;    ///< passing particles stay in the bag
        bool counts_all = false;     ///< those that bounce are reported, too
        double push = 1.0;           ///< share of a bounce's impulse that a leaving particle gives
        std::vector<double> chance;  ///< by species                                          [-]
        std::vector<double> collar_chance;  ///< by species, on the collar                    [-]
        /// By species, of those that come from the front of internal facets; empty: as `chance`. [-]
        std::vector<double> front_chance{};

        [[nodiscard]] bool has_sides() const { return !front_chance.empty(); }

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(push, chance, collar_chance, front_chance);
        }
    };
    std::vector<Chances> all;
    std::vector<Index> of_facet;   ///< row in `all` of each facet, -1: none
    std::vector<Index> collar_of;  ///< row in `all` whose collar the facet belongs to, -1: none
    std::vector<double> open;      ///< by facet: share of the chance that contact leaves    [-]
    std::uint64_t seed = 0, step = 0;

    /// State for a checkpoint (solver/base/archive.hpp): collisions, before the next flight, need
    /// the facets that block no line of sight.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(all, open, step);
    }

    enum class Fate : std::uint8_t { BACK, THROUGH, OUT };
    struct Outcome {
        Fate fate = Fate::BACK;
        Index opening = -1;  ///< the opening; for BACK: the one that counts the hit
        bool by_collar = false;
        double push = 1.0;        ///< share of the impulse of a bounce that the facet gets
        bool from_front = false;  ///< of a facet whose opening has_sides()
    };

    /// Whether chances at a facet go with the side that a particle comes from.
    [[nodiscard]] bool has_sides(Index facet) const {
        return of_facet[facet] >= 0 && all[of_facet[facet]].has_sides();
    }

    /// Outcome of a particle at a facet: a function of (seed, step, particle, hit) and the side.
    /// @param from_front  that it comes from; counts where the facet has_sides()
    [[nodiscard]] Outcome outcome(Index facet, std::int32_t species, std::int32_t particle, int hit,
                                  bool from_front = false) const {
        const Index row = of_facet[facet], collar = collar_of[facet];
        if (row < 0 && collar < 0) return {};
        const double passing =
            row < 0 ? 0.0
                    : open[facet] * (from_front ? all[row].front_chance : all[row].chance)[species];
        const double drawn = collar < 0 ? 0.0 : all[collar].collar_chance[species];
        if (passing > 0.0 || drawn > 0.0) {
            Random draw(seed, Stream::VENT, step,
                        static_cast<std::uint32_t>(particle) | static_cast<std::uint64_t>(hit)
                                                                   << 32);
            const double u = draw.uniform();
            if (u < passing) {
                const Chances& g = all[row];
                return {g.is_internal ? Fate::THROUGH : Fate::OUT, row, false, g.push, from_front};
            }
            if (u < passing + drawn) return {Fate::OUT, collar, true, 1.0};
        }
        if (row >= 0 && all[row].counts_all) return {Fate::BACK, row, false, 1.0, from_front};
        if (collar >= 0) return {Fate::BACK, collar, true, 1.0};
        return {};
    }
};

/// A particle that came to an opening.
struct Arrival {
    std::size_t particle;  ///< row
    Index facet;
    Transmission::Outcome outcome;
    double energy;        ///< that it carries out; through fabric, as that moves          [J]
    double riding = 0.0;  ///< of which is of the opening's motion at w: P·w - m w²/2   [J]
};

}  // namespace corpuscle::gas
