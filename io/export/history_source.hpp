// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/results/hdf5.hpp"

namespace corpuscle::io {

/// A history of results.h5, a column of numbers or three.
struct History {
    std::string path;  ///< below the group that was asked for: "airbag/1/pressure"
    std::string unit;
    std::size_t columns;         ///< 1 or 3
    std::vector<double> values;  ///< row by row
};

/// Every history below a group ("/history"), in alphabetical order, its `time` first.
/// @throws SystemError if the group is not there
[[nodiscard]] std::vector<History> read_histories(const Hdf5Reader& results,
                                                  const std::string& group);

/// Titles of parts by id, as the run's deck has them; none of results without them.
[[nodiscard]] std::map<int, std::string> part_titles(const Hdf5Reader& results);

/// "time [ms],airbag/1/pressure [GPa],rigid_body/20/force.x [kN],...", then the rows.
[[nodiscard]] std::string csv_text(const std::vector<History>& histories);

/// Is this the beginning of what csv_text() made: a time with its unit, then paths?
[[nodiscard]] bool is_own_csv(std::string_view beginning);

}  // namespace corpuscle::io
