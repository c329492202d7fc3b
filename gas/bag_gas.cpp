// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/bag_gas.hpp"

#include <algorithm>
#include <utility>

#include "gas/envelope.hpp"
#include "gas/particle_gas.hpp"
#include "gas/uniform_gas.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

BagGas::BagGas(const BagCard& card, BagWalls walls, std::span<const Curve> curves,
               std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
               std::uint64_t seed, std::span<const Index> body)
    : bag_(
          std::make_unique<Envelope>(card, std::move(walls), curves, node_id, held, x, seed, body)),
      particles_(std::make_unique<ParticleGas>(*bag_, curves, x, seed)),
      energy_at_start_(particles_->energy()) {}

void BagGas::add_load(const Points& x, const Points& v, std::span<const double> mass, double span,
                      Points& f) {
    bag_->surface->volumes(x, bag_->volumes);
    bag_->enclosure.node_areas(x, bag_->area);
    bag_->load.release(span, x, v, mass, f);
    now().add_load(x, f);
    const auto nodes = bag_->enclosure.nodes();
    parallel::for_each(nodes.size(), [&](std::size_t i) {
        f[nodes[i]] -= bag_->card.p_atm * bag_->area[nodes[i]];
    });
}

void BagGas::book_load(const Points& v_mid, double span) {
    bag_->balance.load_work += bag_->load.book(v_mid, span);
    const auto nodes = bag_->enclosure.nodes();
    const Points& area = bag_->area;
    const double swept = span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
                             return area[nodes[i]].dot(v_mid[nodes[i]]);
                         });
    bag_->balance.ambient_work += bag_->card.p_atm * swept;
    bag_->monitor.record(room_pressures(), bag_->time);
    now().book_load(v_mid, span);
}

/// That no particles bring.
std::vector<double> BagGas::room_pressures() const {
    std::vector<double> pressure(bag_->surface->rooms());
    for (std::size_t r = 0; r < pressure.size(); ++r) pressure[r] = now().pressure(r);
    return pressure;
}

void BagGas::inject(double t, double dt, const Points& x_0, const Points& x_1) {
    bag_->time = t + dt;
    now().inject(t, dt, x_0, x_1);
}

/// Contact presses a node harder than the gas does, from outside, where its force along the node's
/// inward area is more than gauge pressure times that area.
void BagGas::set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force) {
    if (bag_->card.block.by_pressure) {
        const std::vector<double> of_room = room_pressures();
        pressed_.assign(nodes.size(), 0);
        for (const Index n : bag_->enclosure.nodes()) {
            const Vec3& area = bag_->area[n];
            const double gauge = bag_->load.pressure_at_node(n) +
                                 bag_->load.mean_at_node(n, of_room) - bag_->card.p_atm;
            pressed_[n] = nodes[n] != 0 && -force[n].dot(area) > gauge * area.squaredNorm();
        }
    }
    bag_->openings.block(nodes, pressed_);
}

// ---- TSW

bool BagGas::switches(double t) const {
    constexpr double ROUNDING = 1e-12;  // t is a sum of many steps
    return !uniform_ && t >= bag_->card.switch_at * (1.0 - ROUNDING);
}

void BagGas::become_uniform(double dt, const Points& x_0, const Points& x_1) {
    if (bag_->inflators.species().empty() && bag_->air.empty()) return;
    std::vector<Vec3> wall = bag_->surface->mean_way(x_0, x_1);
    for (Vec3& way : wall) way /= dt;
    auto rooms = std::make_unique<UniformGas>(*bag_);
    rooms->take_over(particles_->holdings(), wall, x_0);
    particles_->freeze(wall);
    uniform_ = std::move(rooms);
}

// ---- what it looks like from outside

GasState BagGas::state(const Points& x) const {
    GasState state;
    state.volume = bag_->enclosure.volume(x);
    state.area = bag_->enclosure.area(x);
    state.mass_in = bag_->balance.mass_in;
    state.mass_out_vent = bag_->openings.mass_out(true);
    state.mass_out_fabric = bag_->openings.mass_out(false);
    state.particles_out = static_cast<double>(bag_->openings.particles_out());
    now().describe(state);
    return state;
}

std::vector<ChamberState> BagGas::chamber_states(const Points& x) const {
    if (bag_->chambers.empty()) return {};
    return bag_->sums_of_rooms(now(), bag_->chamber_of_room, bag_->chambers.size(), x);
}

ChamberState BagGas::room_state(const Vec3& at, const Points& x) const {
    if (bag_->surface->rooms() == 1) return state(x).as_chamber();
    std::vector<Index> sum_of(bag_->surface->rooms(), -1);
    sum_of[static_cast<std::size_t>(bag_->surface->rooms_of({&at, 1}, x)[0])] = 0;
    return bag_->sums_of_rooms(now(), sum_of, 1, x)[0];
}

PartState BagGas::part_losses() const {
    PartState parts;
    parts.mass_out.assign(bag_->openings.part_mass_out().begin(),
                          bag_->openings.part_mass_out().end());
    parts.heat.assign(bag_->heat_loss.part_heat().begin(), bag_->heat_loss.part_heat().end());
    return parts;
}

PartState BagGas::part_state(const Points& x, double since) {
    PartState parts = part_losses();
    bag_->monitor.part_means(bag_->walls, x, since, room_pressures(), parts);
    return parts;
}

PartState BagGas::part_state_so_far(const Points& x, double since) const {
    PartState parts = part_losses();
    WallMonitor untouched = bag_->monitor;
    untouched.part_means(bag_->walls, x, since, room_pressures(), parts);
    return parts;
}

void BagGas::add_shell_load(const Points& x, double since, ShellLoad& load) {
    bag_->monitor.add_shell_means(bag_->walls, bag_->card.p_atm, x, since, room_pressures(), load);
}

double BagGas::expected_share_in(double end_time) const {
    const Inflators& inflators = bag_->inflators;
    double so_far = 0.0, all = 0.0;
    for (std::size_t s = 0; s < inflators.inflows(); ++s) {
        so_far += inflators.mass_until(s, std::min(end_time, inflators.ends()));
        all += inflators.mass_until(s, inflators.ends());
    }
    return all > 0.0 ? so_far / all : 1.0;
}

BagGas::BagGas(BagGas&&) noexcept = default;
BagGas& BagGas::operator=(BagGas&&) noexcept = default;
BagGas::~BagGas() = default;

GasPhase& BagGas::now() {
    return uniform_ ? static_cast<GasPhase&>(*uniform_) : *particles_;
}
const GasPhase& BagGas::now() const {
    return uniform_ ? static_cast<const GasPhase&>(*uniform_) : *particles_;
}

template <class Archive>
void BagGas::visit(Archive& archive) {
    bool is_uniform = uniform_ != nullptr;
    archive(is_uniform);
    archive(*bag_, *particles_, pressed_);
    if (is_uniform && !uniform_) uniform_ = std::make_unique<UniformGas>(*bag_);
    if (uniform_) archive(*uniform_);
}
void BagGas::visit_state(StateWriter& archive) {
    visit(archive);
}
void BagGas::visit_state(StateReader& archive) {
    visit(archive);
}

Vec3 BagGas::force(Index node) const {
    return bag_->load.force(node) - bag_->card.p_atm * bag_->area[node] + now().load_on(node);
}

bool BagGas::asks_for_contact() const {
    return bag_->card.block.any() && !bag_->openings.empty();
}

void BagGas::prepare(double dt, const Points& x_0, const Points& x_1) {
    now().prepare(dt, x_0, x_1);
}

void BagGas::collide(double dt, const Points& x) {
    now().collide(dt, x);
}

void BagGas::fly(double t, double dt, const Points& x_0, const Points& x_1) {
    now().fly(t, dt, x_0, x_1);
}

double BagGas::stable_step() const {
    return now().stable_step();
}

double BagGas::energy() const {
    return now().energy();
}
double BagGas::inflow_energy() const {
    return bag_->balance.inflow_energy;
}
double BagGas::lost_energy() const {
    return bag_->balance.lost_energy;
}
double BagGas::smoothing_taken() const {
    return bag_->load.taken();
}
double BagGas::smoothing_given() const {
    return bag_->balance.load_work;
}
double BagGas::ambient_work() const {
    return bag_->balance.ambient_work;
}

const BagCard& BagGas::card() const {
    return bag_->card;
}
const BagWalls& BagGas::walls() const {
    return bag_->walls;
}
const Enclosure& BagGas::enclosure() const {
    return bag_->enclosure;
}
const Chambers& BagGas::chambers() const {
    return bag_->chambers;
}
const Openings& BagGas::openings() const {
    return bag_->openings;
}

const Particles& BagGas::particles() const {
    return particles_->particles();
}

std::span<const double> BagGas::particle_mass() const {
    return bag_->particle_mass;
}

double BagGas::particle_temperature(std::size_t i) const {
    const Particles& all = particles();
    return particles_->mixture().particle_temperature(all.species[i], all.e[i],
                                                      all.v[i].squaredNorm());
}

double BagGas::moles_each() const {
    return bag_->inflators.moles_each();
}

double BagGas::initial_air_pressure(const Vec3& at, const Points& x) const {
    if (uniform_ || bag_->air.empty()) return 0.0;
    return particles_->pressure(static_cast<std::size_t>(bag_->surface->rooms_of({&at, 1}, x)[0]));
}

const ParticleGas& BagGas::particle_gas() const {
    return *particles_;
}

std::size_t BagGas::lost() const {
    return particles_->lost();
}
const std::vector<std::string>& BagGas::losses() const {
    return particles_->losses();
}
std::size_t BagGas::hits() const {
    return particles_->hits();
}
std::size_t BagGas::flights() const {
    return particles_->flights();
}
std::size_t BagGas::unrelaxed() const {
    return particles_->unrelaxed();
}
std::uint64_t BagGas::collision_steps() const {
    return particles_->collision_steps();
}
std::size_t BagGas::list_builds() const {
    return particles_->list_builds();
}

const std::vector<std::string>& BagGas::warnings() const {
    return bag_->warnings;
}

Wrench BagGas::owed(double done) const {
    return bag_->load.owed(done);
}
double BagGas::load_delay() const {
    return bag_->load.time();
}

}  // namespace corpuscle::gas
