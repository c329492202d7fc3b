// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/flight/facet_bounds.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/flight/rough_wall.hpp"
#include "gas/flight/safe_distances.hpp"
#include "gas/flight/transmission.hpp"
#include "gas/particles.hpp"

namespace corpuscle::gas {

/// What a particle gave to a facet when it bounced off it, or left through it.
struct Hit {
    Index facet;
    Index who;                   ///< row of the particle; -1 - row when it left in this step
    std::array<double, 3> at;    ///< barycentric coordinates on the facet                    [-]
    Vec3 impulse;                ///< m (v - v')                                              [N s]
    double energy;               ///< m (v² - v'²) / 2                                        [J]
    Vec3 where;                  ///< where the particle turned                               [m]
    Vec3 moment = Vec3::Zero();  ///< beside that of the impulse there, of recoil         [N m s]

    [[nodiscard]] bool has_left() const { return who < 0; }
    [[nodiscard]] std::size_t row() const {
        return static_cast<std::size_t>(has_left() ? -1 - who : who);
    }
};

/// A particle that could not be followed to the end of a step.
struct Lost {
    std::size_t particle;  ///< row
    Vec3 at;               ///< where it was last seen                                      [m]
};

/// Thrown for the first particle whose place or velocity is not finite.
struct BrokenParticle {
    std::size_t row;
    bool in_flight;  ///< else it came so
};

struct FlightResult {
    std::vector<std::vector<Hit>> hits;  ///< a list a chunk, to be read in order
    std::vector<Lost> lost;
    FacetBounds bounds;  ///< of this flight; kept for its memory
    SafeDistances safe;  ///< kept from flight to flight
    std::vector<std::vector<Arrival>>
        arrivals;  ///< at openings, a list a chunk, to be read in order
    std::vector<std::vector<std::size_t>> caught;  ///< that had to fly again, a list a chunk
};

/// Free flight through one step, t -> t + dt, with specular reflection off the moving facets.
///
///     v' = v - 2 ((v - v_w)·n) n                                          [notes, p. "elastic
///     impact"]
///
/// Facets move linearly; positions, normals and velocities v_w are those of the instant and the
/// point of the hit. Any number of hits in a step; no facet is ever passed (see crossing.hpp).
/// A particle that bounces a thousand times in a step is caught between facets, and flies the step
/// again in smaller and smaller parts; one that bounces on and on is lost (fly_in_parts()).
/// `born[i]`: for the last born.size() particles, the share of the step at which they start.
/// `mass[s]`: of a particle of species s. `friction`: what rough fabric takes from the velocity
/// along it turns into the particle's internal energy. `transmission`: where particles may pass;
/// what has left stays in `gas` where it was, to be removed.
/// @throws BrokenParticle, and the flight is void
void fly(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
         std::span<const double> mass, std::span<const double> born, Particles& gas,
         FlightResult& result, const Transmission* transmission = nullptr,
         const WallFriction& friction = {});

}  // namespace corpuscle::gas
