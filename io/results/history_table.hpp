// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "io/text/units.hpp"
#include "solver/records.hpp"

namespace corpuscle::io {

/// Names of the histories that have three numbers a row, as the last word of their path: "force",
/// "velocity", ... No history of one number is called so.
[[nodiscard]] std::set<std::string> vector_histories();

/// Every history of a run, one column each, in memory: a run's histories are small (1000 samples of
/// 200 columns are 1.6 MB), and so each version of the results holds all of them, whole.
class HistoryTable {
public:
    /// Columns for all that the layout names, no rows yet.
    /// @throws InputError if two things of one kind bear the same id
    explicit HistoryTable(const RecordLayout& layout);

    /// One row more; the sample has the layout's sizes.
    /// @throws PhysicsError, with the table as it was, if a number of the row is not finite
    void append(const RecordLayout& layout, const Sample& sample);

    /// Writes /history, in the units of `unit_system`.
    void write(Hdf5Writer& file, const std::string& unit_system) const;

    /// Appended so far.
    [[nodiscard]] std::size_t rows() const { return rows_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(rows_, last_);
        for (Column& column : columns_) archive(column.values);
    }

private:
    void expect_finite(double time);

    struct Column {
        std::string path;
        Quantity quantity;
        std::string description;
        bool is_vector;  ///< rows × 3
        std::vector<double> values;
    };

    std::vector<Column> columns_;
    std::size_t rows_ = 0;
    Sample last_;  ///< of the row before, once there is one
};

}  // namespace corpuscle::io
