// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "fabric/materials/plane_stress.hpp"
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

/// 1/m of a pack's corners; 0 of those that fill it up.                                  [1/kg]
/// @param mass  of all corners, element by element                                         [kg]
template <std::size_t CORNERS>
std::array<Lanes, CORNERS> per_mass(const std::vector<double>& mass, std::size_t pack) {
    std::array<Lanes, CORNERS> out{};
    const std::size_t first = pack * LANES * CORNERS;
    for (std::size_t k = 0; k < LANES * CORNERS && first + k < mass.size(); ++k)
        out[k % CORNERS][k / CORNERS] = 1.0 / mass[first + k];
    return out;
}

/// Means of lane l over its points, of whose strains and stresses the sums are given: Green strain,
/// and the true stress of cloth of unchanged volume on its yarns.
inline void store_means(std::size_t l, const Strain<Lanes>& e, const Stress<Lanes>& s, int points,
                        std::array<float, 3>& stress, std::array<float, 3>& strain) {
    const double share = 1.0 / points;
    const double e1 = share * e.warp[l], e2 = share * e.weft[l], e3 = share * e.shear[l];
    const double length_1 = std::sqrt(std::max(0.0, 1.0 + 2.0 * e1));
    const double length_2 = std::sqrt(std::max(0.0, 1.0 + 2.0 * e2));
    strain = {static_cast<float>(e1), static_cast<float>(e2), static_cast<float>(e3)};
    stress = {static_cast<float>(share * s.warp[l] * length_1 * length_1),
              static_cast<float>(share * s.weft[l] * length_2 * length_2),
              static_cast<float>(share * s.shear[l] * length_1 * length_2)};
}

}  // namespace corpuscle::fabric
