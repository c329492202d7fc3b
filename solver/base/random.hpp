// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Random123/philox.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// What a draw is for, so that draws of different causes never share numbers.
enum class Stream : std::uint32_t {
    INFLOW = 1,     ///< direction in which a particle enters
    COLLISION = 2,  ///< partners in a group of a cell and their scattering
    VENT = 3,       ///< passage at a facet: vents, holes, porous cloth, collars
    POROSITY = 4,   ///< drawn by nothing
    INITIAL = 5,    ///< places and thermal velocities of the air at the start
    WALL = 6        ///< drawn by nothing
};

/// Random numbers that are a function of (seed, stream, step, id) and of nothing else: never of the
/// thread, nor of how many were drawn before. Philox-4x32-10 [Salmon 2011].
///
///     Random draw(seed, Stream::COLLISION, step, cell);  double u = draw.uniform();
class Random {
public:
    /// @param seed  of the run
    /// @param step  of the run, 0 at the start
    /// @param id    of what draws: a particle, a group; each draws its own sequence
    Random(std::uint64_t seed, Stream stream, std::uint64_t step, std::uint64_t id)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32) ^
                                                      (static_cast<std::uint32_t>(stream) << 24)}},
          counter_{
              {0U, static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(id),
               static_cast<std::uint32_t>(id >> 32) ^ static_cast<std::uint32_t>(step >> 32)}} {}

    /// 32 random bits.
    std::uint32_t bits() {
        if (used_ == 4) {
            block_ = r123::Philox4x32()(counter_, key_);
            ++counter_[0];
            used_ = 0;
        }
        return block_[used_++];
    }

    /// Uniform in (0, 1), never 0 or 1.
    double uniform() { return (bits() + 0.5) * 0x1p-32; }

    /// Uniform in 0 .. n-1.
    std::uint32_t below(std::uint32_t n) {
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits()) * n) >> 32);
    }

    /// Standard normal (Box-Muller, one of the pair).
    double normal() {
        const double r = std::sqrt(-2.0 * std::log(uniform()));
        return r * std::cos(2.0 * std::numbers::pi * uniform());
    }

    /// Uniform on the unit sphere.
    Vec3 direction() {
        const double z = 2.0 * uniform() - 1.0;
        const double phi = 2.0 * std::numbers::pi * uniform();
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

private:
    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    unsigned used_ = 4;
};

}  // namespace corpuscle
