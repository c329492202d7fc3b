// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "solver/records.hpp"

/// One state of each of LS-DYNA's text files, in its columns, for scripts that people already have.
/// What the columns hold here is told in io/FORMAT.md.
namespace corpuscle::io {

/// Told in the first lines of every text file: whose it is.
inline constexpr std::string_view WRITER = "corpuscle, in the columns of ls-dyna";

/// `value` right-justified as C's %WIDTH.PRECISIONE; an exponent of three digits costs precision,
/// so that columns stay where they are.
[[nodiscard]] std::string field(double value, int width, int precision);

/// @param start  the first sample of the file: energies are told relative to it
[[nodiscard]] std::string glstat_state(const Sample& sample, const Sample& start);
/// @param before  the sample of the state before: mass flows of bags of particles are means since
///                then, 0 if it is this one
[[nodiscard]] std::string abstat_state(const RecordLayout& layout, const Sample& sample,
                                       const Sample& before);
/// abstat of the bags of particles alone.
[[nodiscard]] std::string abstat_cpm_state(const RecordLayout& layout, const Sample& sample,
                                           const Sample& before);
/// What cpm_sensor begins with instead of a title, and a state of it.
[[nodiscard]] std::string cpm_sensor_heading(const RecordLayout& layout);
[[nodiscard]] std::string cpm_sensor_state(const Sample& sample);
[[nodiscard]] std::string matsum_state(const RecordLayout& layout, const Sample& sample);
/// @param before  the sample of the state before: forces are means since then, 0 if it is this one
[[nodiscard]] std::string rcforc_state(const RecordLayout& layout, const Sample& sample,
                                       const Sample& before);
[[nodiscard]] std::string rwforc_state(const RecordLayout& layout, const Sample& sample,
                                       const Sample& before);
/// @param start  the first sample of the file: displacements are told relative to it
[[nodiscard]] std::string rbdout_state(const RecordLayout& layout, const Sample& sample,
                                       const Sample& start);
/// @param before  the sample of the state before: acceleration is the mean since then, 0 if it is
///                this one
[[nodiscard]] std::string nodout_state(const RecordLayout& layout, const Sample& sample,
                                       const Sample& before);

}  // namespace corpuscle::io
