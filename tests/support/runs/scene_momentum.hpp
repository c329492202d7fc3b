// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace corpuscle::test {

/// Greatest change of the momentum of cloth, bodies, gas and what gas owes to cloth, over the sum
/// of the sizes of all that moves; of a scene that nothing holds, whose rows and frames are of the
/// same times.
/// @param since  share of the time from which on nothing comes in
[[nodiscard]] double change_of_momentum(const std::filesystem::path& results, double since);

}  // namespace corpuscle::test
