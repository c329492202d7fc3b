// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <Eigen/Eigenvalues>
#include <functional>
#include <random>
#include "fabric/materials/law.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"

namespace curves_setup {

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

/// Stiffening cloth, with curves of unloading below those of loading.
inline const std::vector<Curve> CURVES = {
    {1, {0.0, 0.02, 0.1, 0.3}, {0.0, 2e6, 22e6, 90e6}},    // warp
    {2, {-0.2, 0.0, 0.05, 0.3}, {-1e6, 0.0, 6e6, 70e6}},   // weft
    {3, {0.0, 0.2, 0.6, 1.2}, {0.0, 0.2e6, 1.5e6, 20e6}},  // angle
    {4, {0.0, 0.1, 0.25, 0.3}, {0.0, 2e6, 50e6, 90e6}},    // unloading
    {5, {0.0, 0.15, 0.3}, {0.0, 4e6, 70e6}},
    {6, {0.0, 0.6, 1.2}, {0.0, 0.5e6, 20e6}}};

inline FabricCard curved_card(int form, bool unloads, double reload = 0.0) {
    FabricCard c = fabric_card();
    c.form = form;
    c.curves.load = {0, 1, 2};
    if (unloads) c.curves.unload = {3, 4, 5};
    c.curves.reload = reload;
    return c;
}

inline Sheet sheet_of(const FabricCard& card, Mesh mesh) {
    Sheet sheet = rectangle(card, mesh, 4, 3, 0.4, 0.3);
    sheet.curves = CURVES;
    jitter(sheet, 0.02);
    return sheet;
}

inline LoadingLoop warp_loop(double reload) {
    return {StressCurve(CURVES[0], Below::STRAIGHT), CURVES[3], reload};
}

}  // namespace curves_setup
