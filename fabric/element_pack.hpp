// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "fabric/membrane_block.hpp"

namespace corpuscle::fabric {

/// LANES elements side by side.
template <template <class> class Element>
struct Pack {
    static constexpr int CORNERS = Element<Lanes>::CORNERS;

    Element<Lanes> shape;
    Lanes rate;  ///< (2/dt)²                                                     [1/s^2]
    std::array<std::array<Index, LANES>, CORNERS> nodes;

    void set(int lane, const Element<double>& one) {
        auto to = Element<Lanes>::fields(shape);
        const auto from = Element<double>::fields(one);
        copy_lane(lane, to, from, std::make_index_sequence<std::tuple_size_v<decltype(to)>>{});
    }

private:
    template <class To, class From, std::size_t... I>
    static void copy_lane(int lane, To& to, const From& from, std::index_sequence<I...>) {
        ((std::get<I>(to)[lane] = std::get<I>(from)), ...);
    }
};

/// Positions or velocities of a pack's corners.
template <std::size_t CORNERS>
std::array<Vector<Lanes>, CORNERS> corners_of(
    const double* points, const std::array<std::array<Index, LANES>, CORNERS>& nodes) {
    std::array<Vector<Lanes>, CORNERS> out;
    for (std::size_t c = 0; c < CORNERS; ++c)
        for (int l = 0; l < LANES; ++l) {
            const double* at = points + 3 * static_cast<std::ptrdiff_t>(nodes[c][l]);
            out[c].x[l] = at[0];
            out[c].y[l] = at[1];
            out[c].z[l] = at[2];
        }
    return out;
}

template <std::size_t CORNERS>
void store_corners(double* to, const std::array<Vector<Lanes>, CORNERS>& f) {
    for (std::size_t c = 0; c < CORNERS; ++c) {
        store(to + (3 * c + 0) * LANES, f[c].x);
        store(to + (3 * c + 1) * LANES, f[c].y);
        store(to + (3 * c + 2) * LANES, f[c].z);
    }
}

}  // namespace corpuscle::fabric
