// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/outflow/wall_samples.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {
namespace {

/// Patches that a room's wall is cut into, were it of one part.
constexpr double PATCHES = 32.0;

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
    std::sort(sample.sides.begin(), sample.sides.end());
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
    patches_of_.clear();
    return static_cast<Index>(samples_.size()) - 1;
}

/// Patches that each sample has sides of.
void WallSamples::list_patches(const SidePatches& patches) {
    patches_of_.resize(samples_.size());
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        std::vector<Index>& some = patches_of_[k];
        for (const Index s : samples_[k].sides)
            some.push_back(patches.of(static_cast<std::size_t>(s)));
        std::sort(some.begin(), some.end());
        some.erase(std::unique(some.begin(), some.end()), some.end());
    }
}

void WallSamples::receive(const WallHits& hits, double dt, std::span<const Vec3> x_0,
                          std::span<const Vec3> x_1, std::span<const Inside> rooms,
                          const Particles& particles) {
    if (empty()) return;
    if (patches_of_.empty()) list_patches(hits.patches());
    measure(x_1);
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
    const auto wall = [&](const Hit& hit) {
        Vec3 way = Vec3::Zero();
        for (int c = 0; c < 3; ++c) {
            const Index n = surface_->triangles()[hit.facet][c];
            way += hit.at[c] * (x_1[n] - x_0[n]);
        }
        return Vec3(way / dt);
    };
    const auto take = [&](std::size_t k) {
        Sample& sample = samples_[k];
        for (const Index patch : patches_of_[k])
            for (const WallHits::Met& met : hits.of(static_cast<std::size_t>(patch)))
                if (std::binary_search(sample.sides.begin(), sample.sides.end(), met.side))
                    add(*met.hit, wall(*met.hit), particles, sample);
        remember(sample, dt, rooms[sample.room]);
    };
    parallel::for_each(samples_.size(), take, 1);
    find_spread(rooms);
}

/// Adds a hit to what a sample has got in this flight.
/// @param wall  velocity of the wall there                                              [m/s]
void WallSamples::add(const Hit& hit, const Vec3& wall, const Particles& particles,
                      Sample& sample) const {
    const std::size_t row = hit.row();
    const std::int32_t kind = particles.species[row];
    const std::size_t of =
        static_cast<std::size_t>(sample.room) * species_.size() + static_cast<std::size_t>(kind);
    const double m = particle_mass_[kind];
    const double push = hit.impulse.norm();
    const Vec3 n = push > 0.0 ? Vec3(hit.impulse / push) : Vec3(Vec3::Zero());
    // (What has left stands with the velocity that it came with.)
    const Vec3 v = particles.v[row] - wall;
    const double carried = 0.5 * m * v.squaredNorm() + particles.e[row] - expected_[of];
    Memory& now = sample.now;
    now.push += push;
    now.push2 += push * push;
    now.energy += carried;
    now.energy2 += carried * carried;
    now.slope += slope_[of];
    now.count += 1.0;
    now.of[kind] += 1.0;
    if (!sample.drifts) return;
    const Vec3 along = m * (v - v.dot(n) * n);
    now.mass += m;
    now.momentum += along;
    now.square += along.squaredNorm();
}

/// What the steady memory tells, and the quick one's difference d from it as far as that is beyond
/// chance: d (1 - (e / d)²), e its error.
WallSamples::Known WallSamples::Sample::at(double room_pressure) const {
    const Known known = steady.at(room_pressure), before = steady.at(quick.room_pressure());
    const double d = quick.pressure() - before.pressure, e2 = quick.variance() + before.variance;
    if (!(d * d > e2)) return known;
    const double share = 1.0 - e2 / (d * d), kept = 1.0 - share;
    return {known.pressure + share * d,
            kept * kept * known.variance + share * share * quick.variance()};
}

void WallSamples::measure(std::span<const Vec3> x) {
    constexpr std::size_t A_CHUNK = 2;  // samples, of some ten facets each
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

}  // namespace corpuscle::gas
