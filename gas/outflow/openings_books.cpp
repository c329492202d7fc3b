// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Who passed through the openings of a bag, and what that cost.

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

#include "gas/outflow/openings.hpp"

namespace corpuscle::gas {

const Openings::Passed& Openings::count(const FlightResult& flight, double dt, const Inside& inside,
                                        std::span<const std::int32_t> species) {
    passed_.energy = passed_.still_owed = 0.0;
    passed_.rows.clear();
    std::fill(came_.begin(), came_.end(), 0.0);
    std::fill(came_to_collar_.begin(), came_to_collar_.end(), 0.0);
    for (const auto& arrivals : flight.arrivals)
        for (const Arrival& arrival : arrivals) {
            const Index gate = arrival.passage.gate;
            Opening& opening = openings_[gate];
            const std::int32_t s = species[arrival.particle];
            const double mass = mass_[s];
            (arrival.passage.by_collar ? came_to_collar_ : came_)[gate] +=
                mass * weight_[s] * (arrival.passage.by_collar ? 1.0 : gates_.open[arrival.facet]);
            const bool is_out = arrival.passage.way == Gates::Way::OUT;
            if (opening.law == Opening::Law::SEEPAGE && !opening.is_internal)
                opening.due_of[s] +=
                    mass * (opening.share[s] * gates_.open[arrival.facet] - (is_out ? 1.0 : 0.0));
            if (!is_out) continue;
            opening.due -= mass;
            opening.mass_out += mass;
            // A collar's gas leaves through the vent's part.
            part_mass_out_[part_[arrival.passage.by_collar ? opening.facets[0] : arrival.facet]] +=
                mass;
            passed_.energy += arrival.energy;
            if (opening.law != Opening::Law::PLAIN)
                passed_.still_owed += mass * species_[s].h(inside.temperature) - arrival.energy;
            passed_.rows.push_back(arrival.particle);
        }
    particles_out_ += passed_.rows.size();

    for (std::size_t o = 0; o < openings_.size(); ++o) {
        Opening& opening = openings_[o];
        if (opening.law != Opening::Law::ISENTROPIC) {
            opening.due = 0.0;
            continue;
        }
        opening.due += opening.flow * dt;
        if (opening.memory <= 0.0) continue;
        const double fresh = -std::expm1(-dt / opening.memory);
        opening.arriving += fresh * (came_[o] / dt - opening.arriving);
        opening.collar_arriving += fresh * (came_to_collar_[o] / dt - opening.collar_arriving);
    }
    return passed_;
}

Openings::Air Openings::air_leaving(double dt) const {
    double flow = 0.0, heat = 0.0;
    for (const Opening& opening : openings_) {
        flow += opening.air_flow;
        heat += opening.air_flow * opening.air_heat;
    }
    return {flow * dt, flow > 0.0 ? heat / flow : 1.0};
}

double Openings::intake() const {
    double flow = 0.0;
    for (const Opening& opening : openings_) flow += opening.intake;
    return flow;
}

void Openings::book_air(double mass) {
    const double flow = air_leaving(1.0).mass;
    for (Opening& opening : openings_) {
        if (opening.air_flow <= 0.0) continue;
        const double own = mass * opening.air_flow / flow;
        opening.mass_out += own;
        part_mass_out_[part_[opening.facets[0]]] += own;
    }
}

void Openings::book(std::size_t row, double mass) {
    openings_[row].mass_out += mass;
    part_mass_out_[part_[openings_[row].facets[0]]] += mass;
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
    std::vector<std::string> found;
    for (const Opening& opening : openings_) {
        const double missing = opening.due + opening.short_of;
        const double grain = mass_.empty() ? 0.0 : *std::max_element(mass_.begin(), mass_.end());
        if (missing <= WORTH_A_WORD * opening.mass_out + PARTICLES * grain) continue;
        found.push_back(fmt::format(
            "{}: part {} let out {:.6g} of {:.6g}: too little gas came to it", name_,
            part_ids_[part_[opening.facets[0]]], opening.mass_out, opening.mass_out + missing));
    }
    return found;
}

}  // namespace corpuscle::gas
