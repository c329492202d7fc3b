// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/materials/stretch.hpp"

/// What the abscissa and the ordinate of a stress-strain curve are. A measure turns Green strain
/// into the strains ε of warp, weft and angle, and the stresses σ along them into second
/// Piola-Kirchhoff stress by S = σ·dε/dE: whatever energy the curves hold, force is its slope.
namespace corpuscle::fabric {

/// FORM 4: second Piola-Kirchhoff stress over Green strain; the angle's is 2·E12.
class GreenMeasure {
public:
    explicit GreenMeasure(const Strain<double>& e) : e_(e) {}

    [[nodiscard]] const Strain<double>& strain() const { return e_; }
    [[nodiscard]] static Stress<double> stress(double warp, double weft, double shear) {
        return {warp, weft, shear, 0.0};
    }
    /// Bound of the stiffness by that at rest, as without curves.
    [[nodiscard]] double stiffening(const PlaneModuli& d) const {
        return stretch_stiffening(e_, d);
    }

private:
    Strain<double> e_;
};

/// FORM 14: force per first area over change of length, l = |g|, and over the angle γ that the
/// yarns turn towards each other, sin γ = g1·g2/(l1·l2); yarns that do not stay at right angles
/// pull along themselves, and only τ resists their turning:
///
///     P_1 = σ_1 g1/l1 + (τ/cos γ)(g2/(l1 l2) - sin γ·g1/l1²),   P_2 alike
///
/// Where a yarn has less than SHORT of its length, or lies within 10° of the other, l and γ go on
/// along their tangents: no force grows without bounds in elements that are momentarily crushed or
/// flat, and the energy stays one.
class EngineeringMeasure {
public:
    explicit EngineeringMeasure(const Strain<double>& e) {
        length(e.warp, l_1_, dl_1_);
        length(e.weft, l_2_, dl_2_);
        sine_ = e.shear / (l_1_ * l_2_);
        const double within = std::clamp(sine_, -FLAT_SINE, FLAT_SINE);
        slope_ = 1.0 / std::sqrt(1.0 - within * within);
        angle_ = std::asin(within) + slope_ * (sine_ - within);
    }

    [[nodiscard]] Strain<double> strain() const { return {l_1_ - 1.0, l_2_ - 1.0, angle_}; }
    [[nodiscard]] Stress<double> stress(double warp, double weft, double shear) const {
        const double turn = shear * slope_;
        return {(warp - turn * sine_ / l_1_) * dl_1_, (weft - turn * sine_ / l_2_) * dl_2_,
                turn / (l_1_ * l_2_), 0.0};
    }
    /// With k <= D for each curve, |σ| <= D·ε: the yarns' share grows by 1 + |sin γ| as they close
    /// up, the angle's with 1/l² and near 90°; d²W of dg1, dg2 bounded term by term.
    [[nodiscard]] double stiffening(const PlaneModuli& d) const {
        const double shortest = std::min(l_1_, l_2_), over = 1.0 / (shortest * shortest);
        const double bend = std::abs(angle_) * slope_;
        const double share = d.shear / std::min(d.warp, d.weft);
        const double turn = (1.0 + bend * std::abs(sine_)) * over;
        return (1.0 + std::abs(sine_)) * std::max(1.0, turn) + 4.0 * share * bend * over;
    }

private:
    static constexpr double SHORT = 0.1;
    static constexpr double FLAT_SINE = 0.984807753012208;  // sin 80°

    static void length(double E, double& l, double& dl) {
        const double square = 1.0 + 2.0 * E;
        const double root = std::sqrt(std::max(square, SHORT * SHORT));
        dl = 1.0 / root;
        l = square < SHORT * SHORT ? SHORT + 0.5 * (square - SHORT * SHORT) / SHORT : root;
    }

    double l_1_, l_2_, dl_1_, dl_2_;
    double sine_, angle_, slope_;  ///< sin γ, γ, dγ/d sin γ
};

}  // namespace corpuscle::fabric
