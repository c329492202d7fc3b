// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "gas/flight/facet_lists.hpp"
#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/simd.hpp"

namespace corpuscle::gas {

/// Safe distance of each particle, within which there is no fabric: most flights need no test.
///
/// The distance at a particle's place (Clearance) is reduced by its flight, and looked up again
/// when it no longer suffices. It stays with the particle (Particles::safe_distance) when rows move.
/// An unknown distance is zero, and no checkpoint holds any: a flight without test ends bitwise at
/// the same place as one with the test.
class SafeDistances {
public:
    static constexpr std::size_t BLOCK = 32;  ///< rows; chunks of flights are a multiple

    /// Before a flight among facets that move from x_0 to x_1; the lists may have been built anew.
    void begin_flight(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
                      Particles& gas) {
        is_on_ = !lists.clearance().is_empty();
        if (!is_on_) return;
        if (lists.builds() != builds_) {
            const bool is_next = lists.builds() == builds_ + 1;
            const float since = is_next ? round_up(lists.moved_between_builds()) : INFINITY;
            parallel::for_each(gas.size(), [&](std::size_t i) {
                gas.safe_distance[i] = std::max(0.0F, gas.safe_distance[i] - since);
            });
            builds_ = lists.builds();
        }
        moved_ = round_up(lists.displacement(x_0, x_1));
    }

    /// Bits of those of up to BLOCK rows that may meet fabric in dt, or have no finite velocity.
    /// The others' distances are reduced.
    std::uint32_t ask(const FacetLists& lists, std::size_t begin, std::size_t count, double dt,
                      Particles& gas) const {
        const std::uint32_t all = static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
        if (!is_on_) return all;
        float* const left = gas.safe_distance.data() + begin;
        const auto bound = displacement_bounds(gas.v[begin].data(), count, dt);
        std::uint32_t unclear = 0;
        for (std::size_t i = 0; i < count; ++i)
            unclear |= static_cast<std::uint32_t>(!(left[i] - bound[i] > moved_)) << i;
        for (std::uint32_t rest = unclear; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            const Vec3& x = gas.x[begin + i];
            left[i] = lists.clearance().at(x);
            const bool is_short = bound[i] + moved_ < lists.clearance().reach();
            if (left[i] - bound[i] > moved_ ||
                (is_short && lists.clearance().is_free(x, x + dt * gas.v[begin + i], moved_)))
                unclear &= ~(1U << i);
        }
        for (std::size_t i = 0; i < count; ++i) left[i] = (left[i] - bound[i]) * (1.0F - ROUNDING);
        for (std::uint32_t rest = unclear; rest != 0; rest &= rest - 1)
            left[std::countr_zero(rest)] = 0.0F;
        return unclear;
    }

private:
    static constexpr float ROUNDING = 1e-6F;

    /// Largest component of each particle's displacement, rounded up; NaN where it is not finite. Three fours
    /// hold four velocities.
    static std::array<float, BLOCK> displacement_bounds(const double* v, std::size_t count,
                                                        double dt) {
        std::array<float, BLOCK> out;
        const auto longest = [&](double x, double y, double z) {
            return std::max(std::max(std::abs(x), std::abs(y)), std::abs(z)) + 0.0 * (x + y + z);
        };
        const double factor = dt * (1.0 + ROUNDING);
        std::size_t i = 0;
        for (; i + FOUR <= count; i += FOUR) {
            const auto size = [&](int k) {
                const Four a = load_four(v + 3 * i + FOUR * k);
                return a < 0.0 ? -a : a;
            };
            const auto [x, y, z] = columns(size(0), size(1), size(2));
            // what is not finite has no finite displacement: zero times it is NaN
            const Four xy = x > y ? x : y, not_finite = 0.0 * (x + y + z);
            const Four most = factor * (xy > z ? xy : z) + not_finite;
            for (int l = 0; l < FOUR; ++l) out[i + l] = static_cast<float>(most[l]);
        }
        for (; i < count; ++i)
            out[i] = static_cast<float>(factor * longest(v[3 * i], v[3 * i + 1], v[3 * i + 2]));
        return out;
    }

    static float round_up(double bound) { return static_cast<float>(bound) * (1.0F + ROUNDING); }

    std::size_t builds_ = 0;
    float moved_ = 0.0F;  ///< farthest along an axis that a node has, since then        [m]
    bool is_on_ = false;
};

}  // namespace corpuscle::gas
