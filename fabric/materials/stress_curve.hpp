// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "solver/base/curve.hpp"

namespace corpuscle::fabric {

/// What a curve of loading that begins at 0 means for negative strain.
enum class Below {
    STRAIGHT,  ///< the first slope goes on: a yarn that takes compression
    NOTHING,   ///< no stress, whatever the curve says there: CSE
    MIRRORED   ///< the other way round: shear
};

/// Stress over strain, piecewise linear through (0, 0), with the energy under it. Beyond its ends
/// the last slopes go on.
class StressCurve {
public:
    /// A straight line of the given slope.                                     [Pa]
    StressCurve(double slope, Below below);
    /// @param curve  one for which loading_fault() finds nothing
    StressCurve(const Curve& curve, Below below);

    struct Point {
        double stress;  ///< [Pa]
        double energy;  ///< ∫ stress from 0                                   [J/m^3]
    };
    /// NaN in, NaN out.                                       cost: one binary search
    [[nodiscard]] Point at(double strain) const;

    [[nodiscard]] double steepest() const;  ///< greatest slope                [Pa]
    [[nodiscard]] const std::vector<double>& strains() const { return e_; }  ///< knots
    [[nodiscard]] double slope(std::size_t segment) const {  ///< between knots i and i + 1
        return (s_[segment + 1] - s_[segment]) / (e_[segment + 1] - e_[segment]);
    }

private:
    void integrate();

    std::vector<double> e_, s_;  ///< knots; one of them is (0, 0)
    std::vector<double> w_;      ///< energy at them
};

/// What is wrong with a curve of loading or unloading, as "... expected" of a fault has it; empty
/// when nothing is. It must pass (0, 0), rise to somewhere, and never fall or jump.
std::string loading_fault(const Curve& curve, Below below);

}  // namespace corpuscle::fabric
