// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Which particles enter, when, and how.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "gas/inflow/inflator.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {
namespace {

/// Particles that enter in a step and whose memory is kept for the next: a burst's is given back.
constexpr std::size_t MOST_KEPT = 10'000;

}  // namespace

std::int64_t Inflators::entered(std::size_t inflow) const {
    const auto row = given_.begin() + static_cast<std::ptrdiff_t>(inflow * cone_.size());
    return std::accumulate(row, row + static_cast<std::ptrdiff_t>(cone_.size()), std::int64_t{0});
}

void Inflators::restore(std::vector<std::int64_t> state) {
    assert(state.size() == given_.size());
    given_ = std::move(state);
}

/// When k + 1/2 particle masses are in; the last one may be rounded up and then ends the flow.
double Inflators::entry_time(std::size_t inflow, std::int64_t k) const {
    const FlowCurve& flow = gases_[inflow].flow;
    const double mass = moles_each_ * species_[inflow].molar_mass();
    return flow.time_of(std::min(flow.total(), (static_cast<double>(k) + 0.5) * mass));
}

/// The orifice of a gas's next particle: among those that are behind their share, the one that
/// would fall one particle behind first. Unit jobs by earliest deadline, so no orifice ever strays
/// from its share by a particle [Tijdeman 1980; Baruah et al. 1996].
std::int32_t Inflators::next_orifice(std::size_t inflow) const {
    const std::vector<double>& share = gases_[inflow].share;
    const std::int64_t* given = given_.data() + inflow * share.size();
    const auto k = static_cast<double>(entered(inflow));
    std::int32_t best = -1;
    double least = INF;
    for (std::size_t o = 0; o < share.size(); ++o) {
        if (!(share[o] > 0.0) || static_cast<double>(given[o]) >= share[o] * (k + 1.0)) continue;
        const double deadline = (static_cast<double>(given[o]) + 1.0) / share[o];
        if (deadline < least) {
            least = deadline;
            best = static_cast<std::int32_t>(o);
        }
    }
    assert(best >= 0 && "shares sum to 1, so someone is behind");
    return best;
}

void Inflators::entering(double t_1, std::span<const Vec3> axis, std::vector<Entry>& out) {
    assert(axis.size() == cone_.size());
    due_.clear();
    std::int64_t born = 0;
    for (std::size_t g = 0; g < gases_.size(); ++g) {
        const auto all = static_cast<std::int64_t>(gases_[g].particles);
        const std::int64_t before = entered(g);
        born += before;
        for (std::int64_t k = before; k < all; ++k) {
            const double time = entry_time(g, k);
            if (time > t_1) break;
            const std::int32_t orifice = next_orifice(g);
            ++given_[g * cone_.size() + static_cast<std::size_t>(orifice)];
            due_.push_back({time, static_cast<std::int32_t>(g), orifice});
        }
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& p, const Due& q) { return p.time < q.time; });
    constexpr std::size_t A_CHUNK = 16;  // each draws random numbers
    const std::size_t first = out.size();
    out.resize(first + due_.size());
    parallel::for_each(
        due_.size(),
        [&](std::size_t k) {
            out[first + k] = make(due_[k], axis[due_[k].orifice],
                                  static_cast<std::int32_t>(born + static_cast<std::int64_t>(k)));
        },
        A_CHUNK);
    due_.clear();
    if (due_.capacity() > MOST_KEPT) due_.shrink_to_fit();
}

Entry Inflators::make(const Due& due, const Vec3& axis, std::int32_t id) const {
    const Species& gas = species_[due.inflow];
    const double T = gas.stagnation_temperature(gases_[due.inflow].temperature(due.time));
    const double mass = moles_each_ * gas.molar_mass();
    const double speed = std::sqrt(3.0 * gas_constant_ * T / gas.molar_mass());
    return {due.time,
            speed * draw_direction(axis, cone_[due.orifice], id),
            mass * gas.internal(T),
            mass * gas.u(T),
            due.inflow,
            due.orifice,
            id};
}

Vec3 Inflators::jet(std::size_t inflow, std::size_t orifice, double t, const Vec3& axis) const {
    if (axis.isZero()) return Vec3::Zero();  // into every direction
    const Species& gas = species_[inflow];
    const double T = gas.stagnation_temperature(gases_[inflow].temperature(t));
    const double speed = std::sqrt(3.0 * gas_constant_ * T / gas.molar_mass());
    return 0.5 * (1.0 + std::cos(cone_[orifice])) * speed * axis.normalized();
}

Vec3 Inflators::draw_direction(const Vec3& axis, double cone, std::int32_t id) const {
    Random draw(seed_, Stream::INFLOW, 0, static_cast<std::uint64_t>(id));
    const double length = axis.norm();
    if (length == 0.0) return draw.direction();

    const Vec3 along = axis / length;
    const Vec3 aside = along.unitOrthogonal();
    const double cosine = 1.0 - draw.uniform() * (1.0 - std::cos(cone));
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));  // rounding at the axis
    const double phi = 2.0 * std::numbers::pi * draw.uniform();
    const Vec3 direction =
        cosine * along + sine * (std::cos(phi) * aside + std::sin(phi) * along.cross(aside));
    return direction.normalized();
}

}  // namespace corpuscle::gas
