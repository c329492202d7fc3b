// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "io/text/units.hpp"

namespace corpuscle::tools {

/// Numbers of a deck as people say them: kPa, litres, grams, milliseconds, joules. Of a deck whose
/// units are not known as they stand, without a unit.
class Everyday {
public:
    explicit Everyday(std::string_view unit_system) {
        const auto scale = io::scale_of(unit_system);
        is_known_ = scale.has_value();
        if (scale) scale_ = *scale;
    }

    [[nodiscard]] bool is_known() const { return is_known_; }
    [[nodiscard]] std::string pressure(double p) const { return told(p, 1e-3 * pascal(), "kPa"); }
    [[nodiscard]] std::string volume(double V) const {
        return told(V, 1e3 * std::pow(scale_.metre, 3.0), "l");
    }
    [[nodiscard]] std::string length(double l) const { return told(l, 1e3 * scale_.metre, "mm"); }
    [[nodiscard]] std::string area(double A) const {
        return told(A, scale_.metre * scale_.metre, "m^2");
    }
    [[nodiscard]] std::string mass(double m) const { return told(m, 1e3 * scale_.kilogram, "g"); }
    [[nodiscard]] std::string time(double t) const { return told(t, 1e3 * scale_.second, "ms"); }
    [[nodiscard]] std::string energy(double E) const { return told(E, joule(), "J"); }

    [[nodiscard]] double pascal() const {  ///< in one unit of pressure
        return scale_.kilogram / (scale_.metre * scale_.second * scale_.second);
    }
    [[nodiscard]] double joule() const {  ///< in one unit of energy
        return scale_.kilogram * scale_.metre * scale_.metre / (scale_.second * scale_.second);
    }

private:
    [[nodiscard]] std::string told(double value, double factor, const char* unit) const {
        return is_known_ ? fmt::format("{:.5g} {}", value * factor, unit)
                         : fmt::format("{:.6g}", value);
    }

    bool is_known_ = false;
    io::UnitScale scale_;
};

}  // namespace corpuscle::tools
