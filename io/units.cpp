// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace corpuscle::io {
namespace {

struct Row {
    Quantity quantity;
    std::string_view name, si, kg_mm_ms, ton_mm_s;
};

constexpr std::array ROWS{
    Row{Quantity::NONE, "none", "-", "-", "-"},
    Row{Quantity::TIME, "time", "s", "ms", "s"},
    Row{Quantity::LENGTH, "length", "m", "mm", "mm"},
    Row{Quantity::AREA, "area", "m^2", "mm^2", "mm^2"},
    Row{Quantity::VOLUME, "volume", "m^3", "mm^3", "mm^3"},
    Row{Quantity::MASS, "mass", "kg", "kg", "t"},
    Row{Quantity::TEMPERATURE, "temperature", "K", "K", "K"},
    Row{Quantity::VELOCITY, "velocity", "m/s", "mm/ms", "mm/s"},
    Row{Quantity::ACCELERATION, "acceleration", "m/s^2", "mm/ms^2", "mm/s^2"},
    Row{Quantity::MOMENTUM, "momentum", "kg m/s", "kg mm/ms", "t mm/s"},
    Row{Quantity::ANGULAR_MOMENTUM, "angular momentum", "kg m2/s", "kg mm2/ms", "t mm2/s"},
    Row{Quantity::FORCE, "force", "N", "kN", "N"},
    Row{Quantity::PRESSURE, "pressure", "Pa", "GPa", "MPa"},
    Row{Quantity::ENERGY, "energy", "J", "J", "mJ"},
    Row{Quantity::DENSITY, "density", "kg/m^3", "kg/mm^3", "t/mm^3"},
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

std::optional<UnitScale> scale_of(std::string_view unit_system) {
    if (unit_system == "SI") return UnitScale{};
    if (unit_system == "kg-mm-ms-K") return UnitScale{1e-3, 1e-3, 1.0};
    if (unit_system == "ton-mm-s-K") return UnitScale{1.0, 1e-3, 1e3};
    return std::nullopt;
}

}  // namespace corpuscle::io
