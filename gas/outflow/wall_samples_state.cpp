// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What samples remember of hits, and the state of the gas that this tells.

#include <algorithm>
#include <cmath>

#include "gas/outflow/wall_samples.hpp"

namespace corpuscle::gas {
namespace {

/// Hits that a sample remembers. More: steadier, and later to know.
constexpr double HITS = 1000.0;

/// Steps that it remembers at least.
constexpr double STEPS = 4.0;

/// The steady memory, in times of the longest of the quick one.
constexpr double STEADIER = 15.0;

/// Standard deviations between the two memories from which the state has changed.
constexpr double CHANGED = 3.5;

/// Change of the pressure at a wall for one of its room's, and the error of it, while nothing else is known.
constexpr double SLOPE = 0.5, SLOPE_ERROR = 0.5;

/// Standard deviations of the variance between patches that chance is allowed.
constexpr double CHANCE = 2.0;

/// Share of T up to which what all hits of a room have in common is the model's doing: in a group
/// motion and internal energy fluctuate against each other, so that those that hit, the faster
/// ones, carry some 0.3 % less than gas of the room's T does. As much as chance makes comes on top.
constexpr double MODEL_BIAS = 0.01;

/// Of j / (rho sigma) / (n^(1/3) L), by how much hits beside a hole press more than the gas has pressure.
constexpr double STRAIN = 0.45;

/// By how much all hits on the patches of a room seem warmer than its gas at T, as far as the model
/// makes it.                                                                            [K]
template <class Samples>
double common_bias(const Samples& samples, std::size_t patches, Index room, double T) {
    double energy = 0.0, energy2 = 0.0, slope = 0.0;
    for (std::size_t k = 0; k < patches; ++k) {
        const auto& sample = samples[k];
        if (sample.room != room || !sample.tells) continue;
        energy += sample.quick.energy;
        energy2 += sample.quick.energy2;
        slope += sample.quick.slope;
    }
    if (!(slope > 0.0)) return 0.0;
    const double most = MODEL_BIAS * std::max(0.0, T) + CHANGED * std::sqrt(0.5 * energy2) / slope;
    return std::clamp(energy / slope, -most, most);
}

}  // namespace

void WallSamples::Memory::clear() {
    std::fill(of.begin(), of.end(), 0.0);
    std::vector<double> kept = std::move(of);
    *this = {};
    of = std::move(kept);
}

void WallSamples::Memory::renew(double kept, const Memory& more) {
    const auto add = [&](double& old, double fresh) { old = kept * old + fresh; };
    add(exposure, more.exposure);
    add(push, more.push);
    add(room, more.room);
    add(room2, more.room2);
    add(push_room, more.push_room);
    add(push2, more.push2);
    add(count, more.count);
    add(energy, more.energy);
    add(energy2, more.energy2);
    add(slope, more.slope);
    add(mass, more.mass);
    momentum = kept * momentum + more.momentum;
    add(square, more.square);
    for (std::size_t k = 0; k < of.size(); ++k) add(of[k], more.of[k]);
}

/// Least squares, means by exposure W = integral A dt, chance s² W = sum J² / 2 / W:
///
///     p(p_room) = p_hits + b (p_room - mean),        error²: s² + s² W (p_room - mean)² / D,
///     b = (sum J (p_room - mean) + lambda / 2) / D,  D = integral (p_room - mean)² dW + lambda.
///
/// lambda = 4 s² W is what is known of b beforehand, 1/2 ± 1/2: a pressure that goes with its room's
/// has 1, one that stays has 0. (Linear regression with a prior; docs/theory/walls.md.)
WallSamples::Known WallSamples::Memory::at(double room_pressure) const {
    if (!(push2 > 0.0)) return {0.0, 0.0};
    const double mean = this->room_pressure(),
                 chance = 0.5 * push2 / exposure;  // of a unit of exposure
    const double prior = chance / (SLOPE_ERROR * SLOPE_ERROR);
    const double weight = std::max(0.0, room2 - mean * room) + prior;
    if (!(weight > 0.0)) return {pressure(), variance()};  // hits so long ago that they underflow
    const double b = (push_room - mean * push + SLOPE * prior) / weight;
    const double beyond = room_pressure - mean;
    return {pressure() + b * beyond, variance() + chance / weight * beyond * beyond};
}

/// What is remembered fades with exp(-dt / memory).
void WallSamples::remember(Sample& s, double dt, const Inside& room) {
    s.now.exposure = s.area * dt;
    const double of_room = room.pressure - room.air_pressure;
    s.now.room = of_room * s.now.exposure;
    s.now.room2 = of_room * s.now.room;
    s.now.push_room = of_room * s.now.push;
    const double rate =
        s.area > 0.0 ? (s.quick.count + s.now.count) / (s.quick.exposure + s.now.exposure) * s.area
                     : 0.0;
    const double memory = std::max(STEPS * dt, rate * longest_ > HITS ? HITS / rate : longest_);
    s.quick.renew(std::exp(-dt / memory), s.now);
    s.steady.renew(std::exp(-dt / (STEADIER * longest_)), s.now);
    s.now.clear();
    if (!(s.quick.exposure > 0.0)) return;
    const Known expected = s.steady.at(s.quick.room_pressure());
    const double apart = s.quick.pressure() - expected.pressure;
    if (apart * apart > CHANGED * CHANGED * (s.quick.variance() + expected.variance))
        s.steady = s.quick;
}

/// Variance between a room's patches, by area, less that of chance.
void WallSamples::find_spread(std::span<const Inside> rooms) {
    struct Sums {
        double weight = 0, weight2 = 0, square = 0, noise = 0, hits = 0;
        void add(double w, double count, double d, double variance) {
            weight += w;
            weight2 += w * w;
            square += w * d * d;
            noise += w * variance;
            hits += count;
        }
        [[nodiscard]] double beyond_chance() const {
            if (!(weight > 0.0)) return 0.0;
            const double all = square / weight;  // about the room's own mean: no degree is lost
            const double chance = noise / weight;
            const double patches = weight * weight / weight2;
            const double scatter = std::sqrt(2.0 / patches + 1.0 / std::max(1.0, hits));
            return std::max(0.0, all - chance * (1.0 + CHANCE * scatter));
        }
    };
    std::vector<Sums> p(rooms.size()), T(rooms.size());
    std::vector<double> wall(rooms.size());
    for (std::size_t k = 0; k < patches_.size(); ++k) wall[samples_[k].room] += samples_[k].area;
    for (std::size_t r = 0; r < rooms.size(); ++r) {
        const Inside& room = rooms[r];
        spread_[r].common =
            common_bias(samples_, patches_.size(), static_cast<Index>(r), room.temperature);
        // air that is no particles does not fluctuate, nor does it share in what they do
        const double C = room.heat_capacity * (1.0 - room.air_pressure / room.pressure);
        spread_[r].fluctuation = C > 0.0 ? room.temperature * room.temperature * gas_constant_ *
                                               moles_each_ / C * wall[r]
                                         : 0.0;
    }
    for (std::size_t k = 0; k < patches_.size(); ++k) {
        const Sample& sample = samples_[k];
        const Memory& s = sample.quick;
        if (!sample.tells || !(s.exposure > 0.0) || !(sample.area > 0.0)) continue;
        const Inside& room = rooms[sample.room];
        p[sample.room].add(sample.area, s.count, s.difference(), s.variance());
        if (s.slope > 0.0 && room.temperature > 0.0)
            T[sample.room].add(s.count, s.count, s.energy / s.slope - spread_[sample.room].common,
                               spread_[sample.room].chance(s, sample.area));
    }
    for (std::size_t r = 0; r < rooms.size(); ++r) {
        spread_[r].pressure = p[r].beyond_chance();
        spread_[r].temperature = T[r].beyond_chance();
    }
}

/// Temperature of hits on it: of the room, and what the sample tells beyond that.           [K]
double WallSamples::temperature(std::size_t sample, const Inside& room, double weight) const {
    if (!(weight > 0.0)) return room.temperature;
    const Memory& q = samples_[sample].quick;
    const double here = q.energy / q.slope - spread_[samples_[sample].room].common;
    return std::max(0.0, room.temperature + weight * here);
}

/// Mixture: hits of a gas come as n / sqrt(M).
/// @param own        weight of the sample's own hits                                   [-]
/// @param pressure   that particles bring                                             [Pa]
void WallSamples::mix(const Memory& q, const Inside& room, double own, double pressure, double T,
                      Inside& out) const {
    const std::size_t kinds = species_.size();
    double moles = 0.0, moles_of_room = 0.0;
    std::vector<double> share(kinds);
    for (std::size_t k = 0; k < kinds; ++k) {
        share[k] = q.of[k] * std::sqrt(species_[k].molar_mass());
        moles += share[k];
        moles_of_room += room.density[k] / species_[k].molar_mass();
    }
    if (!(moles > 0.0)) own = 0.0;
    double M = 0.0, cp = 0.0;
    const double all = (pressure + room.air_pressure) / (gas_constant_ * T);
    const double of_particles = pressure / (gas_constant_ * T);
    for (std::size_t k = 0; k < kinds; ++k) {
        const double by_room =
            moles_of_room > 0.0 ? room.density[k] / species_[k].molar_mass() / moles_of_room : 0.0;
        const double x = own > 0.0 ? own * share[k] / moles + (1.0 - own) * by_room : by_room;
        const double molar = species_[k].molar_mass();
        out.density[k] = x * of_particles * molar;
        M += x * of_particles * molar;
        cp += x * of_particles * molar * species_[k].cp(T);
    }
    out.gamma = room.gamma;
    if (room.air_pressure > 0.0) {
        M += room.air_density;  // its heat capacity stays within the room's mean
    } else if (of_particles > 0.0) {
        out.gamma = cp / (cp - of_particles * gas_constant_);
    }
    out.molar_mass = M / std::max(all, of_particles);
}

/// The state that gas in motion along the wall comes to at rest, as far as the state is that of its hits: the room's is at
/// rest already. U² is known to ± sqrt(2 scatter) U, and so is the pressure that it adds: without that error gas at the
/// pressure outside would leave whenever chance stirs it.
/// @param own  weights of the sample's own pressure and temperature                          [-]
void WallSamples::stagnate(const Memory& q, const Own& own, double& pressure, double& T,
                           Inside& out) const {
    // U² without what chance makes of it; where that is not beyond chance, none.
    const double scatter = 0.5 * q.square / (q.mass * q.mass);
    const double square = q.momentum.squaredNorm() / (q.mass * q.mass), drift = square - scatter;
    if (!(square > CHANCE * CHANCE * scatter)) return;
    // T holds U²/2 as heat at constant volume; at constant pressure it is less warm. A hole
    // draws no gas faster than sound, U² = gamma R still.
    const double gamma = out.gamma, R = gas_constant_ / out.molar_mass;
    const double sonic = gamma * R * T / (1.0 + 0.5 * gamma * (gamma - 1.0));
    const double drawn = std::min(drift, sonic);
    const double still = T - 0.5 * drawn * (gamma - 1.0) / R;
    const double stagnation = still + 0.5 * drawn * (gamma - 1.0) / (gamma * R);
    const double more =
        own.pressure * pressure * (std::pow(stagnation / still, gamma / (gamma - 1.0)) - 1.0);
    out.error = std::hypot(out.error, std::sqrt(2.0 * scatter * square) / drift * more);
    pressure += more;
    T += own.temperature * (stagnation - T);
}

/// Gas that flows to a hole of size L with j / rho is strained before the wall beside it by about j / (rho L), and
/// presses there with p_nn > p, p_nn - p going with viscosity times strain. The viscosity of LIN goes with rho sigma
/// and the particles' distance n^(-1/3):
///
///     p_hits / p - 1 = STRAIN j / (rho sigma) / (n^(1/3) L),       sigma = sqrt(R T).
///
/// @return p_hits / p - 1                                                                [-]
double WallSamples::excess(const Inside& room, const Drawn& drawn) const {
    if (!(drawn.flux > 0.0)) return 0.0;
    double density = 0.0, number = 0.0;  // of particles                     [kg/m³], [1/m³]
    for (std::size_t k = 0; k < species_.size(); ++k) {
        density += room.density[k];
        number += room.density[k] / particle_mass_[k];
    }
    if (!(number > 0.0)) return 0.0;
    const double sigma = std::sqrt(gas_constant_ / room.molar_mass * room.temperature);
    return STRAIN * drawn.flux / (density * sigma) / (std::cbrt(number) * drawn.size);
}

void WallSamples::state(std::size_t sample, const Inside& room, const Drawn& drawn,
                        Inside& out) const {
    out = room;
    if (!(samples_[sample].steady.exposure > 0.0) || !room.holds_gas()) return;
    const Spread& spread = spread_[samples_[sample].room];
    const double of_room = room.pressure - room.air_pressure;
    const Known hits = samples_[sample].at(of_room);
    const double here = hits.pressure / (1.0 + excess(room, drawn));
    const double weight =
        spread.pressure > 0.0 ? spread.pressure / (spread.pressure + hits.variance) : 0.0;
    double pressure = std::max(0.0, of_room + weight * (here - of_room));
    out.error = std::hypot(room.error, std::sqrt(weight * hits.variance));

    // temperatures even out sooner than the steady one fades
    const Memory& q = samples_[sample].quick;
    const double area = samples_[sample].area;
    double heat_weight = 0.0;
    if (spread.temperature > 0.0 && q.slope > 0.0 && area > 0.0)
        heat_weight = spread.temperature / (spread.temperature + spread.chance(q, area));
    // Carried energy holds the energy of motion along the wall, too.
    double T = temperature(sample, room, heat_weight);
    if (!(T > 0.0) || !(pressure > 0.0)) {
        out.pressure = room.air_pressure;
        out.density.assign(out.density.size(), 0.0);
        return;
    }
    const bool has_hits = std::any_of(q.of.begin(), q.of.end(), [](double n) { return n > 0.0; });
    const double own = has_hits ? std::max(weight, heat_weight) : 0.0;
    mix(q, room, own, pressure, T, out);
    if (own > 0.0 && q.mass > 0.0 && out.gamma > 1.0)
        stagnate(q, {weight, heat_weight}, pressure, T, out);
    out.pressure = pressure + room.air_pressure;
    out.temperature = T;
}

}  // namespace corpuscle::gas
