// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/outflow/wall_samples.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {
namespace {

/// Patches that a room's wall is cut into, were it of one part.
constexpr double PATCHES = 32.0;

/// Hits that a sample remembers. More: steadier, and later to know.
constexpr double HITS = 1000.0;

/// Steps that it remembers at least.
constexpr double STEPS = 4.0;

/// The steady memory, in times of the longest of the quick one.
constexpr double STEADIER = 15.0;

/// Standard deviations between the two memories from which the state has changed.
constexpr double CHANGED = 3.5;

/// Standard deviations of the variance between patches that chance is allowed.
constexpr double CHANCE = 2.0;

/// Share of T up to which what all hits of a room have in common is the model's doing: in a group
/// motion and internal energy fluctuate against each other, so that those that hit, the faster
/// ones, carry some 0.3 % less than gas of the room's T does. As much as chance makes comes on top.
constexpr double MODEL_BIAS = 0.01;

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

WallSamples::WallSamples(std::shared_ptr<const WettedSurface> surface, const BagWalls& walls,
                         std::span<const Species> species, std::span<const double> particle_mass,
                         double gas_constant, double longest, std::span<const char> passes,
                         std::span<const Vec3> x)
    : surface_(std::move(surface)),
      species_(species.begin(), species.end()),
      particle_mass_(particle_mass.begin(), particle_mass.end()),
      gas_constant_(gas_constant),
      longest_(longest) {
    if (!species_.empty()) moles_each_ = particle_mass_[0] / species_[0].molar_mass();
    spread_.resize(surface_->rooms());
    cut_into_patches(walls, x);
    for (const auto& sides : patches_) {
        add(sides);
        for (const Index s : sides) samples_.back().tells &= passes[surface_->facet(s)] == 0;
    }
}

/// Patches grow from side to side over common points, within a part and a room, until they have
/// their share of the room's wall.
void WallSamples::cut_into_patches(const BagWalls& walls, std::span<const Vec3> x) {
    const WettedSurface& s = *surface_;
    std::vector<double> size(s.sides()), wall(s.rooms(), 0.0);
    for (std::size_t i = 0; i < s.sides(); ++i) {
        const auto& [a, b, c] = s.triangles()[s.facet(i)];
        size[i] = vector_area(x[a], x[b], x[c]).norm();
        wall[s.room(i)] += size[i];
    }
    const auto part = [&](Index side) { return walls.part[s.facet(side)]; };
    // The triangles of one shell follow each other, and stay together.
    const auto of_shell = [&](Index side, auto&& visit) {
        const auto facet = static_cast<std::size_t>(s.facet(side));
        for (const std::size_t other : {facet - 1, facet + 1})
            if (other < walls.shell.size() && walls.shell[other] == walls.shell[facet] &&
                s.closes(other) == s.closes(facet))
                visit(
                    static_cast<Index>(s.side(other, s.is_front(static_cast<std::size_t>(side)))));
    };
    std::vector<char> taken(s.sides(), 0);
    for (std::size_t seed = 0; seed < s.sides(); ++seed) {
        if (taken[seed]) continue;
        std::vector<Index> patch;
        double area = 0.0;
        const auto take = [&](Index side) {
            if (taken[side]) return;
            taken[side] = 1;
            area += size[side];
            patch.push_back(side);
        };
        take(static_cast<Index>(seed));
        of_shell(static_cast<Index>(seed), take);
        const double wanted = wall[s.room(seed)] / PATCHES;
        for (std::size_t i = 0; i < patch.size() && area < wanted; ++i)
            for (const Index p : s.points(patch[i]))
                for (const Index next : s.around(p)) {
                    if (taken[next] || part(next) != part(static_cast<Index>(seed)) ||
                        area >= wanted)
                        continue;
                    take(next);
                    of_shell(next, take);
                }
        std::sort(patch.begin(), patch.end());
        patches_.push_back(std::move(patch));
    }
}

Index WallSamples::add(std::vector<Index> sides, bool drifts) {
    Sample sample;
    sample.sides = std::move(sides);
    sample.drifts = drifts;
    sample.room = surface_->room(sample.sides[0]);
    for (Memory* memory : {&sample.now, &sample.quick, &sample.steady})
        memory->of.assign(species_.size(), 0.0);
    for (const Index s : sample.sides)
        for (const Index p : surface_->points(s)) sample.points.push_back(p);
    std::sort(sample.points.begin(), sample.points.end());
    sample.points.erase(std::unique(sample.points.begin(), sample.points.end()),
                        sample.points.end());
    samples_.push_back(std::move(sample));
    start_.clear();
    return static_cast<Index>(samples_.size()) - 1;
}

void WallSamples::list_sides() {
    start_.assign(surface_->sides() + 1, 0);
    for (const Sample& sample : samples_)
        for (const Index s : sample.sides) ++start_[s + 1];
    for (std::size_t s = 0; s < surface_->sides(); ++s) start_[s + 1] += start_[s];
    at_side_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<Index> fill(start_.begin(), start_.end() - 1);
    for (std::size_t k = 0; k < samples_.size(); ++k)
        for (const Index s : samples_[k].sides) at_side_[fill[s]++] = static_cast<Index>(k);
}

void WallSamples::receive(const FlightResult& flight, std::span<const Index> sides, double dt,
                          std::span<const Vec3> x, std::span<const Inside> rooms,
                          const Particles& particles) {
    if (empty()) return;
    if (start_.empty()) list_sides();
    measure(x);
    const std::size_t kinds = species_.size();
    expected_.resize(rooms.size() * kinds);
    slope_.resize(rooms.size() * kinds);
    for (std::size_t r = 0; r < rooms.size(); ++r)
        for (std::size_t s = 0; s < kinds; ++s) {
            // A hit carries u(T) and, being the more likely the faster it is, R T / 2 more.
            const double T = rooms[r].temperature;
            expected_[r * kinds + s] =
                T > 0.0 ? moles_each_ * (species_[s].molar_energy()(T) + 0.5 * gas_constant_ * T)
                        : 0.0;
            slope_[r * kinds + s] =
                moles_each_ * (T > 0.0 ? species_[s].molar_energy().slope(T) + 0.5 * gas_constant_
                                       : 2.0 * gas_constant_);
        }
    std::size_t i = 0;
    for (const auto& hits : flight.hits)
        for (const Hit& hit : hits) {
            const auto side = static_cast<std::size_t>(sides[i++]);
            const std::size_t row = hit.row();
            const std::int32_t kind = particles.species[row];
            const std::size_t of = static_cast<std::size_t>(surface_->room(side)) * kinds +
                                   static_cast<std::size_t>(kind);
            const double m = particle_mass_[kind];
            const double push = hit.impulse.norm();
            const Vec3 n = push > 0.0 ? Vec3(hit.impulse / push) : Vec3(Vec3::Zero());
            // (What has left stands with the velocity that it came with.)
            const Vec3 v = particles.v[row];
            const double carried = 0.5 * m * v.squaredNorm() + particles.e[row] - expected_[of];
            for (Index k = start_[side]; k < start_[side + 1]; ++k) {
                Sample& sample = samples_[at_side_[k]];
                Memory& now = sample.now;
                now.push += push;
                now.push2 += push * push;
                now.energy += carried;
                now.energy2 += carried * carried;
                now.slope += slope_[of];
                now.count += 1.0;
                now.of[kind] += 1.0;
                if (!sample.drifts) continue;
                const Vec3 along = m * (v - v.dot(n) * n);
                now.mass += m;
                now.momentum += along;
                now.square += along.squaredNorm();
            }
        }
    for (Sample& sample : samples_) remember(sample, dt, rooms[sample.room]);
    find_spread(rooms);
}

void WallSamples::measure(std::span<const Vec3> x) {
    constexpr std::size_t A_CHUNK = 8;  // samples, of some ten facets each
    parallel::for_each(
        samples_.size(),
        [&](std::size_t k) {
            Sample& sample = samples_[k];
            sample.area = 0.0;
            for (const Index s : sample.sides) {
                const auto& [a, b, c] = surface_->triangles()[surface_->facet(s)];
                sample.area += vector_area(x[a], x[b], x[c]).norm();
            }
        },
        A_CHUNK);
}

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
    add(excess, more.excess);
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

/// What is remembered fades with exp(-dt / memory).
void WallSamples::remember(Sample& s, double dt, const Inside& room) {
    s.now.exposure = s.area * dt;
    s.now.excess = s.now.push - (room.pressure - room.air_pressure) * s.area * dt;
    const double rate =
        s.area > 0.0 ? (s.quick.count + s.now.count) / (s.quick.exposure + s.now.exposure) * s.area
                     : 0.0;
    const double memory = std::max(STEPS * dt, rate * longest_ > HITS ? HITS / rate : longest_);
    s.quick.renew(std::exp(-dt / memory), s.now);
    s.steady.renew(std::exp(-dt / (STEADIER * longest_)), s.now);
    s.now.clear();
    if (!(s.quick.exposure > 0.0)) return;
    const double beside = s.quick.difference() - s.steady.difference(),
                 alone = s.quick.pressure() - s.steady.pressure();
    const double fresh = -std::expm1(-dt / longest_);
    s.off += fresh * (alone * alone - s.off);
    s.off_beside_room += fresh * (beside * beside - s.off_beside_room);
    const double apart = s.follows_room() ? beside : alone;
    if (apart * apart > CHANGED * CHANGED * (s.quick.variance() + s.steady.variance()))
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
    std::vector<double> common(rooms.size());
    for (std::size_t r = 0; r < rooms.size(); ++r)
        common[r] =
            common_bias(samples_, patches_.size(), static_cast<Index>(r), rooms[r].temperature);
    for (std::size_t k = 0; k < patches_.size(); ++k) {
        const Sample& sample = samples_[k];
        const Memory& s = sample.quick;
        if (!sample.tells || !(s.exposure > 0.0)) continue;
        p[sample.room].add(sample.area, s.count, s.difference(), s.variance());
        if (s.slope > 0.0 && rooms[sample.room].temperature > 0.0)
            T[sample.room].add(s.count, s.count, s.energy / s.slope - common[sample.room],
                               0.5 * s.energy2 / (s.slope * s.slope));
    }
    for (std::size_t r = 0; r < rooms.size(); ++r)
        spread_[r] = {p[r].beyond_chance(), T[r].beyond_chance()};
}

void WallSamples::state(std::size_t sample, const Inside& room, Inside& out) const {
    out = room;
    const Memory& s = samples_[sample].steady;
    if (!(s.exposure > 0.0) || !room.holds_gas()) return;
    const Spread& spread = spread_[samples_[sample].room];
    const double variance = s.variance();
    const Memory& q =
        samples_[sample].quick;  // temperatures even out sooner than the steady one fades
    const double weight =
        spread.pressure > 0.0 ? spread.pressure / (spread.pressure + variance) : 0.0;
    const double of_room = room.pressure - room.air_pressure;
    const double apart = samples_[sample].follows_room() ? s.difference() : s.pressure() - of_room;
    double pressure = of_room + weight * apart;
    pressure = std::max(0.0, pressure);
    out.error = std::hypot(room.error, std::sqrt(weight * variance));

    const double heat_variance = q.slope > 0.0 ? 0.5 * q.energy2 / (q.slope * q.slope) : 0.0;
    const double heat_weight = spread.temperature > 0.0 && q.slope > 0.0
                                   ? spread.temperature / (spread.temperature + heat_variance)
                                   : 0.0;
    double T = room.temperature;
    // Carried energy holds the energy of motion along the wall, too.
    if (heat_weight > 0.0) {
        const double common =
            common_bias(samples_, patches_.size(), samples_[sample].room, room.temperature);
        T = std::max(0.0, T + heat_weight * (q.energy / q.slope - common));
    }
    if (!(T > 0.0) || !(pressure > 0.0)) {
        out.pressure = room.air_pressure;
        out.density.assign(out.density.size(), 0.0);
        return;
    }

    // Mixture: hits of a gas come as n / sqrt(M).
    const std::size_t kinds = species_.size();
    double moles = 0.0, moles_of_room = 0.0;
    std::vector<double> share(kinds);
    for (std::size_t k = 0; k < kinds; ++k) {
        share[k] = q.of[k] * std::sqrt(species_[k].molar_mass());
        moles += share[k];
        moles_of_room += room.density[k] / species_[k].molar_mass();
    }
    const double own = moles > 0.0 ? std::max(weight, heat_weight) : 0.0;
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
    double gamma = room.gamma;
    if (room.air_pressure > 0.0) {
        M += room.air_density;  // its heat capacity stays within the room's mean
    } else if (of_particles > 0.0) {
        gamma = cp / (cp - of_particles * gas_constant_);
    }
    out.molar_mass = M / std::max(all, of_particles);
    out.gamma = gamma;

    if (own > 0.0 && q.mass > 0.0 && gamma > 1.0) {
        // U² without what chance makes of it; where that is not beyond chance, none.
        const double scatter = 0.5 * q.square / (q.mass * q.mass);
        const double square = q.momentum.squaredNorm() / (q.mass * q.mass),
                     drift = square - scatter;
        if (square > CHANCE * CHANCE * scatter) {
            // T holds U²/2 as heat at constant volume; at constant pressure it is less warm. A hole
            // draws no gas faster than sound, U² = gamma R still.
            const double R = gas_constant_ / out.molar_mass;
            const double sonic = gamma * R * T / (1.0 + 0.5 * gamma * (gamma - 1.0));
            const double drawn = std::min(drift, sonic);
            const double still = T - 0.5 * drawn * (gamma - 1.0) / R;
            const double stagnation = still + 0.5 * drawn * (gamma - 1.0) / (gamma * R);
            pressure *= std::pow(stagnation / still, gamma / (gamma - 1.0));
            T = stagnation;
        }
    }
    out.pressure = pressure + room.air_pressure;
    out.temperature = T;
}

}  // namespace corpuscle::gas
