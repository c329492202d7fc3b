// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"

namespace corpuscle::test {

/// Calls visit(path) for every dataset below `group`.
template <class Visit>
void each_dataset(const io::Hdf5Reader& file, const std::string& group, Visit&& visit) {
    for (const std::string& name : file.names(group)) {
        const std::string path = (group == "/" ? "" : group) + "/" + name;
        if (file.is_group(path))
            each_dataset(file, path, visit);
        else
            visit(path);
    }
}

inline bool all_finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Numbers of a results.h5.
struct Numbers {
    std::size_t count = 0;
    std::string not_finite;  ///< the first dataset with one that is not; empty: all are
};

/// Reads every dataset of a results.h5.
inline Numbers numbers_of(const std::filesystem::path& results) {
    Numbers numbers;
    const io::Hdf5Reader file(results);
    each_dataset(file, "/", [&](const std::string& path) {
        const auto values = file.read<double>(path);
        numbers.count += values.size();
        if (numbers.not_finite.empty() && !all_finite(values)) numbers.not_finite = path;
    });
    return numbers;
}

}  // namespace corpuscle::test
