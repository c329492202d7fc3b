// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::test {

/// What a short run of a model gave when it was last judged right: models/<case>/baseline.csv.
///
/// The first line is "# options: " and the options of `corpuscle run`; then a header, and rows of
/// dataset,time,value,tolerance,why. The tolerance is in the dataset's unit, `why` is its reason.
struct Baseline {
    struct Row {
        std::string dataset;
        std::string time, value, tolerance;  ///< as written
        std::string why;
    };
    std::string options;
    std::vector<Row> rows;

    /// Throws std::runtime_error for a file that is not as above.
    static Baseline read(const std::filesystem::path& file);
    void write(const std::filesystem::path& file) const;
};

}  // namespace corpuscle::test
