// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"

namespace corpuscle::gas {

/// Sides of a wetted surface in small patches, each of one room, and colours of the patches: no two
/// of a colour have a wall point in common, so what hits change at points is changed in all patches
/// of a colour at once. From connectivity alone.
class SidePatches {
public:
    /// @param sides  of a patch. Fewer: finer shares of work; more particles hit several patches in
    ///               a step
    explicit SidePatches(const WettedSurface& surface, std::size_t sides = 16);

    [[nodiscard]] std::size_t size() const { return room_.size(); }
    [[nodiscard]] Index of(std::size_t side) const { return of_side_[side]; }
    [[nodiscard]] Index room(std::size_t patch) const { return room_[patch]; }
    [[nodiscard]] std::size_t colours() const { return start_.size() - 1; }
    /// Patches of a colour.
    [[nodiscard]] std::span<const Index> of_colour(std::size_t colour) const {
        return std::span(by_colour_)
            .subspan(start_[colour], static_cast<std::size_t>(start_[colour + 1] - start_[colour]));
    }
    /// Patches, colour by colour.
    [[nodiscard]] std::span<const Index> by_colour() const { return by_colour_; }
    [[nodiscard]] std::size_t place(std::size_t patch) const {  ///< there
        return static_cast<std::size_t>(place_[patch]);
    }
    /// Of the patch at a place there, the places of those before it that have points in common.
    [[nodiscard]] std::span<const Index> before(std::size_t place) const {
        return std::span(before_).subspan(
            first_before_[place],
            static_cast<std::size_t>(first_before_[place + 1] - first_before_[place]));
    }

private:
    void cut(const WettedSurface& surface, std::size_t most);
    void colour(const WettedSurface& surface);
    void list_before(const std::vector<std::vector<Index>>& neighbours);

    std::vector<Index> of_side_;                ///< patch of each side
    std::vector<Index> room_;                   ///< of each patch
    std::vector<Index> by_colour_, start_;      ///< patches, compressed rows
    std::vector<Index> place_;                  ///< of each patch in by_colour_
    std::vector<Index> before_, first_before_;  ///< likewise places before, by place
};

}  // namespace corpuscle::gas
