// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "io/results/hdf5.hpp"

namespace corpuscle::io {

/// A binout (LSDA) of the results' histories: glstat, matsum, abstat, abstat_cpm, rbdout, rcforc,
/// rwforc, nodout, each if there is something in it, as float64, a state for each row of /history.
[[nodiscard]] std::string binout(const Hdf5Reader& results);

/// Is this the beginning of what binout() made? It has no date, which LS-DYNA's has.
/// @param beginning  longer than the path of the deck
[[nodiscard]] bool is_own_binout(std::string_view beginning);

}  // namespace corpuscle::io
