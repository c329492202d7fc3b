// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/law.hpp"

#include <fmt/format.h>

#include <array>

#include "fabric/materials/curved_law.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::fabric {

namespace {

using Faults = std::vector<Fault>;

/// What CurveFault::direction counts.
constexpr std::array<const char*, 3> DIRECTIONS{"warp", "weft", "shear"};

void require(Faults& faults, bool holds, const Material& material, Property property, double value,
             const char* expected) {
    if (!holds)
        faults.push_back({.of = fmt::format("material {}", material.id),
                          .property = property,
                          .value = value,
                          .why = fmt::format("expected {}", expected)});
}

void check(Faults& faults, const Material& m, const FabricCard& c) {
    require(faults, c.density > 0, m, Property::DENSITY, c.density, "> 0");
    require(faults, c.E_warp > 0, m, Property::WARP_MODULUS, c.E_warp, "> 0");
    require(faults, c.E_weft > 0, m, Property::WEFT_MODULUS, c.E_weft, "> 0");
    require(faults, c.G > 0, m, Property::SHEAR_MODULUS, c.G, "> 0");
    require(faults, c.nu_ba * c.nu_ba * c.E_warp < c.E_weft, m, Property::CROSS_POISSON_RATIO,
            c.nu_ba, "its square < weft/warp modulus, or stretching would give energy");
    require(faults, c.damping >= 0, m, Property::DAMPING, c.damping, ">= 0");
    require(faults, c.liner_E >= 0, m, Property::LINER_MODULUS, c.liner_E, ">= 0");
    require(faults, c.liner_ratio >= 0, m, Property::LINER_RATIO, c.liner_ratio, ">= 0");
    require(faults, c.coat_E >= 0, m, Property::COAT_MODULUS, c.coat_E, ">= 0");
    require(faults, c.coat_thickness >= 0, m, Property::COAT_THICKNESS, c.coat_thickness,
            "a thickness");
    require(faults, c.liner_nu > -1 && c.liner_nu < 1, m, Property::LINER_POISSON_RATIO, c.liner_nu,
            "-1 to 1");
}

void check(Faults& faults, const Material& m, const ElasticCard& c) {
    require(faults, c.density > 0, m, Property::DENSITY, c.density, "> 0");
    require(faults, c.E > 0, m, Property::MODULUS, c.E, "> 0");
    require(faults, c.nu > -1 && c.nu < 1, m, Property::POISSON_RATIO, c.nu, "-1 to 1");
}

void check(Faults& faults, const Material& m, const OwnCard& c) {
    require(faults, c.density > 0, m, Property::DENSITY, c.density, "> 0");
    require(faults, c.damping >= 0, m, Property::DAMPING, c.damping, ">= 0");
    if (c.law == nullptr) {
        faults.push_back({.of = fmt::format("material {}", m.id), .why = "it has no law"});
        return;
    }
    const PlaneModuli d = c.law->moduli();
    require(faults, d.warp > 0, m, Property::WARP_MODULUS, d.warp, "> 0");
    require(faults, d.weft > 0, m, Property::WEFT_MODULUS, d.weft, "> 0");
    require(faults, d.shear > 0, m, Property::SHEAR_MODULUS, d.shear, "> 0");
    require(faults, d.cross * d.cross < d.warp * d.weft, m, Property::CROSS_MODULUS, d.cross,
            "cross² < warp·weft, or stretching would give energy");
}

template <class Fabric>
Law maybe_lined(const Fabric& fabric, const PlaneModuli& layers) {
    if (layers.warp > 0) return Lined<Fabric>(fabric, layers);
    return fabric;
}

bool is_isotropic(const FabricCard& c) {
    constexpr double ROUNDING = 1e-9;  // decks hold six or more digits of G = E/2(1 + nu)
    return c.E_warp == c.E_weft &&
           std::abs(2.0 * c.G * (1.0 + c.nu_ba) - c.E_warp) < ROUNDING * c.E_warp;
}

Law fabric_law(const FabricCard& c, std::span<const Curve> curves, const PlaneModuli& layers) {
    if (c.curves.any()) return curved_law(c, curves, layers);
    if (!c.no_compression)
        return maybe_lined(Linear(orthotropic_moduli(c.E_warp, c.E_weft, c.nu_ba, c.G)), layers);
    if (is_isotropic(c)) return maybe_lined(IsotropicTensionField(c.E_warp, c.nu_ba), layers);
    return maybe_lined(OrthotropicTensionField(c.E_warp, c.E_weft, c.nu_ba, c.G), layers);
}

}  // namespace

PlaneModuli layer_moduli(const FabricCard& c, double thickness) {
    PlaneModuli all;
    if (c.liner_E > 0 && c.liner_ratio > 0 && !c.liner_waits)
        all = all + c.liner_ratio * isotropic_moduli(c.liner_E, c.liner_nu);
    if (c.has_coat() && c.coat_stretches)
        all = all + 2.0 * c.coat_thickness / thickness * isotropic_moduli(c.coat_E, 0.0);
    return all;
}

PartLaw make_law(const Material& material, std::span<const Curve> curves, double thickness) {
    Faults faults;
    if (const auto* fabric = std::get_if<FabricCard>(&material.card)) {
        check(faults, material, *fabric);
        for (const CurveFault& fault : curve_faults(*fabric, curves))
            faults.push_back(
                {.of = fmt::format("material {}", material.id),
                 .property = fault.unloads ? Property::UNLOADING_CURVE : Property::STRESS_CURVE,
                 .which = DIRECTIONS[fault.direction],
                 .why = "expected " + fault.expected});
        if (faults.empty()) {
            PartLaw law{fabric_law(*fabric, curves, layer_moduli(*fabric, thickness)),
                        fabric->density,
                        fabric->damping,
                        {},
                        {}};
            const double liner = fabric->liner_E * fabric->liner_ratio;
            if (fabric->liner_waits && liner > 0) law.liner.emplace(liner, fabric->liner_nu);
            law.restoration = fabric->restoration;
            return law;
        }
    } else if (const auto* elastic = std::get_if<ElasticCard>(&material.card)) {
        check(faults, material, *elastic);
        if (faults.empty())
            return {
                Linear(isotropic_moduli(elastic->E, elastic->nu)), elastic->density, 0.0, {}, {}};
    } else if (const auto* own = std::get_if<OwnCard>(&material.card)) {
        check(faults, material, *own);
        if (faults.empty()) return {EachLane(own->law), own->density, own->damping, {}, {}};
    } else {
        faults.push_back(
            {.of = {}, .why = fmt::format("material {} has no stiffness to strain", material.id)});
    }
    throw InputError(std::move(faults));
}

double density(const MaterialCard& card) {
    return std::visit([](const auto& c) { return c.density; }, card);
}

}  // namespace corpuscle::fabric
