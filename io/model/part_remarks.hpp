// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

/// What matters of sections and masses only where parts are of a certain kind.
namespace corpuscle::io {

/// ELFORM of shells that deform: a warning where it is not a membrane's, a fault where it is that of a
/// plane or solid-like shell. Of rigid parts, and of parts that nothing is of, it does not matter.
void check_forms(const Draft& draft, Faults& faults);

/// 1 for nodes of shells, and for those with a mass of their own.
std::vector<std::uint8_t> nodes_with_mass(const Model& model);

/// A fault for bodies of nodes whose masses are all in one place: they have no moment of inertia.
void expect_extent(const Draft& draft, Faults& faults);

/// A warning for masses of *ELEMENT_MASS on nodes of bodies whose mass *PART_INERTIA says: they count
/// for nothing.
void warn_of_lost_masses(const Draft& draft, Faults& faults);

/// A note for walls that stop nodes of rigid bodies where RWPNAL of *CONTROL_CONTACT is 0: LS-DYNA
/// lets them pass then.
void note_stopped_bodies(Draft& draft, Faults& faults);

}  // namespace corpuscle::io
