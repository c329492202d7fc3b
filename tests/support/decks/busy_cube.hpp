// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/places.hpp"

namespace corpuscle::support {

/// A cube of cloth with something of everything that a run keeps account of: initial air and gas
/// of an inflator, a vent, friction in self-contact, a ball that is driven into it, a plate of steel
/// that falls on it, damping and gravity. 1 ms in some 300 steps; a checkpoint every &DUMP steps, 40
/// of them by default; initial air and plate are off by the share &EPS, 0 by default. SI units.
struct BusyCube {
    std::string more;  ///< further cards

    [[nodiscard]] std::string deck() const {
        const std::string folder = CORPUSCLE_DECKS "/";
        return "*KEYWORD\n*TITLE\na busy cube\n*PARAMETER\nI DUMP, 40\nR EPS, 0.0\n"
               "*PARAMETER_EXPRESSION\nR TAIR    300.0*(1.0+EPS)\nR VZ      "
               "-15.0*(1.0+EPS)\n*INCLUDE\n" +
               folder + "cube.inc\n*INCLUDE\n" + folder + "cloth.inc\n" + CONTROL + GAS +
               SURROUNDINGS + more + "*END\n";
    }

private:
    static constexpr const char* CONTROL =
        "*CONTROL_TERMINATION\n1.0e-3\n*CONTROL_TIMESTEP\n0.0, 0.15\n"
        "*DATABASE_BINARY_D3DUMP\n&DUMP\n*DATABASE_BINARY_D3PLOT\n2.0e-4\n"
        "*DATABASE_GLSTAT\n1.0e-5\n*DATABASE_ABSTAT\n1.0e-5\n*DATABASE_RBDOUT\n1.0e-5\n"
        "*DATABASE_RWFORC\n1.0e-5\n*DATABASE_RCFORC\n1.0e-5\n"
        "*DAMPING_GLOBAL\n0, 5.0\n*DEFINE_CURVE\n40\n0.0, 9.81\n1.0, 9.81\n*LOAD_BODY_Z\n40\n";
    static constexpr const char* GAS =
        "*DEFINE_CURVE\n21\n0.0, 0.1\n1.0e-3, 0.1\n*NODE\n100, 0.05, 0.05, "
        "0.05\n*DEFINE_CURVE\n20\n0.0, 500.0\n1.0, 500.0\n"
        "*AIRBAG_PARTICLE_ID\n7, gas\n1, 1\n300, 1, 1, 300.0, 101325.0, 1\n1, 1, 1\n2, 0, 0.3\n"
        "101325.0, &TAIR, 0.02897, 29.1\n21, 20, 0.004, 20.786\n100, 1.0\n";
    static constexpr const char* SURROUNDINGS =
        "*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0\n0.03, 0.04, -0.031, 0.03, 0.04, 1.0, 0.2\n"
        "0.03\n30, 1, 0.0, 0.0, 1.0\n*DEFINE_CURVE\n30\n0.0, 0.0\n1.0e-3, 0.012\n"
        "*NODE\n201, 0.0, 0.0, 0.104\n202, 0.1, 0.0, 0.104\n203, 0.1, 0.1, 0.104\n"
        "204, 0.0, 0.1, 0.104\n*ELEMENT_SHELL\n201, 50, 201, 202, 203, 204\n"
        "*PART\nplate\n50, 50, 50\n*SECTION_SHELL\n50, 2\n1e-3, 1e-3, 1e-3, 1e-3\n"
        "*MAT_RIGID\n50, 7800.0, 2.1e11, 0.3\n,\n,\n"
        "*INITIAL_VELOCITY_RIGID_BODY\n50, 0.0, 1.0, &VZ\n"
        "*CONTACT_AIRBAG_SINGLE_SURFACE\n0, 0, 5, 0\n0.2, 0.2, 0.0, 0.0, 20.0\n,\n";
};

}  // namespace corpuscle::support
