// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace corpuscle::io {

/// Kinds of ids that *INCLUDE_TRANSFORM shifts, one offset each.
///
/// A field says its kind by the registry that its reader looks in (DraftNames), or by itself
/// (Card::id).
enum class IdKind : std::uint8_t {
    NODE,      ///< *NODE
    ELEMENT,   ///< *ELEMENT_...
    PART,      ///< *PART, nodal rigid bodies, *RIGIDWALL_...
    MATERIAL,  ///< *MAT_..., *EOS_...
    SET,       ///< *SET_...
    FUNCTION,  ///< *DEFINE_CURVE, *DEFINE_TABLE, *DEFINE_FUNCTION
    DEFINE,    ///< every other *DEFINE_...
    OTHER      ///< sections, hourglass, contacts, airbags, joints
};
inline constexpr std::size_t ID_KINDS = 8;

/// Their fields on the cards of *INCLUDE_TRANSFORM, in the order of the kinds.
inline constexpr std::array<std::string_view, ID_KINDS> OFFSET_FIELDS = {
    "IDNOFF", "IDEOFF", "IDPOFF", "IDMOFF", "IDSOFF", "IDFOFF", "IDDOFF", "IDROFF"};

/// What is added to the ids of each kind.
using IdOffsets = std::array<std::int64_t, ID_KINDS>;

}  // namespace corpuscle::io
