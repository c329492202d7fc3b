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
    explicit SidePatches(const WettedSurface& surface);

    [[nodiscard]] std::size_t size() const { return room_.size(); }
    [[nodiscard]] Index of(std::size_t side) const { return of_side_[side]; }
    [[nodiscard]] Index room(std::size_t patch) const { return room_[patch]; }
    [[nodiscard]] std::size_t colours() const { return start_.size() - 1; }
    /// Patches of a colour.
    [[nodiscard]] std::span<const Index> of_colour(std::size_t colour) const {
        return std::span(by_colour_)
            .subspan(start_[colour], static_cast<std::size_t>(start_[colour + 1] - start_[colour]));
    }

private:
    void cut(const WettedSurface& surface);
    void colour(const WettedSurface& surface);

    std::vector<Index> of_side_;            ///< patch of each side
    std::vector<Index> room_;               ///< of each patch
    std::vector<Index> by_colour_, start_;  ///< patches, compressed rows
};

}  // namespace corpuscle::gas
