// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/uniform_bag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/exchange.hpp"
#include "gas/outflow/leak_speed.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Share of the gas that may leave in a step.
constexpr double MOST_LOSS = 0.002;

std::string name_of(const UniformBagCard& card) {
    return fmt::format("{} {}", card.keyword, card.id);
}

/// The card's gases, or its one gas with R / M = cp - cv; the mole's size is free then.
std::vector<UniformGasCard> gases_of(const UniformBagCard& card) {
    if (!card.gases.empty()) return card.gases;
    const double M = GAS_CONSTANT / (card.cp - card.cv);
    return {{{M, card.cp * M, 0.0, 0.0}, 1.0, card.mass_rate, card.temperature}};
}

std::vector<Species> species_of(const UniformBagCard& card) {
    std::vector<Species> species;
    for (const UniformGasCard& gas : gases_of(card))
        species.emplace_back(gas.species, card.gases.empty() ? GAS_CONSTANT : card.gas_constant,
                             name_of(card));
    return species;
}

}  // namespace

UniformBag::UniformBag(const UniformBagCard& card, BagWalls walls, std::span<const Curve> curves,
                       std::span<const int> node_id, const Points& x)
    : card_(card),
      walls_(std::move(walls)),
      enclosure_(walls_.triangles, x, node_id, name_of(card), Property::CLOSING_WALL),
      curves_(curves.begin(), curves.end()),
      gas_(species_of(card)),
      gases_(gases_of(card)),
      area_(x.size(), Vec3::Zero()) {
    if (enclosure_.turned() > 0)
        warnings_.push_back(
            fmt::format("{}: the normals of {} facets were turned to agree with "
                        "their neighbours",
                        name_of(card), enclosure_.turned()));
    const double V = volume(x);
    if (!(V > 0.0))
        throw InputError(Fault{.of = name_of(card),
                               .property = Property::START_VOLUME,
                               .value = V,
                               .why = "expected > 0: gas of a density fills it"});
    first_volume_ = V;
    if (card.law)
        follow_law(0.0, x);
    else
        fill(V);
    for (const UniformGasCard& gas : gases_) {
        inflow_.emplace_back();
        if (gas.mass_rate < 0) continue;
        const Curve& rate = curves[gas.mass_rate];
        if (const double least = *std::min_element(rate.y.begin(), rate.y.end()); !(least >= 0.0))
            throw InputError(
                Fault{.of = name_of(card),
                      .why = fmt::format("mass-flow curve {} falls to {:g}, expected >= 0", rate.id,
                                         least)});
        inflow_.back().emplace(rate, INF);
    }
    measure_exits(x);
    first_leak_area_ = leak_area_;
}

/// p = p_atm + POVER and RO give T = p / (RO R); with IABT p and T give the density. n = p V/(R T)
void UniformBag::fill(double V) {
    const double p = card_.p_atm + card_.overpressure, R = gas_.species()[0].gas_constant();
    const bool has_temperature = card_.start_temperature > 0.0;
    const double T =
        has_temperature ? card_.start_temperature : p / (card_.density * (card_.cp - card_.cv));
    double moles_per_mass = 0.0;
    for (std::size_t k = 0; k < gases_.size(); ++k)
        moles_per_mass += gases_[k].start_share / gas_.species()[k].molar_mass();
    for (std::size_t k = 0; k < gases_.size(); ++k) {
        const Species& gas = gas_.species()[k];
        const double moles =
            p * V / (R * T) * gases_[k].start_share / (gas.molar_mass() * moles_per_mass);
        gas_.add(k, moles, moles * gas.molar_energy()(T));
    }
    if (!gas_.settle(V))
        throw InputError(Fault{.of = name_of(card_),
                               .property = Property::START_STATE,
                               .why = "pressure and density give no temperature"});
}

/// Areas of exits that are shells, and of fabric that leaks.
void UniformBag::measure_exits(const Points& x) {
    exit_area_.assign(card_.exits.size(), 0.0);
    for (std::size_t k = 0; k < card_.exits.size(); ++k)
        exit_area_[k] = area_of(card_.exits[k].facets, x);
    leak_area_.assign(card_.leaks.size(), 0.0);
    for (std::size_t k = 0; k < card_.leaks.size(); ++k)
        for (std::size_t t = 0; t < walls_.triangles.size(); ++t)
            if (walls_.part_rows[walls_.part[t]] == card_.leaks[k].part)
                leak_area_[k] += vector_area(x[walls_.triangles[t][0]], x[walls_.triangles[t][1]],
                                             x[walls_.triangles[t][2]])
                                     .norm();
}

/// Pressure of the volume at t.
void UniformBag::follow_law(double t, const Points& x) {
    law_volume_ = volume(x);
    const double ratio = law_volume_ / first_volume_;
    if (!(ratio > 0.0))
        throw PhysicsError(t, fmt::format("{}: the volume is {:g}", name_of(card_), law_volume_));
    law_pressure_ = card_.law->curve >= 0
                        ? curves_[card_.law->curve](ratio)
                        : card_.law->scale * value(card_.law->coefficient, t) / ratio;
}

void UniformBag::add_load(double t, const Points& x, Points& f) {
    if (card_.law)
        follow_law(t, x);
    else if (!gas_.settle(volume(x)))
        throw PhysicsError(t, fmt::format("{}: the volume is {:g} and the gas holds {:g} of energy",
                                          name_of(card_), volume(x), gas_.energy()));
    enclosure_.node_areas(x, area_);
    measure_exits(x);
    gauge_since_frame_.add(t, gauge());
    for (const Index n : enclosure_.nodes()) f[n] += gauge() * area_[n];
}

void UniformBag::book_load(const Points& v_mid, double span) {
    const auto nodes = enclosure_.nodes();
    const double swept = span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
                             return area_[nodes[i]].dot(v_mid[nodes[i]]);
                         });
    const double given = card_.law ? 0.0 : gas_.work(card_.volume_scale * swept);
    const double on_fabric = gauge() * swept, on_air = card_.p_atm * swept;
    ambient_work_ += on_air;
    scaling_work_ += on_fabric + on_air - given;
}

void UniformBag::flow(double t, double dt) {
    rate_in_ = rate_out_ = 0.0;
    if (card_.law) return;
    flow_out(t, dt);
    flow_in(t, dt);
}

void UniformBag::give(double mass, double dt, UniformBag& to) {
    std::vector<double> moles(gases_.size());
    for (std::size_t k = 0; k < moles.size(); ++k) moles[k] = gas_.moles(k);
    const double energy = gas_.remove(mass);
    for (std::size_t k = 0; k < moles.size(); ++k)
        to.gas_.add(k, moles[k] - gas_.moles(k), k == 0 ? energy : 0.0);
    mass_out_ += mass;
    to.mass_in_ += mass;
    rate_out_ += mass / dt;
    to.rate_in_ += mass / dt;
}

void UniformBag::flow_in(double t, double dt) {
    for (std::size_t k = 0; k < gases_.size(); ++k) {
        if (!inflow_[k]) continue;
        const Species& gas = gas_.species()[k];
        const double mass = inflow_[k]->sum_until(t + dt) - inflow_[k]->sum_until(t);
        const double energy = mass * gas.h(value(gases_[k].temperature, t + 0.5 * dt));
        gas_.add(k, mass / gas.molar_mass(), energy);
        mass_in_ += mass;
        inflow_energy_ += energy;
        rate_in_ += mass / dt;
    }
}

/// At a rate in proportion to what is there, so that a bag never gives more than it has. What PPOP
/// has opened stays open.
void UniformBag::flow_out(double t, double dt) {
    is_open_ = is_open_ || gas_.pressure() - card_.p_atm >= card_.opens_at;
    const double rate = is_open_ ? exit_rate(t) : 0.0;
    if (!(rate > 0.0)) return;
    const double mass = -std::expm1(-rate * dt / gas_.mass()) * gas_.mass();
    outflow_energy_ += gas_.remove(mass);
    mass_out_ += mass;
    rate_out_ = mass / dt;
}

/// Mass flow out at t through exits that are open.                                        [kg/s]
double UniformBag::exit_rate(double t) const {
    const double p = gas_.pressure();
    if (!(p > card_.p_atm)) return 0.0;
    if (card_.exit_rate >= 0) return curves_[card_.exit_rate](p - card_.p_atm);
    double opening = 0.0;
    for (std::size_t k = 0; k < card_.exits.size(); ++k) {
        const ExitCard& exit = card_.exits[k];
        opening += value(exit.coefficient, exit.coefficient_of_pressure ? p : t) *
                   (exit.facets.empty() ? value(exit.area, p) : exit_area_[k]);
    }
    return leak_rate(t) + opening * orifice_flow(p, card_.p_atm, gas_.temperature(), gas_.gamma(),
                                                 gas_.gas_constant());
}

/// Mass flow through fabric that leaks, density · FLC · area · speed.                     [kg/s]
double UniformBag::leak_rate(double t) const {
    const double p = gas_.pressure(), density = gas_.mass() / gas_.volume();
    double rate = 0.0;
    for (std::size_t k = 0; k < card_.leaks.size(); ++k) {
        const UniformLeak& leak = card_.leaks[k];
        if (leak.growth) {
            const std::array<double, 4>& X = *leak.growth;
            const double rs = leak_area_[k] / first_leak_area_[k], rp = card_.p_atm / p;
            const double open = X[0] + X[1] * rs + X[2] * rp + X[3] * rs * rp;
            rate +=
                std::max(0.0, first_leak_area_[k] * open) *
                orifice_flow(p, card_.p_atm, gas_.temperature(), gas_.gamma(), gas_.gas_constant());
            continue;
        }
        rate += density * value(leak.share, t) * leak_area_[k] * value(leak.factor, p) *
                leak_speed(leak.law, p, card_.p_atm, density, gas_.gamma());
    }
    return rate;
}

double UniformBag::stable_step() const {
    return rate_out_ > 0.0 ? MOST_LOSS * gas_.mass() / rate_out_ : INF;
}

GasState UniformBag::state(const Points& x) const {
    GasState now;
    now.area = enclosure_.area(x);
    now.pressure = now.static_pressure = pressure();
    now.species = {{0.0, 0.0, 0.0}};
    now.volume = card_.law ? law_volume_ : gas_.volume();
    now.translational = 1.5 * now.pressure * now.volume;
    if (card_.law) return now;
    now.temperature = now.static_temperature = gas_.temperature();
    now.mass = gas_.mass();
    now.mass_in = mass_in_;
    now.energy = gas_.energy();
    now.species = {{now.mass, now.temperature, now.energy}};
    return now;
}

PartState UniformBag::part_state(const Points& x) const {
    const std::size_t parts = walls_.part_ids.size();
    PartState state{std::vector<double>(parts, card_.pressure_scale * pressure()),
                    std::vector<double>(parts, 0.0), std::vector<double>(parts, 0.0),
                    std::vector<double>(parts, 0.0)};
    for (std::size_t t = 0; t < walls_.triangles.size(); ++t) {
        const auto& [a, b, c] = walls_.triangles[t];
        state.area[walls_.part[t]] += vector_area(x[a], x[b], x[c]).norm();
    }
    return state;
}

void UniformBag::add_shell_load(const Points& x, double since, ShellLoad& load) {
    const double mean = gauge_since_frame_.take_mean(since, gauge());
    for (std::size_t t = 0; t < walls_.triangles.size(); ++t) {
        const auto& [a, b, c] = walls_.triangles[t];
        const double size = vector_area(x[a], x[b], x[c]).norm();
        const bool is_turned = enclosure_.triangles()[t] != walls_.triangles[t];
        load.force[walls_.shell[t]] += load.sign(walls_.shell[t], is_turned) * mean * size;
    }
}

}  // namespace corpuscle::gas
