// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// What an XDMF file needs to know of results.h5: sizes only, the numbers stay there.
struct XdmfScene {
    /// A frame, of those that results.h5 holds.
    struct State {
        double time = 0;                         ///< [s]
        std::optional<std::uint64_t> particles;  ///< absent: none are shown
    };
    std::uint64_t nodes = 0,          ///< N of /mesh
        shells = 0;                   ///< E of /mesh
    std::uint64_t topology_size = 0;  ///< length of /mesh/xdmf_topology
    bool has_contact = false;         ///< frames hold contact pressure by shell
    std::vector<State> states;        ///< in the order of the frames
};

/// Mixed topology of XDMF: for each shell 4 (triangle) or 5 (quad), then its node rows.
/// @param shells  E × 4 node rows, a triangle repeats its 3rd
[[nodiscard]] std::vector<std::int32_t> xdmf_topology(std::span<const std::array<Index, 4>> shells);

/// The text of the XDMF file beside results.h5: two temporal collections, the shells ("bag") and,
/// of the states that have any, the particles ("gas").
[[nodiscard]] std::string xdmf_text(const XdmfScene& scene);

/// "00012" for frame 12.
[[nodiscard]] std::string frame_name(std::size_t frame);

}  // namespace corpuscle::io
