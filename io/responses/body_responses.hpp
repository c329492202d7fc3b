// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "io/text/units.hpp"
#include "solver/base/vec.hpp"

/// @file
/// What an impact test would report of a rigid form: and nothing that a rigid form cannot give
/// (neck forces, chest deflection).

namespace corpuscle::io {

/// Motion of one rigid body, uniformly sampled, in deck units: row k is at k times the interval.
struct BodyMotion {
    int id = 0;             ///< of its part
    double mass = 0.0;      ///< of the body
    double interval = 0.0;  ///< between rows, > 0
    Points position,        ///< of the mass centre, by row
        velocity,           ///< of the mass centre, by row
        acceleration,       ///< mean since the row before
        force;              ///< of contact and gas on it, mean since the row before
};

/// A number with all that is needed to read it.
struct Response {
    std::string name;    ///< as studies ask for it: "peak_acceleration_cfc60"
    double value;        ///< NaN: there is none, `note` says why
    std::string unit;    ///< "g", "kN", ...
    std::string filter;  ///< "raw" or "CFC 1000"; "-" where none applies
    std::string note;    ///< a window, a reason, ""
};

/// Every response, in the order in which tables show them.
///
/// Of the axis along which the body meets the bag: that of its velocity at the start, or, of a body
/// that starts at rest, against the impulse that it gets.
/// Contact begins at the row after which the force first exceeds 1/1000 of its peak.
[[nodiscard]] std::vector<Response> body_responses(const BodyMotion& motion,
                                                   const std::string& unit_system);

/// The bodies of /history_fast.
[[nodiscard]] std::vector<int> tracked_bodies(const Hdf5Reader& results);
/// The motion of one of them.
/// @param id  of its part
/// @throws InputError  where there are less than two rows, SystemError where they cannot be read
[[nodiscard]] BodyMotion read_motion(const Hdf5Reader& results, int id);

/// The responses of one body.
struct BodyTable {
    int id;                           ///< of its part
    std::vector<Response> responses;  ///< of body_responses()
};
/// For programs: `{"bodies": {"20": {"peak_force": {"value": 1.5, "unit": "kN", ...}}}}`.
[[nodiscard]] std::string responses_json(const std::vector<BodyTable>& tables);
/// For people.
[[nodiscard]] std::string responses_text(const BodyTable& table);
/// /responses/PID/NAME, those that have a value.
void write_responses(Hdf5Writer& file, const std::vector<BodyTable>& tables);

}  // namespace corpuscle::io
