// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/enclosure/side_patches.hpp"
#include "gas/flight/flight.hpp"

namespace corpuscle::gas {

/// A flight's hits by where they were: on which side of the wall, and in which patch of sides.
class WallHits {
public:
    struct Met {
        Hit* hit;
        Index side;
        Index settles;  ///< last of a particle's hits in the flight: how many they are; else 0

        /// Energy that the wall took from the particle in the hits that this one settles.     [J]
        [[nodiscard]] double energy() const {
            double sum = 0.0;
            for (Index k = 0; k < settles; ++k) sum += hit[-k].energy;
            return sum;
        }
    };

    explicit WallHits(const WettedSurface& surface) : surface_(surface), patches_(surface) {}

    /// Lists the hits of a flight. It and the nodes' places before and after it are to outlive this.
    void list(FlightResult& flight, std::span<const Vec3> x_0, std::span<const Vec3> x_1);

    [[nodiscard]] std::size_t size() const { return sides_.size(); }
    /// Sides of a list's hits, in their order.
    [[nodiscard]] std::span<const Index> sides(std::size_t list) const {
        return std::span(sides_).subspan(first_[list], first_[list + 1] - first_[list]);
    }
    [[nodiscard]] const SidePatches& patches() const { return patches_; }
    /// Hits of a patch, in their order.
    [[nodiscard]] std::span<const Met> of(std::size_t patch) const {
        return std::span(by_patch_).subspan(start_[patch], start_[patch + 1] - start_[patch]);
    }

    /// Where the corners of the facet were when it was hit: half way between before and after the
    /// flight, moved so that the hit's place on it is where the particle turned.               [m]
    [[nodiscard]] std::array<Vec3, 3> corners(const Hit& hit) const;

private:
    [[nodiscard]] std::size_t side_of(const Hit& hit, std::span<const Vec3> x_0,
                                      std::span<const Vec3> x_1) const;
    void find_starts(std::size_t groups);

    const WettedSurface& surface_;
    SidePatches patches_;
    std::span<const Vec3> x_0_, x_1_;  ///< of the flight
    std::vector<std::size_t> first_;   ///< hit of each list
    std::vector<Index> sides_;         ///< of hits, list by list
    std::vector<Met> by_patch_;
    std::vector<std::size_t> start_;    ///< of each patch
    std::vector<std::uint32_t> count_;  ///< by some hits and patch, then where those are to go
    std::vector<std::uint32_t> sum_;    ///< of those, by patch
};

}  // namespace corpuscle::gas
