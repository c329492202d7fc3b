// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/resident_air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

#include "gas/enclosure/inside.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {
namespace {

/// Places that are tried for one particle: enough for a bag that fills a hundredth of its box.
constexpr int MOST_TRIALS = 5000;

/// A place inside, drawn evenly; false when none is found.
bool draw_place(const InsideTest& inside, Random& draw, Vec3& place) {
    for (int trial = 0; trial < MOST_TRIALS; ++trial) {
        for (int k = 0; k < 3; ++k)
            place[k] = inside.low()[k] + draw.uniform() * (inside.high()[k] - inside.low()[k]);
        if (const auto winding = inside.winding(place); winding && *winding > 0) return true;
    }
    return false;
}

/// First particle of each room, and after the last their count: each room has its share by volume,
/// rounded up or down by chance.
std::vector<std::size_t> firsts_of_rooms(std::size_t count, std::span<const double> volume,
                                         std::uint64_t seed) {
    double all = 0.0, before = 0.0;
    for (const double of_room : volume) all += std::max(0.0, of_room);
    const double chance = Random(seed, Stream::INITIAL, 1, 0).uniform();
    std::vector<std::size_t> first{0};
    for (const double of_room : volume) {
        before += std::max(0.0, of_room);
        const double until = std::floor(static_cast<double>(count) * before / all + chance);
        first.push_back(std::min(count, static_cast<std::size_t>(until)));
    }
    first.back() = count;
    return first;
}

/// Takes the mean motion from particles of one room and gives them their exact energy.
/// @param spread  of one component of their velocity                                  [m/s]
void set_to_rest(std::span<Vec3> v, double spread) {
    const auto n = static_cast<double>(v.size());
    if (v.empty()) return;
    const Vec3 mean =
        parallel::sum(v.size(), Vec3(Vec3::Zero()), [&](std::size_t i) { return v[i]; }) / n;
    const double square =
        parallel::sum(v.size(), 0.0, [&](std::size_t i) { return (v[i] - mean).squaredNorm(); });
    // A lone particle has no thermal motion beside its mean: it keeps its own.
    const double factor = square > 0.0 ? std::sqrt(3.0 * n * spread * spread / square) : 1.0;
    const Vec3 drift = square > 0.0 ? mean : Vec3(Vec3::Zero());
    for (Vec3& of_one : v) of_one = factor * (of_one - drift);
}

}  // namespace

void add_resident_air(const ResidentAir& air, const Species& gas, const Enclosure& bag,
                      const WettedSurface& surface, std::span<const Vec3> x, std::uint64_t seed,
                      const std::string& name, Particles& particles) {
    if (air.count == 0) return;
    const InsideTest inside(bag.triangles(), x);
    const double spread = std::sqrt(gas.gas_constant() * air.temperature / gas.molar_mass());
    const std::size_t first = particles.size(), rooms = surface.rooms();
    for (std::size_t i = 0; i < air.count; ++i)
        particles.add(Vec3::Zero(), Vec3::Zero(), air.mass * gas.internal(air.temperature),
                      air.species, air.first_id + static_cast<std::int32_t>(i));

    std::vector<double> volume;
    surface.volumes(x, volume);
    const std::vector<std::size_t> first_of = firsts_of_rooms(air.count, volume, seed);
    std::atomic<std::size_t> homeless = 0;
    for (std::size_t r = 0; r < rooms; ++r) {
        std::optional<InsideTest> in_room;
        if (rooms > 1) in_room.emplace(surface.wall(r), x);
        const std::size_t begin = first_of[r], count = first_of[r + 1] - begin;
        parallel::for_each(count, [&](std::size_t k) {
            const std::size_t i = begin + k;
            const auto id = static_cast<std::uint64_t>(air.first_id) + i;
            Random draw(seed, Stream::INITIAL, 0, id);
            // A room too slender for its own box leaves a particle to the others.
            const bool has_place =
                (in_room && draw_place(*in_room, draw, particles.x[first + i])) ||
                draw_place(inside, draw, particles.x[first + i]);
            homeless += !has_place;
            for (int c = 0; c < 3; ++c) particles.v[first + i][c] = spread * draw.normal();
        });
        set_to_rest(std::span(particles.v).subspan(first + begin, count), spread);
    }
    if (homeless > 0)
        throw InputError(Fault{
            .of = name,
            .property = Property::INITIAL_AIR,
            .why = fmt::format("no place for {} of {} particles: the bag fills too little of its "
                               "own box; air at uniform pressure needs no places",
                               homeless.load(), air.count)});
}

}  // namespace corpuscle::gas
