// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/text/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace corpuscle::io {
namespace {

struct Row {
    Quantity quantity;
    std::string_view name, si, kg_mm_ms, ton_mm_s;
    std::string_view spoken;
    double factor;                ///< of the SI unit to the spoken one
    int second, metre, kilogram;  ///< powers of the base units in it
};

constexpr std::array ROWS{
    Row{Quantity::NONE, "none", "-", "-", "-", "-", 1.0, 0, 0, 0},
    Row{Quantity::TIME, "time", "s", "ms", "s", "ms", 1e3, 1, 0, 0},
    Row{Quantity::LENGTH, "length", "m", "mm", "mm", "mm", 1e3, 0, 1, 0},
    Row{Quantity::AREA, "area", "m^2", "mm^2", "mm^2", "cm^2", 1e4, 0, 2, 0},
    Row{Quantity::VOLUME, "volume", "m^3", "mm^3", "mm^3", "l", 1e3, 0, 3, 0},
    Row{Quantity::MASS, "mass", "kg", "kg", "t", "g", 1e3, 0, 0, 1},
    Row{Quantity::TEMPERATURE, "temperature", "K", "K", "K", "K", 1.0, 0, 0, 0},
    Row{Quantity::VELOCITY, "velocity", "m/s", "mm/ms", "mm/s", "m/s", 1.0, -1, 1, 0},
    Row{Quantity::ACCELERATION, "acceleration", "m/s^2", "mm/ms^2", "mm/s^2", "m/s^2", 1.0, -2, 1,
        0},
    Row{Quantity::MOMENTUM, "momentum", "kg m/s", "kg mm/ms", "t mm/s", "N s", 1.0, -1, 1, 1},
    Row{Quantity::ANGULAR_MOMENTUM, "angular momentum", "kg m2/s", "kg mm2/ms", "t mm2/s", "N m s",
        1.0, -1, 2, 1},
    Row{Quantity::FORCE, "force", "N", "kN", "N", "kN", 1e-3, -2, 1, 1},
    Row{Quantity::MOMENT, "moment", "N m", "kN mm", "N mm", "N m", 1.0, -2, 2, 1},
    Row{Quantity::PRESSURE, "pressure", "Pa", "GPa", "MPa", "kPa", 1e-3, -2, -1, 1},
    Row{Quantity::ENERGY, "energy", "J", "J", "mJ", "J", 1.0, -2, 2, 1},
    Row{Quantity::DENSITY, "density", "kg/m^3", "kg/mm^3", "t/mm^3", "kg/m^3", 1.0, 0, -3, 1},
};

constexpr bool rows_follow_the_enum() {
    for (std::size_t i = 0; i < ROWS.size(); ++i)
        if (static_cast<std::size_t>(ROWS[i].quantity) != i) return false;
    return true;
}
static_assert(rows_follow_the_enum());

}  // namespace

std::string unit_of(Quantity quantity, std::string_view unit_system) {
    const Row& row = ROWS.at(static_cast<std::size_t>(quantity));
    if (quantity == Quantity::NONE) return std::string(row.si);
    if (unit_system == "SI") return std::string(row.si);
    if (unit_system == "kg-mm-ms-K") return std::string(row.kg_mm_ms);
    if (unit_system == "ton-mm-s-K") return std::string(row.ton_mm_s);
    return fmt::format("deck [{}]", row.name);
}

SpokenUnit spoken(Quantity quantity, std::string_view unit_system) {
    const auto scale = scale_of(unit_system);
    if (!scale) return {1.0, unit_of(quantity, unit_system)};
    const Row& row = ROWS.at(static_cast<std::size_t>(quantity));
    return {row.factor * std::pow(scale->second, row.second) * std::pow(scale->metre, row.metre) *
                std::pow(scale->kilogram, row.kilogram),
            std::string(row.spoken)};
}

SpokenUnit spoken(std::string_view unit, std::string_view unit_system) {
    for (const Row& row : ROWS)
        if (unit == unit_of(row.quantity, unit_system)) return spoken(row.quantity, unit_system);
    return {1.0, std::string(unit)};
}

std::optional<UnitScale> scale_of(std::string_view unit_system) {
    if (unit_system == "SI") return UnitScale{};
    if (unit_system == "kg-mm-ms-K") return UnitScale{1e-3, 1e-3, 1.0};
    if (unit_system == "ton-mm-s-K") return UnitScale{1.0, 1e-3, 1e3};
    return std::nullopt;
}

}  // namespace corpuscle::io
