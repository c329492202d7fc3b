// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/collisions/collide.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/flight/transmission.hpp"
#include "gas/particles.hpp"

namespace corpuscle::gas {

/// How large the cells of a bag's collisions are, and how often particles collide in them: as often
/// as one of thermal speed crosses a share of a cell, in cells that hold some 30 particles.
class CollisionCells {
public:
    /// @param triangles  of the bag, the first `closing` ones close it
    /// @param volume     of the bag                                                    [m^3]
    /// @param particles  that it will hold when full
    /// @param speed      thermal, sqrt(R T / M), until the first measurement           [m/s]
    CollisionCells(const std::vector<Triangle>& triangles, std::size_t closing, const Points& x,
                   double volume, std::size_t particles, double speed);

    /// A step of dt goes by: is it the one that comes nearest to the share of a cell?
    [[nodiscard]] bool is_due(double dt);
    /// The bag has no particles in this step: none have waited for a collision since.
    void pass_empty() { empty_ = since_; }
    /// In cells of about the wanted size, made anew when fabric has moved too far.
    void find_groups(const Points& x, const Transmission* transmission, Collider& collider,
                     Particles& particles);
    /// After a collision step: measures the thermal speed now and then, counts the step, adapts the
    /// cells that the next facet lists will have to how many particles the occupied ones hold.
    void finish(const Lists& cells, std::span<const double> mass, const Particles& particles);

    /// Step in which a particle of thermal speed crosses the share of a cell.           [s]
    [[nodiscard]] double stable_step() const;
    [[nodiscard]] double speed() const { return speed_; }  ///< thermal [m/s]
    /// The last collision step, or the last without particles.                        [s]
    [[nodiscard]] double since() const { return since_ - empty_; }
    [[nodiscard]] std::uint64_t steps() const { return steps_; }
    [[nodiscard]] std::size_t list_builds() const { return lists_.builds(); }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(lists_, edge_, wanted_edge_, speed_, since_, empty_, steps_);
    }

private:
    void find_open_facets(const Transmission* transmission);
    void measure_speed(std::span<const double> mass, const Particles& particles);

    FacetLists lists_;
    std::size_t closing_;
    std::vector<std::uint8_t> is_open_;      ///< by facet, or empty: none
    double edge_ = 0.0, wanted_edge_ = 0.0;  ///< of a cell                          [m]
    double speed_ = 0.0;                     ///< of the gas as a whole              [m/s]
    double since_ = 0.0;                     ///< the last collision step            [s]
    double empty_ = 0.0;                     ///< of which there were no particles   [s]
    std::uint64_t steps_ = 0;
};

}  // namespace corpuscle::gas
