// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace corpuscle::gas {

/// State of the gas in a room, or at a part of its wall.
struct Inside {
    double pressure = 0.0;        ///< absolute                                          [Pa]
    double air_pressure = 0.0;    ///< of which the air that is no particles has         [Pa]
    double error = 0.0;           ///< of the pressure, one standard deviation           [Pa]
    double temperature = 0.0;     ///< of the gas come to rest where its walls are at rest  [K]
    double molar_mass = 0.0;      ///< of all gas                                        [kg/mol]
    double gamma = 0.0;           ///< of all gas                                        [-]
    double heat_capacity = 0.0;   ///< of all gas in the room, at constant volume        [J/K]
    std::vector<double> density;  ///< partial, of the particles' gases                  [kg/m^3]
    double air_density = 0.0;     ///< of the air that is no particles                   [kg/m^3]
    double air_molar_mass = 1.0;  ///< [kg/mol]
    bool is_uniform = false;      ///< after TSW: all gas leaves as the air does

    [[nodiscard]] bool holds_gas() const { return pressure > 0.0 && temperature > 0.0; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(pressure, air_pressure, error, temperature, molar_mass, gamma, heat_capacity,
                density, air_density, air_molar_mass, is_uniform);
    }
};

}  // namespace corpuscle::gas
