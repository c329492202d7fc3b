// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "gas/facet_lists.hpp"
#include "gas/lanes.hpp"
#include "gas/particles.hpp"

namespace corpuscle::gas {

/// How far blocks of particles may fly before fabric can be in their way: most need not be asked
/// one by one, as neighbours in space are neighbours in memory (CellSort).
///
/// A block's free way is that of the particle nearest to fabric (FacetLists::free_way). It is used
/// up by the fastest one's flight, and looked up again when it does not suffice. What is not known
/// is zero, so nothing here belongs in a checkpoint: who streams arrives where, to the bit, who is
/// asked arrives.
class FreeWays {
public:
    static constexpr std::size_t BLOCK = 32;  ///< rows; parallel::CHUNK is a multiple

    /// Before a flight of `particles` rows; the lists may have been built anew.
    void begin_flight(const FacetLists& lists, std::size_t particles) {
        const std::size_t blocks = (particles + BLOCK - 1) / BLOCK;
        if (lists.builds() != builds_) left_.clear();
        builds_ = lists.builds();
        left_.resize(blocks, 0.0);
    }
    /// Rows from this one on are no more what they were.
    void forget(std::size_t row = 0) { left_.resize(std::min(left_.size(), row / BLOCK)); }
    /// One block has not streamed: anything may have happened to its particles.
    void forget_block(std::size_t block) { left_[block] = 0.0; }

    /// Moves the particles of a full block by dt v, if none can meet fabric on the way.
    bool stream(const FacetLists& lists, std::size_t block, double dt, Particles& gas) {
        constexpr double ROUNDING = 1.0 + 1e-9;
        double* const x = gas.x[block * BLOCK].data();
        const double* const v = gas.v[block * BLOCK].data();
        const double way = ROUNDING * dt * fastest(v);
        double& left = left_[block];
        if (!(way <= left)) left = look_up(lists, {&gas.x[block * BLOCK], BLOCK});
        if (!(way <= left)) return false;
        left -= way;
        for (std::size_t i = 0; i < 3 * BLOCK; ++i) x[i] += dt * v[i];
        return true;
    }

private:
    /// Largest component of BLOCK velocities.
    static double fastest(const double* v) {
        lanes::Four most{};
        for (std::size_t i = 0; i < 3 * BLOCK; i += lanes::LANES) {
            const lanes::Four a = lanes::load(v + i), size = a < 0.0 ? -a : a;
            most = size > most ? size : most;
        }
        return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
    }
    static double look_up(const FacetLists& lists, std::span<const Vec3> places) {
        double least = INF;
        for (const Vec3& x : places) {
            least = std::min(least, lists.free_way(x));
            if (least == 0.0) break;
        }
        return least;
    }

    std::vector<double> left_;  ///< by block                                            [m]
    std::size_t builds_ = 0;
};

}  // namespace corpuscle::gas
