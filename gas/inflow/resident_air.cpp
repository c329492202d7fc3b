// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/resident_air.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>

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

}  // namespace

void add_resident_air(const ResidentAir& air, const Species& gas, const Enclosure& bag,
                      std::span<const Vec3> x, std::uint64_t seed, const std::string& name,
                      Particles& particles) {
    if (air.count == 0) return;
    const InsideTest inside(bag.triangles(), x);
    const double spread = std::sqrt(gas.gas_constant() * air.temperature / gas.molar_mass());
    const std::size_t first = particles.size();
    for (std::size_t i = 0; i < air.count; ++i)
        particles.add(Vec3::Zero(), Vec3::Zero(), air.mass * gas.internal(air.temperature),
                      air.species, air.first_id + static_cast<std::int32_t>(i));

    std::atomic<std::size_t> homeless = 0;
    parallel::for_each(air.count, [&](std::size_t i) {
        const auto id = static_cast<std::uint64_t>(air.first_id) + i;
        Random draw(seed, Stream::INITIAL, 0, id);
        homeless += !draw_place(inside, draw, particles.x[first + i]);
        for (int k = 0; k < 3; ++k) particles.v[first + i][k] = spread * draw.normal();
    });
    if (homeless > 0)
        throw InputError(Fault{
            .of = name,
            .property = Property::INITIAL_AIR,
            .why = fmt::format("no place for {} of {} particles: the bag fills too little of its "
                               "own box; air at uniform pressure needs no places",
                               homeless.load(), air.count)});

    const auto n = static_cast<double>(air.count);
    const Vec3 mean = parallel::sum(air.count, Vec3(Vec3::Zero()),
                                    [&](std::size_t i) { return particles.v[first + i]; }) /
                      n;
    const double square = parallel::sum(air.count, 0.0, [&](std::size_t i) {
        return (particles.v[first + i] - mean).squaredNorm();
    });
    // A lone particle has no thermal motion beside its mean: it keeps its own.
    const double factor = square > 0.0 ? std::sqrt(3.0 * n * spread * spread / square) : 1.0;
    const Vec3 drift = square > 0.0 ? mean : Vec3(Vec3::Zero());
    for (std::size_t i = first; i < particles.size(); ++i)
        particles.v[i] = factor * (particles.v[i] - drift);
}

}  // namespace corpuscle::gas
