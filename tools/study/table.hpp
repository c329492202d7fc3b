// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/study/outcome.hpp"

namespace corpuscle::study {

/// All runs of a study with what came of them.
struct Table {
    const Study& study;
    std::vector<Row> rows;
    std::vector<Outcome> outcomes;  ///< of the rows
};

[[nodiscard]] Table gather(const Study& study);

/// The unit of a response, as any run tells it.
[[nodiscard]] std::string unit_of(const Table& table, std::size_t response);

/// study.csv and study.h5, each renewed in one stroke.
void write_csv(const Table& table);
void write_h5(const Table& table);

/// A line a point: its values, runs that are there, and of each response the mean over the seeds,
/// half of its 95 % interval and the seeds' spread (sample standard deviation over the mean).
[[nodiscard]] std::string table_text(const Table& table);

/// Mean and sample standard deviation of what is not NaN.
struct Spread {
    std::size_t count = 0;
    double mean = 0.0, deviation = 0.0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// Of one response at each value of one factor: mean over all else.
struct Effect {
    double value;
    double mean;
};
[[nodiscard]] std::vector<Effect> main_effect(const Table& table, std::size_t factor,
                                              std::size_t response);

}  // namespace corpuscle::study
