// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Who passed through the openings of a bag, and what that cost.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "solver/base/error.hpp"

#include "gas/outflow/openings.hpp"

namespace corpuscle::gas {
namespace {

/// Particles that an opening may be short of before what it lacks counts as a shortage.
constexpr double GRAINS = 3.0;

}  // namespace

const Openings::Passed& Openings::count(const FlightResult& flight, double dt,
                                        std::span<const Inside> inside,
                                        std::span<const Inside> rooms,
                                        std::span<const std::int32_t> species) {
    passed_.energy = 0.0;
    std::fill(passed_.still_owed.begin(), passed_.still_owed.end(), 0.0);
    passed_.rows.clear();
    std::fill(came_.begin(), came_.end(), 0.0);
    std::fill(came_to_collar_.begin(), came_to_collar_.end(), 0.0);
    for (const auto& arrivals : flight.arrivals)
        for (const Arrival& arrival : arrivals) {
            const Index row = arrival.outcome.opening;
            Opening& opening = openings_[row];
            const std::int32_t s = species[arrival.particle];
            const double mass = mass_[s];
            (arrival.outcome.by_collar ? came_to_collar_ : came_)[row] +=
                mass * weight_[s] *
                (arrival.outcome.by_collar ? 1.0 : transmission_.open[arrival.facet]);
            const bool is_out = arrival.outcome.fate == Transmission::Fate::OUT;
            if (opening.law == Opening::Law::SEEPAGE) {
                Opening::Seepage& side = opening.seepage[arrival.outcome.from_front ? 1 : 0];
                if (side.flow[s] > 0.0 && arrival.outcome.fate != Transmission::Fate::BACK)
                    side.due[s] -= mass;
            }
            if (arrival.outcome.fate == Transmission::Fate::THROUGH)
                count_through(arrival, rooms, s);
            if (!is_out) continue;
            opening.due -= mass;
            opening.mass_out += mass;
            if (arrival.outcome.by_collar)
                book_by_part(opening, mass);  // a collar's gas leaves through the vent's parts
            else
                part_mass_out_[part_[arrival.facet]] += mass;
            passed_.energy += arrival.energy;
            if (opening.law != Opening::Law::PLAIN)
                passed_.still_owed[row] += mass * species_[s].h(inside[row].temperature) -
                                           (arrival.energy - arrival.riding);
            passed_.rows.push_back(arrival.particle);
        }
    particles_out_ += passed_.rows.size();

    for (std::size_t o = 0; o < openings_.size(); ++o) {
        Opening& opening = openings_[o];
        if (opening.law != Opening::Law::ISENTROPIC) {
            opening.due = 0.0;
            fall_due(opening, dt);
            continue;
        }
        opening.due += opening.flow * dt;
        if (opening.memory <= 0.0) continue;
        // What could not pass for want of arrivals is not let out later.
        const double most = opening.flow * opening.memory + GRAINS * heaviest_;
        if (opening.due > most) {
            opening.short_of += opening.due - most;
            opening.due = most;
        }
        const double fresh = -std::expm1(-dt / opening.memory);
        opening.arriving += fresh * (came_[o] / dt - opening.arriving);
        opening.collar.arriving += fresh * (came_to_collar_[o] / dt - opening.collar.arriving);
    }
    return passed_;
}

/// What seepage wants of the particles in a step; for want of arrivals no more is owed than they
/// make good in the memory.
void Openings::fall_due(Opening& opening, double dt) {
    for (Opening::Seepage& side : opening.seepage)
        for (std::size_t s = 0; s < side.flow.size(); ++s) {
            if (!(side.flow[s] > 0.0)) continue;
            side.due[s] += side.flow[s] * dt;
            opening.short_of += std::max(0.0, side.due[s] - side.most[s]);
            side.due[s] = std::min(side.due[s], side.most[s]);
        }
}

void Openings::keep_to_balance(double dt, std::span<const double> volume) {
    // Holes that let gas out against the pressure outside carry less than the enthalpy.
    const auto is_driven = [](const Opening& opening) { return opening.air_heat == 1.0; };
    for (std::size_t room = 0; room < volume.size(); ++room) {
        const auto [excess, lack] = std::exchange(imbalance_[room], {});
        double out = 0.0, in = 0.0;  // [kg]
        for (const Opening& opening : openings_) {
            if (opening.room != static_cast<Index>(room)) continue;
            if (is_driven(opening)) out += dt * (opening.flow + opening.air_flow);
            in += dt * opening.intake;
        }
        const double room_for = std::max(0.0, volume[room]);
        const double most_out = excess * room_for, most_in = lack * room_for;
        for (Opening& opening : openings_) {
            if (opening.room != static_cast<Index>(room)) continue;
            if (out > most_out && is_driven(opening)) opening.air_flow *= most_out / out;
            if (in > most_in) opening.intake *= most_in / in;
        }
    }
}

Openings::Air Openings::air_leaving(std::size_t room, double dt) const {
    double flow = 0.0, heat = 0.0;
    for (const Opening& opening : openings_) {
        if (opening.room != static_cast<Index>(room)) continue;
        flow += opening.air_flow;
        heat += opening.air_flow * opening.air_heat;
    }
    return {flow * dt, flow > 0.0 ? heat / flow : 1.0};
}

double Openings::intake(std::size_t room) const {
    double flow = 0.0;
    for (const Opening& opening : openings_)
        if (opening.room == static_cast<Index>(room)) flow += opening.intake;
    return flow;
}

void Openings::book_air(std::size_t room, double mass) {
    const double flow = air_leaving(room, 1.0).mass;
    for (std::size_t o = 0; o < openings_.size(); ++o)
        if (openings_[o].room == static_cast<Index>(room) && openings_[o].air_flow > 0.0)
            book(o, mass * openings_[o].air_flow / flow);
}

void Openings::book(std::size_t row, double mass) {
    openings_[row].mass_out += mass;
    book_by_part(openings_[row], mass);
}

void Openings::book_by_part(const Opening& opening, double mass) {
    const double free = opening.free * opening.area;
    if (opening.parts.size() == 1 || !(free > 0.0)) {
        part_mass_out_[opening.parts[0].part] += mass;
        return;
    }
    for (const Opening::OfPart& own : opening.parts)
        part_mass_out_[own.part] += mass * own.area / free;
}

double Openings::mass_out(bool through_vents) const {
    double mass = 0.0;
    for (const Opening& opening : openings_)
        if ((opening.vent >= 0) == through_vents) mass += opening.mass_out;
    return mass;
}

std::vector<std::string> Openings::shortages() const {
    constexpr double WORTH_A_WORD = 0.01;  // of what has left
    constexpr double PARTICLES = 10.0;     // too few to speak of
    struct Sum {
        double out = 0.0, missing = 0.0;
    };
    std::map<Index, Sum> parts;
    for (const Opening& opening : openings_) {
        Sum& sum = parts[part_[opening.facets[0]]];
        sum.out += opening.mass_out;
        sum.missing += std::max(0.0, opening.due) + opening.short_of;
    }
    std::vector<std::string> found;
    for (const auto& [part, sum] : parts)
        if (sum.missing > WORTH_A_WORD * sum.out + PARTICLES * heaviest_)
            found.push_back(
                fmt::format("{}: part {} let out {:.6g} of {:.6g}: too little gas came to it",
                            name_, part_ids_[part], sum.out, sum.out + sum.missing));
    return found;
}

}  // namespace corpuscle::gas
