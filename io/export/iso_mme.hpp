// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "io/results/hdf5.hpp"

namespace corpuscle::io {

/// Takes a file by its path below the test's folder: "oop.mme", "Channel/oop.chn",
/// "Channel/oop.001", ... and its bytes.
using MmeFile = std::function<void(const std::string& name, const std::string& bytes)>;

/// The rigid bodies of /history_fast as test data come, ISO/TS 13499 (edition 1.6): acceleration
/// and force along x, y, z and their resultants, velocity and displacement along x, y, z, in SI,
/// unfiltered, a file a channel.
///
/// A channel's code is H0IMPA0000 (linear impactor), the body's number in two digits (00 if it is
/// the only one), AC, FO, VE or DS, the deck's axis or R, and 0: unfiltered.
/// @throws InputError for results without such bodies, or in units that have no name
void write_iso_mme(const Hdf5Reader& results, const std::string& test, const MmeFile& write);

}  // namespace corpuscle::io
