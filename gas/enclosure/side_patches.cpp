// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/side_patches.hpp"

#include <algorithm>
#include <utility>

namespace corpuscle::gas {

SidePatches::SidePatches(const WettedSurface& surface, std::size_t sides)
    : of_side_(surface.sides(), -1) {
    cut(surface, sides);
    colour(surface);
}

/// Patches grow from side to side over common points, which are those of one room.
void SidePatches::cut(const WettedSurface& surface, std::size_t most) {
    std::vector<Index> patch;
    for (std::size_t seed = 0; seed < of_side_.size(); ++seed) {
        if (of_side_[seed] >= 0) continue;
        patch.clear();
        const auto take = [&](Index side) {
            if (of_side_[side] >= 0 || patch.size() >= most) return;
            of_side_[side] = static_cast<Index>(room_.size());
            patch.push_back(side);
        };
        take(static_cast<Index>(seed));
        for (std::size_t i = 0; i < patch.size() && patch.size() < most; ++i)
            for (const Index p : surface.points(static_cast<std::size_t>(patch[i])))
                for (const Index next : surface.around(static_cast<std::size_t>(p))) take(next);
        room_.push_back(surface.room(seed));
    }
}

/// Each patch gets the first colour that none of its neighbours has.
void SidePatches::colour(const WettedSurface& surface) {
    std::vector<std::vector<Index>> neighbours(size());
    for (std::size_t p = 0; p < surface.points(); ++p)
        for (const Index a : surface.around(p))
            for (const Index b : surface.around(p))
                if (of_side_[a] != of_side_[b]) neighbours[of_side_[a]].push_back(of_side_[b]);
    for (auto& some : neighbours) {
        std::sort(some.begin(), some.end());
        some.erase(std::unique(some.begin(), some.end()), some.end());
    }
    std::vector<Index> colour(size(), -1);
    std::vector<std::vector<Index>> patches;
    for (std::size_t k = 0; k < size(); ++k) {
        std::vector<std::uint8_t> is_taken(patches.size() + 1, 0);
        for (const Index other : neighbours[k])
            if (colour[other] >= 0) is_taken[colour[other]] = 1;
        colour[k] =
            static_cast<Index>(std::find(is_taken.begin(), is_taken.end(), 0) - is_taken.begin());
        if (static_cast<std::size_t>(colour[k]) == patches.size()) patches.emplace_back();
        patches[colour[k]].push_back(static_cast<Index>(k));
    }
    start_.push_back(0);
    for (const auto& of_one : patches) {
        by_colour_.insert(by_colour_.end(), of_one.begin(), of_one.end());
        start_.push_back(static_cast<Index>(by_colour_.size()));
    }
    list_before(neighbours);
}

void SidePatches::list_before(const std::vector<std::vector<Index>>& neighbours) {
    place_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) place_[by_colour_[i]] = static_cast<Index>(i);
    first_before_.push_back(0);
    for (std::size_t i = 0; i < size(); ++i) {
        for (const Index other : neighbours[by_colour_[i]])
            if (place_[other] < static_cast<Index>(i)) before_.push_back(place_[other]);
        first_before_.push_back(static_cast<Index>(before_.size()));
    }
}

}  // namespace corpuscle::gas
