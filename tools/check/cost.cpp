// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/cost.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"
#include "solver/scene/reference_geometry.hpp"
#include "solver/simulation.hpp"
#include "tools/check/filling.hpp"
#include "tools/check/flat_cloth.hpp"

namespace corpuscle::tools {
namespace {

// Costs of a step on one core of a server of 2023, from the phases of runs of the models.   [s]
constexpr double A_STEP = 50e-6;  ///< of a scene with next to nothing in it
constexpr double A_FLIGHT = 60e-9;
constexpr double A_COLLISION = 15e-9, A_COLLISION_OF_MIXTURES = 130e-9;  ///< of a particle
constexpr double A_FACET = 350e-9;                                       ///< of a bag of particles
constexpr double A_FACET_OF_UNIFORM_GAS = 50e-9;
constexpr double AN_ELEMENT = 80e-9, A_NODE = 60e-9;
constexpr double A_CONTACT_SHELL = 600e-9;  ///< of cloth that has come apart
constexpr double A_NEAR_PAIR = 2.5e-6;      ///< of a pack
constexpr double A_PARTICLE_OF_A_FRAME = 250e-9, A_SHELL_OF_A_FRAME = 500e-9;

/// Share of the gas by which all but 1/e of a pack's pairs have come apart: the folded driver bag's.
constexpr double OPENING = 0.1;

/// Cloth that is stretched and sheared wants smaller steps than at the start: steps of the folded and
/// the flat driver bag over end time / first step.
constexpr double MORE_STEPS = 1.2;

/// Share of a run that one thread does alone, or that is lost to waiting (Amdahl).
constexpr double SERIAL = 0.1;

constexpr double HOTTER =
    1.2;  ///< head room of the first gas step over the hottest gas, as gas::Inflators has it

constexpr double CHOKED =
    0.6;  ///< flow of a choked nozzle, or of effusion, over area, density and sqrt(R T / M)

constexpr int BINS = 100;  ///< of the run's time

/// Of a bag without stress.
double surface(const gas::BagGas& bag, const Model& model) {
    return has_references(model) ? closing_area(bag.walls(), reference_corners(model))
                                 : bag.enclosure().area(model.x);
}

/// A bag of particles as it fills.
class FillingBag {
public:
    FillingBag(const gas::BagGas& bag, const Model& model, bool can_grow)
        : bag_(bag),
          model_(model),
          start_volume_(bag.enclosure().volume(model.x)),
          full_(can_grow ? full_volume(start_volume_, surface(bag, model)) : start_volume_),
          first_(bag.stable_step()),
          resident_(static_cast<double>(bag.particles().size())),
          all_(std::max(resident_, static_cast<double>(bag.card().particles))) {
        // as gas::ParticleGas takes it: the lightest gas at the highest temperature at rest
        const double R = bag.card().gas_constant;
        double lightest = INF, hottest = bag.card().air ? bag.card().air->temperature : 0.0;
        const double T_in = inflow_until(model, bag.card(), bag.card().all_in).hottest;
        for (const gas::InflowCard& flow : bag.card().inflow) {
            const gas::Species gas(flow.species, R, "gas");
            lightest = std::min(lightest, gas.molar_mass());
            if (T_in > 0.0) hottest = std::max(hottest, gas.stagnation_temperature(T_in));
        }
        if (bag.card().air)
            lightest =
                std::min(lightest, gas::Species(bag.card().air->species, R, "air").molar_mass());
        first_speed_ = std::sqrt(R * HOTTER * hottest / lightest);
    }

    [[nodiscard]] double share_in(double t) const { return bag_.expected_share_in(t); }
    [[nodiscard]] double particles() const { return is_uniform_ ? 0.0 : inside_; }

    /// On to time t: what comes in, and what leaves until the pressure outside is reached.
    void advance(double t, double dt) {
        is_uniform_ = t >= bag_.card().switch_at;
        const double share = share_in(t), come = resident_ + (all_ - resident_) * share;
        inside_ += come - come_;
        come_ = come;
        Filling gas = inflow_until(model_, bag_.card(), t);
        if (has_air()) gas += air_in(bag_.card(), start_volume_);
        if (!(gas.mass > 0.0) || !(come > 0.0)) return;
        speed_ = gas.thermal_speed();
        const double pV = gas.gas / gas.heat * gas.energy,
                     p_atm = bag_.card().p_atm;  // if none left
        volume_ = std::clamp(pV * inside_ / come / p_atm, start_volume_, full_);
        const double p = pV * inside_ / come / volume_;
        if (p <= p_atm) return;
        const double lost = (effusing_area(t) * CHOKED * speed_ + leak_flow(t, p)) / volume_ * dt;
        inside_ *= std::max(std::exp(-lost), p_atm / p);
    }

    /// That gas wants.                                                                         [s]
    [[nodiscard]] double step() const {
        if (!(particles() > 0.0)) return INF;
        if (std::isnan(speed_)) return first_;
        return first_ * std::cbrt(all_ / inside_ * volume_ / start_volume_) * first_speed_ / speed_;
    }

    [[nodiscard]] double seconds_of_step() const {
        if (is_uniform_) return A_FACET_OF_UNIFORM_GAS * facets();
        const double each = A_FLIGHT + (are_alike() ? A_COLLISION : A_COLLISION_OF_MIXTURES);
        return each * inside_ + A_FACET * facets();
    }

private:
    [[nodiscard]] bool has_air() const { return bag_.card().air && bag_.card().air->is_particles; }
    [[nodiscard]] double facets() const {
        return static_cast<double>(bag_.walls().triangles.size());
    }
    /// Whether all particles are of one gas whose heat capacity is constant: then a collision sorts
    /// nothing.
    [[nodiscard]] bool are_alike() const {
        std::vector<gas::SpeciesCard> gases;
        for (const gas::InflowCard& flow : bag_.card().inflow) gases.push_back(flow.species);
        if (has_air()) gases.push_back(bag_.card().air->species);
        return std::all_of(gases.begin(), gases.end(), [&](const gas::SpeciesCard& gas) {
            return gas.molar_mass == gases[0].molar_mass && gas.A == gases[0].A && gas.B == 0.0 &&
                   gas.C == 0.0;
        });
    }
    /// Of the shells of a part that close the bag.                                             [m^2]
    [[nodiscard]] double area_of(Index part) const {
        double area = 0.0;
        for (std::size_t t = 0; t < bag_.walls().closing; ++t) {
            if (model_.shells[bag_.walls().shell[t]].part != part) continue;
            const auto& n = bag_.walls().triangles[t];
            const Points& x = model_.x;
            area += 0.5 * (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).norm();
        }
        return area;
    }
    /// Of vents that lead out, times their coefficients.                                       [m^2]
    [[nodiscard]] double effusing_area(double t) const {
        double area = 0.0;
        for (const gas::VentCard& vent : bag_.card().vents)
            for (const Index part : vent.parts)
                area += area_of(part) * vent.coefficient *
                        (vent.time_curve >= 0 ? model_.curves[vent.time_curve](t) : 1.0);
        return area;
    }
    /// Volume that leaves through fabric whose law is a velocity.                          [m^3/s]
    [[nodiscard]] double leak_flow(double t, double p) const {
        double flow = 0.0;
        for (const gas::LeakCard& leak : bag_.walls().leaks)
            if (leak.law == gas::LeakLaw::VELOCITY && !leak.growth)
                flow += area_of(leak.part) *
                        (leak.area_curve >= 0 ? model_.curves[leak.area_curve](t) : leak.area) *
                        (leak.velocity_curve >= 0 ? model_.curves[leak.velocity_curve](p)
                                                  : leak.velocity);
        return flow;
    }

    const gas::BagGas& bag_;
    const Model& model_;
    double start_volume_, full_;                    ///< at the start, and at most      [m^3]
    double volume_ = start_volume_;                 ///< of now                         [m^3]
    double first_;                                  ///< step                           [s]
    double resident_, all_;                         ///< particles at the start, in all
    double inside_ = resident_, come_ = resident_;  ///< now, and so far
    double first_speed_ = NaN;                      ///< that the first step is for     [m/s]
    double speed_ = NaN;                            ///< thermal, of what is inside     [m/s]
    bool is_uniform_ = false;                       ///< after TSW
};

/// Of a step, but for gas and what near pairs cost.                                            [s]
double seconds_without_gas(const Simulation& simulation) {
    const Model& model = simulation.model();
    double seconds = A_STEP + A_NODE * static_cast<double>(model.x.size()) +
                     AN_ELEMENT * static_cast<double>(simulation.active_shells());
    if (!model.contacts.empty())
        seconds += A_CONTACT_SHELL * static_cast<double>(model.shells.size());
    for (const gas::UniformBag& bag : simulation.uniform_bags())
        seconds += A_FACET_OF_UNIFORM_GAS * static_cast<double>(bag.walls().closing);
    return seconds;
}

/// All of the run's, if all were as one that is written now.                                   [s]
double seconds_of_frames(const Model& model, const std::vector<FillingBag>& bags) {
    const double frames =
        std::isnan(model.output.frames) ? 2.0 : model.end_time / model.output.frames;
    double each = A_SHELL_OF_A_FRAME * static_cast<double>(model.shells.size());
    for (const FillingBag& bag : bags) each += A_PARTICLE_OF_A_FRAME * bag.particles();
    return frames * each;
}

}  // namespace

Cost cost_of(const Simulation& simulation) {
    const Model& model = simulation.model();
    Cost cost;
    cost.first = simulation.stable_step(/*without_start=*/true);
    const StepLimit shells = simulation.shells_step();
    const double by_cloth = shells.dt / MORE_STEPS;
    const double by_nothing = model.end_time / 1000.0;  // as SceneState::stable_step() has it
    std::vector<FillingBag> bags;
    for (const gas::BagGas& bag : simulation.bags()) bags.emplace_back(bag, model, shells.dt < INF);
    const double pairs =
        simulation.contact() ? static_cast<double>(simulation.contact()->counts().near) : 0.0;
    const double share = SERIAL + (1.0 - SERIAL) / parallel::threads();  // of one thread's time
    const double without_gas = seconds_without_gas(simulation), bin = model.end_time / BINS;
    double one_thread = 0.0;
    for (int k = 0; k < BINS; ++k) {
        const double t = (k + 0.5) * bin;
        double dt = by_cloth, seconds = without_gas, opened = 0.0;
        for (FillingBag& bag : bags) {
            bag.advance(t, bin);
            dt = std::min(dt, step_beside(bag.step(), by_cloth));
            seconds += bag.seconds_of_step();
            opened = std::max(opened, bag.share_in(t));
        }
        if (dt == INF) dt = by_nothing;
        seconds += A_NEAR_PAIR * pairs * std::exp(-opened / OPENING);
        cost.steps += bin / std::min(dt, bin);
        one_thread += bin / std::min(dt, bin) * seconds + seconds_of_frames(model, bags) / BINS;
    }
    cost.seconds = share * one_thread + static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return cost;
}

}  // namespace corpuscle::tools
