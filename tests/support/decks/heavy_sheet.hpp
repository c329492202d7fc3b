// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "tests/support/decks/box_deck.hpp"
#include "tests/support/runs/deck_run.hpp"

/// A box whose wall at z = size.z is one free sheet, so heavy that it hardly moves: the velocity of
/// its nodes measures the impulse that the gas has given them.
namespace corpuscle::test::sheet {

constexpr double DENSITY = 1e8, THICKNESS = 1e-3;   ///< [kg/m^3], [m]
constexpr double AREAL_MASS = DENSITY * THICKNESS;  ///< [kg/m^2]

/// Nodes of the sheet that no other wall shares, nor a membrane at `held_x`.
inline std::function<bool(const Vec3&)> is_free(const Vec3& size, double held_x) {
    return [=](const Vec3& x) {
        constexpr double EDGE = 1e-9;
        return x.z() > size.z() - EDGE && x.x() > EDGE && x.x() < size.x() - EDGE && x.y() > EDGE &&
               x.y() < size.y() - EDGE && std::abs(x.x() - held_x) > EDGE;
    };
}

/// Gauge impulse per area so far at a frame, by x: AREAL_MASS v_z, mean over y. All quads are
/// alike, so each free node carries its own area's mass.                              [Pa s]
inline std::map<double, double> impulse(const DeckRun& run, std::size_t frame,
                                        const std::function<bool(const Vec3&)>& is_free) {
    char path[32];
    std::snprintf(path, sizeof path, "/frames/%05zu/velocity", frame);
    const auto v = run.read(path), x = run.read("/mesh/coordinates");
    std::map<double, double> sum, count;
    for (std::size_t n = 0; n + 2 < x.size(); n += 3) {
        if (!is_free({x[n], x[n + 1], x[n + 2]})) continue;
        const double station = 1e-9 * std::round(1e9 * x[n]);
        sum[station] += AREAL_MASS * v[n + 2];
        count[station] += 1.0;
    }
    for (auto& [station, total] : sum) total /= count[station];
    return sum;
}

/// Frame nearest to a time.
inline std::size_t frame_at(const DeckRun& run, double time) {
    const auto times = run.read("/frames/time");
    std::size_t best = 0;
    for (std::size_t f = 0; f < times.size(); ++f)
        if (std::abs(times[f] - time) < std::abs(times[best] - time)) best = f;
    return best;
}

}  // namespace corpuscle::test::sheet
