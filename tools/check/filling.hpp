// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "gas/thermo/species.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle {
struct Model;
}
namespace corpuscle::gas {
struct BagCard;
}

namespace corpuscle::tools {

/// Gas, summed over what flows in or lies inside; deck units.
struct Filling {
    double mass = 0.0, moles = 0.0;
    double energy = 0.0;           ///< enthalpy of what flows in, internal energy of what is inside
    double heat = 0.0, gas = 0.0;  ///< m cv, n R
    double coldest = INF, hottest = 0.0;  ///< [K]

    Filling& operator+=(const Filling& o);
    /// sqrt(R T / M) of it in a room of constant volume, where its energy has become internal:
    /// n R T = (n R / m cv) energy.
    [[nodiscard]] double thermal_speed() const;
};

/// Adds what a mass flow brings until `until`; the curve ends at `end`.
void add_inflow(Filling& all, const Curve& rate, double end, double until,
                const gas::Species& species, const std::function<double(double)>& temperature);

/// What all inflators of a bag of particles bring until then.
[[nodiscard]] Filling inflow_until(const Model& model, const gas::BagCard& card, double until);

/// The initial air of a bag of particles.
[[nodiscard]] Filling air_in(const gas::BagCard& card, double volume);

/// Volume of a bag that is full, by that of two flat discs of this area in all, sewn and inflated
/// (Mylar balloon):   V = 0.0774 A^(3/2), but not less than now.
[[nodiscard]] double full_volume(double now, double area);

}  // namespace corpuscle::tools
