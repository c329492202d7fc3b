// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/verify/card.hpp"
#include "tools/verify/measured_run.hpp"

namespace corpuscle::verify {

/// A resolution's runs, or why there are none.
struct Level {
    const LevelCard* card = nullptr;
    Runs runs;
    std::string fault;  ///< of a run that failed or is missing; empty: none
};

/// A resolution of a quantity.
struct Point {
    double size = 0.0;
    Estimate error{NaN, NaN};
    double cpu_seconds = 0.0;  ///< of a run, mean over the seeds
    double steps = 0.0, particle_steps = 0.0;
    std::size_t seeds = 0;
};

/// A line of the table.
struct Row {
    const Card* card = nullptr;
    const Quantity* quantity = nullptr;
    double budget = 0.0;
    std::vector<Point> points;  ///< coarse to fine
    double order = NaN;         ///< observed
    enum class Verdict { HOLDS, MISSED, FAILED } verdict = Verdict::FAILED;
    bool is_sure = true;  ///< the interval does not reach across the budget
    std::string fault;

    [[nodiscard]] bool holds() const { return verdict == Verdict::HOLDS; }
    [[nodiscard]] const Point& finest() const { return points.back(); }
    [[nodiscard]] std::string name() const { return card->name + "/" + quantity->name; }
};

/// The rows of a case. A quantity holds where |error| on the finest level is within its budget, and
/// where the observed order is no less than what is asked for.
[[nodiscard]] std::vector<Row> judge(const Card& card, Mode mode, const std::vector<Level>& levels);

/// "0.31 ± 0.05 %", in the quantity's unit.
[[nodiscard]] std::string shown(const Quantity& quantity, const Estimate& error);
[[nodiscard]] std::string shown(const Quantity& quantity, double value);
/// "holds", "MISSED" or "FAILED", with "?" where chance may have decided.
[[nodiscard]] std::string shown_verdict(const Row& row);
/// What is known of the order: "0.5", "2.0 of 1.8" or "".
[[nodiscard]] std::string shown_order(const Row& row);

}  // namespace corpuscle::verify
