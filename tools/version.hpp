// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace corpuscle::tools {

std::string_view version();  ///< "0.1.0"

/// What `corpuscle --version` prints: version, commit, compiler, options of the build.
std::string version_text();

}  // namespace corpuscle::tools
