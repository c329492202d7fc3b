// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace corpuscle {
struct Model;
}

namespace corpuscle::tools {

/// What check says, for scripts; each message as {"file": ..., "line": ..., "text": ...}, file and
/// line where the message has them.
///
///     {"deck": ..., "accepted": true, "errors": [], "warnings": [...], "notes": [...],
///      "mended": [...]}
///
/// @param model  nullptr: the deck is refused, for `errors`
std::string check_json(const std::string& deck, const Model* model,
                       const std::vector<std::string>& errors);

}  // namespace corpuscle::tools
