// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/enclosure/side_patches.hpp"
#include "gas/flight/flight.hpp"

namespace corpuscle::gas {

/// A flight's hits by where they were: on which side of the wall, and in which patch of sides.
///
/// Hits of a particle that hit several patches in a step are scattered: they belong to no patch, so
/// that patches have neither points nor particles in common if they are of one colour.
class WallHits {
public:
    struct Met {
        Hit* hit;
        Index side;
    };

    explicit WallHits(const WettedSurface& surface)
        : surface_(surface), patches_(surface), wide_(surface, WIDE) {}

    /// Lists the hits of a flight, which is to outlive this.
    void list(FlightResult& flight, std::span<const Vec3> x_0, std::span<const Vec3> x_1);

    [[nodiscard]] std::size_t size() const { return sides_.size(); }
    /// Sides of a list's hits, in their order.
    [[nodiscard]] std::span<const Index> sides(std::size_t list) const {
        return std::span(sides_).subspan(first_[list], first_[list + 1] - first_[list]);
    }
    [[nodiscard]] const SidePatches& patches() const { return patches_; }
    /// Likewise larger ones, of hits that are scattered over those.
    [[nodiscard]] const SidePatches& wide_patches() const { return wide_; }
    /// Hits of a patch, in their order; those that are scattered, as if of one more.
    [[nodiscard]] std::span<const Met> of(std::size_t patch) const {
        const std::size_t end = patch < patches_.size() ? start_[patch + 1] : by_patch_.size();
        return std::span(by_patch_).subspan(start_[patch], end - start_[patch]);
    }
    /// Of those that are scattered: within a wide patch, and over several of them too.
    [[nodiscard]] std::span<const Met> of_wide(std::size_t patch) const {
        return row(patches_.size() + patch);
    }
    [[nodiscard]] std::span<const Met> scattered() const {
        return row(patches_.size() + wide_.size());
    }

private:
    static constexpr std::size_t WIDE = 256;  ///< sides of a wide patch
    [[nodiscard]] std::span<const Met> row(std::size_t k) const {
        return std::span(by_patch_).subspan(start_[k], start_[k + 1] - start_[k]);
    }
    [[nodiscard]] Index patch_of(std::span<const Index> sides) const;
    [[nodiscard]] std::size_t side_of(const Hit& hit, std::span<const Vec3> x_0,
                                      std::span<const Vec3> x_1) const;
    void find_patches(const std::vector<Hit>& hits, std::size_t first);
    void find_starts(std::size_t groups, std::size_t rows);

    const WettedSurface& surface_;
    SidePatches patches_, wide_;
    std::vector<std::size_t> first_;  ///< hit of each list
    std::vector<Index> sides_;        ///< of hits, list by list
    std::vector<Index> patch_;        ///< likewise
    std::vector<Met> by_patch_;
    std::vector<std::size_t> start_;    ///< of each patch
    std::vector<std::uint32_t> count_;  ///< by some hits and patch, then where those are to go
    std::vector<std::uint32_t> sum_;    ///< of those, by patch
};

}  // namespace corpuscle::gas
