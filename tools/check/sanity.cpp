// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/sanity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "gas/enclosure/enclosure.hpp"
#include "gas/inflow/flow_curve.hpp"
#include "gas/thermo/species.hpp"
#include "io/text/units.hpp"
#include "solver/base/constants.hpp"
#include "solver/scene/reference_geometry.hpp"
#include "solver/simulation.hpp"
#include "tools/check/filling.hpp"
#include "tools/check/flat_cloth.hpp"

namespace corpuscle::tools {
namespace {

constexpr double MOST_STRAIN = 0.3;
constexpr double MOST_SHRUNK = 400.0;  ///< area without stress over that of the mesh
constexpr double SHORTENED = 0.95;     ///< area over the flat one: folds have taken of it

/// Factors from deck units to SI.
struct ToSI {
    double time, length, mass;

    [[nodiscard]] double density() const { return mass / std::pow(length, 3.0); }
    [[nodiscard]] double pressure() const { return mass / (length * time * time); }
    [[nodiscard]] double energy() const { return mass * length * length / (time * time); }
};

/// A number in its everyday unit, or as the deck has it.
std::string told(double value, double to_unit, const char* unit, bool is_known) {
    return is_known ? fmt::format("{:.4g} {}", value * to_unit, unit)
                    : fmt::format("{:.4g}", value);
}

class Judge {
public:
    explicit Judge(const Simulation& simulation)
        : simulation_(simulation), flat_(reference_corners(simulation.model())) {
        const auto scale = io::scale_of(model().unit_system);
        is_known_ = scale.has_value();
        si_ = scale ? ToSI{scale->second, scale->metre, scale->kilogram} : ToSI{1.0, 1.0, 1.0};
    }

    Sanity judge() {
        cloth();
        if (has_references(model())) references();
        for (const gas::BagGas& bag : simulation_.bags()) particle_bag(bag);
        for (const gas::UniformBag& bag : simulation_.uniform_bags()) uniform_bag(bag);
        return std::move(out_);
    }

private:
    [[nodiscard]] const Model& model() const { return simulation_.model(); }
    [[nodiscard]] static double modulus(const fabric::Material& material) {
        if (const auto* cloth = std::get_if<fabric::FabricCard>(&material.card))
            return cloth->E_warp;
        if (const auto* sheet = std::get_if<fabric::ElasticCard>(&material.card)) return sheet->E;
        return NaN;
    }
    void say(std::string line) { out_.lines.push_back(std::move(line)); }
    void warn(std::string line) { out_.warnings.push_back(std::move(line)); }

    /// Warns of a number that is absurd by a power of ten that a wrong unit makes.
    void expect(const std::string& what, double value, double low, double high, const char* unit) {
        if (!is_known_ || (value >= low && value <= high) || std::isnan(value)) return;
        std::string likely;
        for (const double slip : {1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12})
            if (likely.empty() && value * slip >= low && value * slip <= high)
                likely = fmt::format(
                    "; {:.0e} times that would do: is it given in units other than "
                    "{}?",
                    slip, model().unit_system);
        warn(fmt::format("{} is {:.4g} {}, expected {:.3g} to {:.3g}{}", what, value, unit, low,
                         high, likely));
    }

    void cloth() {
        double mass = 0.0, all = 0.0;
        std::vector<bool> is_used(model().materials.size(), false);
        for (const Shell& shell : model().shells) {
            const Part& part = model().parts[shell.part];
            const fabric::Material& material = model().materials[part.material];
            if (std::isnan(modulus(material))) continue;
            is_used[part.material] = true;
            const double flat =
                area(flat_[static_cast<std::size_t>(&shell - model().shells.data())]);
            all += flat;
            const auto* cloth = std::get_if<fabric::FabricCard>(&material.card);
            mass += flat * part.thickness *
                    (cloth != nullptr ? cloth->density
                                      : std::get<fabric::ElasticCard>(material.card).density);
        }
        if (all > 0.0)
            say(fmt::format("cloth: {} on {}", told(mass, 1e3 * si_.mass, "g", is_known_),
                            told(all, si_.length * si_.length, "m^2", is_known_)));
        for (std::size_t m = 0; m < is_used.size(); ++m) {
            if (!is_used[m]) continue;
            const fabric::Material& material = model().materials[m];
            const auto* fabric = std::get_if<fabric::FabricCard>(&material.card);
            const double density = fabric != nullptr
                                       ? fabric->density
                                       : std::get<fabric::ElasticCard>(material.card).density;
            expect(fmt::format("material {}: its density", material.id), density * si_.density(),
                   50.0, 2e4, "kg/m^3");
            expect(fmt::format("material {}: its modulus", material.id),
                   modulus(material) * si_.pressure(), 1e5, 1e12, "Pa");
        }
    }

    /// Of cloth that is stretched at the start, or far larger than its mesh: in other units, it may be.
    void references() {
        const std::vector<double> births = reference_births(model());
        double now = 0.0, flat = 0.0, most = 1.0;
        std::size_t stretched = 0, worst = 0;
        for (std::size_t s = 0; s < flat_.size(); ++s) {
            const Shell& shell = model().shells[s];
            const fabric::Material& material =
                model().materials[model().parts[shell.part].material];
            const Corners start = corners(shell, model().x);
            if (start == flat_[s] || std::isnan(modulus(material))) continue;
            now += area(start);
            flat += area(flat_[s]);
            const auto* cloth = std::get_if<fabric::FabricCard>(&material.card);
            const bool waits = (!births.empty() && births[s] > 0.0) ||
                               (cloth != nullptr && cloth->restoration.any());
            const double stretch = waits ? 1.0 : greatest_stretch(start, flat_[s]);
            if (stretch > 1.0 + MOST_STRAIN) ++stretched;
            if (stretch > most) worst = s, most = stretch;
        }
        if (stretched > 0)
            warn(fmt::format(
                "{} shells are stretched by more than {:.0f} % of their reference "
                "geometry at the start, shell {} by {:.3g} %: is it in the mesh's units?",
                stretched, 100.0 * MOST_STRAIN, model().shells[worst].id, 100.0 * (most - 1.0)));
        if (flat > MOST_SHRUNK * now)
            warn(
                fmt::format("the reference geometry has {:.3g} times the area of its shells at the "
                            "start, expected at most {:.0f}: is it in the mesh's units?",
                            flat / now, MOST_SHRUNK));
    }

    /// Least E h of the cloth that closes a bag.
    [[nodiscard]] double stiffness(const gas::BagWalls& walls) const {
        double least = INF;
        for (std::size_t t = 0; t < walls.closing; ++t) {
            const Part& part = model().parts[model().shells[walls.shell[t]].part];
            const double E = modulus(model().materials[part.material]);
            if (E > 0.0) least = std::min(least, E * part.thickness);
        }
        return least;
    }

    /// Of cloth whose folds have shortened it: facets that resist compression do not crumple, and
    /// push as far as they reach.
    void advise_on_compression(const gas::BagWalls& walls) {
        std::map<int, std::array<double, 2>> areas;  // by material: now, flat
        for (std::size_t t = 0; t < walls.closing; ++t) {
            const Shell& shell = model().shells[walls.shell[t]];
            const fabric::Material& material =
                model().materials[model().parts[shell.part].material];
            const auto* cloth = std::get_if<fabric::FabricCard>(&material.card);
            if (cloth == nullptr) continue;
            const bool is_lined = !cloth->liner_waits && cloth->liner_E * cloth->liner_ratio > 0.0;
            if (!is_lined && cloth->no_compression) continue;
            areas[material.id][0] += area(corners(shell, model().x));
            areas[material.id][1] += area(flat_[walls.shell[t]]);
        }
        for (const auto& [id, of] : areas)
            if (of[0] < SHORTENED * of[1])
                say(
                    fmt::format("  material {} is folded to {:.3g} % of its flat area and resists "
                                "compression (CSE 0, or LRATIO and EL): what it exerts as it "
                                "unfolds depends on the size of its shells",
                                id, 100.0 * of[0] / of[1]));
    }

    /// Is the bag a tank, all of whose closing nodes are held or of rigid bodies?
    [[nodiscard]] bool is_stiff(const gas::BagWalls& walls) const {
        const std::vector<std::uint8_t> held = simulation_.scene().held_nodes();
        return std::all_of(
            walls.triangles.begin(),
            walls.triangles.begin() + static_cast<std::ptrdiff_t>(walls.closing),
            [&](const Triangle& t) { return held[t[0]] && held[t[1]] && held[t[2]]; });
    }

    void bag(int id, const gas::BagWalls& walls, double volume, double surface, double p_atm,
             const Filling& in, const Filling& inside) {
        const bool is_tank = is_stiff(walls);
        const double full = is_tank ? volume : full_volume(volume, surface);
        const double litre = 1e3 * std::pow(si_.length, 3.0), kPa = 1e-3 * si_.pressure();
        const std::string now = told(volume, litre, "l", is_known_);
        say(is_tank ? fmt::format("airbag {}: {}, of walls that are held", id, now)
                    : fmt::format("airbag {}: {} now, some {} full", id, now,
                                  told(full, litre, "l", is_known_)));
        advise_on_compression(walls);
        if (in.mass > 0.0)
            say(fmt::format(
                "  gas: {}{}, {}, {:.4g} to {:.4g} K",
                told(in.mass, 1e3 * si_.mass, "g", is_known_),
                is_known_ ? fmt::format(", {:.4g} mol", in.gas * si_.energy() / GAS_CONSTANT) : "",
                told(in.energy, 1e-3 * si_.energy(), "kJ", is_known_), in.coldest, in.hottest));
        const double heat = in.heat + inside.heat, gas = in.gas + inside.gas;
        if (!(heat > 0.0)) return;
        const double energy = in.energy + inside.energy - p_atm * (full - volume);
        const double p = gas / heat * energy / full - p_atm;
        say(fmt::format("  if nothing leaves: {} gauge in that volume",
                        told(p, kPa, "kPa", is_known_)));
        const double r = std::cbrt(0.75 * full / std::numbers::pi);
        const double strain = is_tank ? 0.0 : p * r / (2.0 * stiffness(walls));
        if (strain > 0.0) say(fmt::format("  cloth strains by {:.3g} % then", 100.0 * strain));
        if (strain > MOST_STRAIN)
            warn(
                fmt::format("airbag {}: that pressure strains its cloth by {:.3g} %: too much gas, "
                            "too soft or thin a cloth, or vents that must be there",
                            id, 100.0 * strain));
        if (is_known_ && p * si_.pressure() > 2e6)
            warn(
                fmt::format("airbag {}: its gas would have {:.3g} kPa if nothing left, a bag has "
                            "some 50: is the mass flow in {}?",
                            id, p * kPa, model().unit_system));
        if (in.coldest < 150.0 && in.mass > 0.0)
            warn(fmt::format("airbag {}: gas comes in at {:.4g} K, expected kelvin above 150", id,
                             in.coldest));
    }

    /// Of each gas: argon has 520, hydrogen 14 300 J/(kg K).
    void heat_capacity(int id, const gas::Species& gas) {
        constexpr double WARM = 400.0;  // [K]
        const double v = si_.length / si_.time;
        expect(fmt::format("airbag {}: Cp of its gas", id), gas.cp(WARM) * v * v, 400.0, 2e4,
               "J/(kg K)");
    }

    /// Of the bag without stress.
    template <class Bag>
    [[nodiscard]] double surface(const Bag& bag) const {
        return has_references(model()) ? closing_area(bag.walls(), flat_)
                                       : bag.enclosure().area(model().x);
    }

    void particle_bag(const gas::BagGas& bag) {
        const gas::BagCard& card = bag.card();
        for (const gas::InflowCard& flow : card.inflow)
            heat_capacity(card.id, gas::Species(flow.species, card.gas_constant, "gas"));
        const double volume = bag.enclosure().volume(model().x);
        this->bag(card.id, bag.walls(), volume, surface(bag), card.p_atm,
                  inflow_until(model(), card, card.all_in), air_in(card, volume));
    }

    void uniform_bag(const gas::UniformBag& bag) {
        if (bag.card().law) return;  // no gas
        const gas::UniformBagCard& card = bag.card();
        const gas::Species& gas = bag.gas().species()[0];
        for (const gas::Species& each : bag.gas().species()) heat_capacity(card.id, each);
        Filling in, inside;
        const auto blow = [&](Index rate, const gas::CurveOr& temperature,
                              const gas::Species& blown) {
            if (rate < 0) return;
            add_inflow(in, model().curves[rate], model().end_time, model().end_time, blown,
                       [&](double t) {
                           return temperature.curve >= 0 ? model().curves[temperature.curve](t)
                                                         : temperature.value;
                       });
        };
        if (card.gases.empty()) blow(card.mass_rate, card.temperature, gas);
        for (std::size_t k = 0; k < card.gases.size(); ++k)
            blow(card.gases[k].mass_rate, card.gases[k].temperature, bag.gas().species()[k]);
        const double T = bag.gas().temperature();
        inside.energy = bag.gas().energy();
        inside.heat = bag.gas().mass() * gas.cv(T);
        inside.gas = bag.gas().mass() * (gas.cp(T) - gas.cv(T));
        this->bag(card.id, bag.walls(), bag.gas().volume(), surface(bag), card.p_atm, in, inside);
    }

    const Simulation& simulation_;
    std::vector<Corners> flat_;  ///< stress-free, of each shell
    bool is_known_ = false;
    ToSI si_{1.0, 1.0, 1.0};
    Sanity out_;
};

}  // namespace

Sanity sanity_of(const Simulation& simulation) {
    return Judge(simulation).judge();
}

}  // namespace corpuscle::tools
