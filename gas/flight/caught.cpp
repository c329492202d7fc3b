// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Particles that are caught between closing facets fly the step in parts.
//
// Within a step the swept facets are flat pieces in space and time (crossing.hpp), which may stray
// from the facets themselves by a quarter of what their nodes move against one another: where
// layers are closer than that, swept pieces can cut each other and shut a particle in. In parts
// they stray by 1/parts² of that, and at the step's ends nothing changes for others.

#include <algorithm>
#include <utility>

#include "gas/flight/bounce.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Facets that all caught particles together may meet in a step, but each as many as EACH. More:
/// more particles come free, while those that do not cost more time.
constexpr std::size_t TOGETHER = 400 * MOST_HITS, EACH = 20 * MOST_HITS;

/// Nodes at a share of the step.                                                     N × 3 [m]
void place_nodes(const FlightScene& scene, int part, int parts, Points& y) {
    const double tau = static_cast<double>(part) / parts;
    const auto nodes = scene.lists.nodes();
    parallel::for_each(nodes.size(), [&](std::size_t i) {
        const Index n = nodes[i];
        y[n] = part == 0       ? scene.x_0[n]
               : part == parts ? scene.x_1[n]
                               : Vec3(scene.x_0[n] + tau * (scene.x_1[n] - scene.x_0[n]));
    });
}

/// Puts a row back to where the step found it.
void begin_again(const Flyer& at_first, Flyer& who) {
    who.x = at_first.x;
    who.v = at_first.v;
    who.internal = at_first.internal;
    who.bounces = 0;
    who.hits.clear();
    who.arrivals.clear();
}

/// Flies some rows through `parts` equal parts of the step.
void fly_through(const FlightScene& scene, int parts, std::span<const std::size_t> some,
                 Points& y_0, Points& y_1, CaughtFlights& all) {
    const auto first = [&](std::size_t k) {
        return std::min(static_cast<int>(all.born[k] * parts), parts - 1);
    };
    const auto is_flying = [&](std::size_t k) { return all.end[k] == End::FLOWN; };
    bool is_placed = false;
    for (int part = 0; part < parts; ++part) {
        if (std::none_of(some.begin(), some.end(), is_flying)) return;
        const auto has_started = [&](std::size_t k) { return first(k) <= part; };
        if (std::none_of(some.begin(), some.end(), has_started)) continue;
        if (!std::exchange(is_placed, true)) place_nodes(scene, part, parts, y_1);
        y_0.swap(y_1);
        place_nodes(scene, part + 1, parts, y_1);
        const FlightScene within{scene.lists, nullptr,          scene.triangles,    y_0.data(),
                                 y_1.data(),  scene.dt / parts, scene.transmission, scene.friction};
        parallel::for_each(
            some.size(),
            [&](std::size_t i) {
                const std::size_t k = some[i];
                if (!is_flying(k) || !has_started(k)) return;
                const double late =
                    part == first(k) ? std::max(0.0, all.born[k] * parts - part) : 0.0;
                all.end[k] = fly_one(within, late, all.who[k]);
            },
            1);
    }
}

}  // namespace

void fly_in_parts(const FlightScene& scene, CaughtFlights& caught) {
    const auto nodes = static_cast<std::size_t>(scene.lists.nodes().back()) + 1;
    Points y_0(nodes), y_1(nodes);
    const std::vector<Flyer> at_first = caught.who;
    caught.end.clear();
    const std::size_t most = std::max(TOGETHER / at_first.size(), EACH);
    for (std::size_t k = 0; k < at_first.size(); ++k) {
        caught.end.push_back(is_finite(at_first[k].x, at_first[k].v) ? End::CAUGHT : End::BROKEN);
        caught.who[k].left = static_cast<int>(most);
    }
    for (const int parts : {16, 256, 4096}) {
        std::vector<std::size_t> some;
        for (std::size_t k = 0; k < at_first.size(); ++k) {
            if (caught.end[k] != End::CAUGHT || caught.who[k].left == 0) continue;
            begin_again(at_first[k], caught.who[k]);
            caught.end[k] = End::FLOWN;
            some.push_back(k);
        }
        fly_through(scene, parts, some, y_0, y_1, caught);
    }
    for (std::size_t k = 0; k < at_first.size(); ++k)
        if (caught.end[k] == End::CAUGHT) begin_again(at_first[k], caught.who[k]);
}

}  // namespace corpuscle::gas
