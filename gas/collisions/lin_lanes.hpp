// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/four_math.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

/// LIN for four groups of one kind of gas at once: the same map as in collide_lin.cpp, which stays the
/// oracle, but found from the groups' sums alone. Two passes over a group's particles, one that
/// adds up and one that maps; the matrices of four groups side by side (four_math.hpp).
///
///     v' = b + A v + H x,   e' = lowest + kept (e - least)
class LinLanes {
public:
    static constexpr std::size_t FEWEST = 9;  ///< particles of a group that LinLanes can collide

    explicit LinLanes(const Mixture& mixture) : mixture_(mixture) {}

    /// Adds up a group of FEWEST particles and more, all of one kind of gas, and draws what chance
    /// decides. False for a mixture: the group must be collided in another way.
    /// @param heat  that it gets
    bool add(std::span<const Index> rows, std::uint64_t group, const Heat& heat, Random draw,
             const Particles& particles);
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Finds the maps of the groups that were added and applies them. fall_back(group) for those
    /// that are not a gas in three dimensions, or hold no temperature.
    /// Returns their thermal energy before, by lane.
    template <class FallBack>
    std::array<double, FOUR> collide(Particles& particles, FallBack&& fall_back) {
        const Maps maps = find_maps();
        std::array<double, FOUR> thermal{};
        for (std::size_t l = 0; l < size_; ++l) {
            if (maps.is_good[l]) {
                apply(l, maps, particles);
                thermal[l] = maps.thermal[l];
            } else {
                fall_back(group_[l]);
            }
        }
        size_ = 0;
        return thermal;
    }

private:
    struct Maps {
        Four33 A, H;
        std::array<Four, 3> b;
        Four lowest, kept, thermal;
        FourBits is_good;
    };
    struct Energy;
    [[nodiscard]] Energy share(const Four& motion, const Four& thermal) const;
    [[nodiscard]] Maps find_maps() const;
    [[nodiscard]] Four temperature(const Four& energy, const Four& freedom) const;
    [[nodiscard]] Four33 turned_factor(const Four33& P, const Four& n, FourBits& is_good) const;
    [[nodiscard]] Four33 random_rotation() const;
    void apply(std::size_t lane, const Maps& maps, Particles& particles) const;

    using ByLane = std::array<double, FOUR>;

    const Mixture& mixture_;
    std::size_t size_ = 0;
    std::array<std::span<const Index>, FOUR> rows_{};
    std::array<std::uint64_t, FOUR> group_{};
    std::array<std::int32_t, FOUR> species_{};
    // Sums over a group's particles, of x and v from those of the first, and of e.
    alignas(32) std::array<std::array<ByLane, 3>, 3> xx_{}, vx_{}, vv_{};
    alignas(32) std::array<ByLane, 3> x_{}, v_{}, first_v_{};
    alignas(32) ByLane e_{}, n_{}, m_{}, factor_{}, added_{};
    alignas(32) ByLane least_{};  ///< e of a particle                                      [J]
    // Chance.
    alignas(32) ByLane share_{};                  ///< of the internal energy, nearly normal
    alignas(32) ByLane axis_{};                   ///< 0, 1, 2: which comes first
    alignas(32) std::array<ByLane, 6> stress_{};  ///< nearly normal
    alignas(32) std::array<ByLane, 3> turn_{};    ///< uniform
};

}  // namespace corpuscle::gas
