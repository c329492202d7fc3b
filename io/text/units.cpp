// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/text/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "io/text/text.hpp"

namespace corpuscle::io {
namespace {

struct Row {
    Quantity quantity;
    std::string_view name, spoken;
    double factor;                ///< of the SI unit to the spoken one
    int second, metre, kilogram;  ///< powers of the base units in it
};

constexpr std::array ROWS{
    Row{Quantity::NONE, "none", "-", 1.0, 0, 0, 0},
    Row{Quantity::TIME, "time", "ms", 1e3, 1, 0, 0},
    Row{Quantity::LENGTH, "length", "mm", 1e3, 0, 1, 0},
    Row{Quantity::AREA, "area", "cm^2", 1e4, 0, 2, 0},
    Row{Quantity::VOLUME, "volume", "l", 1e3, 0, 3, 0},
    Row{Quantity::MASS, "mass", "g", 1e3, 0, 0, 1},
    Row{Quantity::TEMPERATURE, "temperature", "K", 1.0, 0, 0, 0},
    Row{Quantity::VELOCITY, "velocity", "m/s", 1.0, -1, 1, 0},
    Row{Quantity::ACCELERATION, "acceleration", "m/s^2", 1.0, -2, 1, 0},
    Row{Quantity::MOMENTUM, "momentum", "N s", 1.0, -1, 1, 1},
    Row{Quantity::ANGULAR_MOMENTUM, "angular momentum", "N m s", 1.0, -1, 2, 1},
    Row{Quantity::FORCE, "force", "kN", 1e-3, -2, 1, 1},
    Row{Quantity::MOMENT, "moment", "N m", 1.0, -2, 2, 1},
    Row{Quantity::PRESSURE, "pressure", "kPa", 1e-3, -2, -1, 1},
    Row{Quantity::ENERGY, "energy", "J", 1.0, -2, 2, 1},
    Row{Quantity::DENSITY, "density", "kg/m^3", 1.0, 0, -3, 1},
};

/// Pounds and inches: exact by the definitions of the inch, the pound and standard gravity.
constexpr double INCH = 0.0254, POUND_FORCE = 0.45359237 * 9.80665;

/// A consistent system: its base units, and its units' names in the order of Quantity.
struct System {
    std::string_view name, other_name;  ///< "kg-mm-ms-K" and, without kelvin, "kg-mm-ms"
    UnitScale scale;
    std::array<std::string_view, ROWS.size()> units;
};

constexpr std::array SYSTEMS{
    System{"SI",
           "kg-m-s",
           {1.0, 1.0, 1.0},
           {"-", "s", "m", "m^2", "m^3", "kg", "K", "m/s", "m/s^2", "kg m/s", "kg m2/s", "N", "N m",
            "Pa", "J", "kg/m^3"}},
    System{"kg-mm-ms-K",
           "kg-mm-ms",
           {1e-3, 1e-3, 1.0},
           {"-", "ms", "mm", "mm^2", "mm^3", "kg", "K", "mm/ms", "mm/ms^2", "kg mm/ms", "kg mm2/ms",
            "kN", "kN mm", "GPa", "J", "kg/mm^3"}},
    System{"ton-mm-s-K",
           "ton-mm-s",
           {1.0, 1e-3, 1e3},
           {"-", "s", "mm", "mm^2", "mm^3", "t", "K", "mm/s", "mm/s^2", "t mm/s", "t mm2/s", "N",
            "N mm", "MPa", "mJ", "t/mm^3"}},
    System{"g-mm-ms-K",
           "g-mm-ms",
           {1e-3, 1e-3, 1e-3},
           {"-", "ms", "mm", "mm^2", "mm^3", "g", "K", "mm/ms", "mm/ms^2", "g mm/ms", "g mm2/ms",
            "N", "N mm", "MPa", "mJ", "g/mm^3"}},
    System{"lbf-in-s-K",
           "lbf-in-s",
           {1.0, INCH, POUND_FORCE / INCH},
           {"-", "s", "in", "in^2", "in^3", "lbf s2/in", "K", "in/s", "in/s^2", "lbf s", "lbf in s",
            "lbf", "lbf in", "psi", "in lbf", "lbf s2/in^4"}},
};

const System* system_of(std::string_view name) {
    for (const System& system : SYSTEMS)
        if (system.name == name) return &system;
    return nullptr;
}

constexpr bool rows_follow_the_enum() {
    for (std::size_t i = 0; i < ROWS.size(); ++i)
        if (static_cast<std::size_t>(ROWS[i].quantity) != i) return false;
    return true;
}
static_assert(rows_follow_the_enum());

}  // namespace

std::string unit_of(Quantity quantity, std::string_view unit_system) {
    const auto at = static_cast<std::size_t>(quantity);
    if (quantity == Quantity::NONE) return "-";
    if (const System* system = system_of(unit_system)) return std::string(system->units.at(at));
    return fmt::format("deck [{}]", ROWS.at(at).name);
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
    if (const System* system = system_of(unit_system)) return system->scale;
    return std::nullopt;
}

std::string_view unit_system_named(std::string_view word) {
    const std::string wanted = upper(trim(word));
    for (const System& system : SYSTEMS)
        if (wanted == upper(system.name) || wanted == upper(system.other_name)) return system.name;
    if (wanted == "T-MM-S") return "ton-mm-s-K";
    return {};
}

std::vector<std::string_view> unit_system_names() {
    std::vector<std::string_view> names;
    for (const System& system : SYSTEMS) names.push_back(system.name);
    return names;
}

std::string unit_systems() {
    std::string text;
    for (std::size_t k = 0; k < SYSTEMS.size(); ++k)
        text += fmt::format("{}{}",
                            k == 0                    ? ""
                            : k + 1 == SYSTEMS.size() ? " or "
                                                      : ", ",
                            SYSTEMS[k].name);
    return text;
}

}  // namespace corpuscle::io
