// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/verdict.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "tools/verify/case_list.hpp"

namespace corpuscle::verify {
namespace {

Point cost_of(const Level& level) {
    Point point;
    point.size = level.card->size;
    point.seeds = level.runs.size();
    const auto n = static_cast<double>(level.runs.size());
    for (const MeasuredRun& run : level.runs) {
        point.cpu_seconds += run.cpu_seconds() / n;
        point.steps += run.steps() / n;
        point.particle_steps += run.particle_steps() / n;
    }
    return point;
}

/// NaN where chance hides an error: what is within its interval of 0 has no order.
double observed_order(const std::vector<Point>& points) {
    std::vector<double> sizes, errors;
    for (const Point& point : points) {
        const auto [value, half] = point.error;
        if (std::abs(value) <= half || point.size == 0.0) return NaN;
        sizes.push_back(point.size);
        errors.push_back(value);
    }
    return fitted_order(sizes, errors);
}

void decide(Row& row) {
    if (!row.fault.empty()) return;
    if (row.quantity->refines) row.order = observed_order(row.points);
    const auto [value, half] = row.finest().error;
    const double error = std::abs(value);
    const bool is_within = error <= row.budget;  // false for what is not a number
    const bool is_of_order = row.quantity->order == 0.0 || row.order >= row.quantity->order;
    row.verdict = is_within && is_of_order ? Row::Verdict::HOLDS : Row::Verdict::MISSED;
    row.is_sure = std::isnan(half) || std::abs(error - row.budget) > half;
}

}  // namespace

std::vector<Row> judge(const Card& card, Mode mode, const std::vector<Level>& levels) {
    std::vector<Row> rows;
    for (const Quantity& quantity : card.quantities) {
        Row row;
        row.card = &card;
        row.quantity = &quantity;
        row.budget = mode == Mode::QUICK ? quantity.budget_quick : quantity.budget_full;
        rows.push_back(row);
    }
    for (const Level& level : levels) {
        const Point cost = cost_of(level);
        Findings found;
        std::string fault = level.fault;
        if (fault.empty()) try {
                found = method_of(card)(level.runs);
            } catch (const SystemError& error) {
                fault = error.what();
            }
        for (Row& row : rows) {
            row.points.push_back(cost);
            const auto at = found.find(row.quantity->name);
            if (at != found.end())
                row.points.back().error = at->second;
            else if (row.fault.empty())
                row.fault = fault.empty() ? "nothing measures it" : fault;
        }
    }
    for (Row& row : rows) decide(row);
    return rows;
}

std::string shown(const Quantity& quantity, double value) {
    if (std::isnan(value)) return "-";
    return quantity.unit == "%"    ? fmt::format("{:.3g} %", 100.0 * value)
           : quantity.unit.empty() ? fmt::format("{:.3g}", value)
                                   : fmt::format("{:.3g} {}", value, quantity.unit);
}

std::string shown(const Quantity& quantity, const Estimate& error) {
    if (std::isnan(error.half_width)) return shown(quantity, error.value);
    const double factor = quantity.unit == "%" ? 100.0 : 1.0;
    const std::string unit = quantity.unit.empty() ? "" : " " + quantity.unit;
    return fmt::format("{:.3g} ± {:.2g}{}", factor * error.value, factor * error.half_width, unit);
}

std::string shown_verdict(const Row& row) {
    const char* const word = row.verdict == Row::Verdict::HOLDS    ? "holds"
                             : row.verdict == Row::Verdict::MISSED ? "MISSED"
                                                                   : "FAILED";
    return word + std::string(row.is_sure ? "" : "?");
}

std::string shown_order(const Row& row) {
    if (std::isnan(row.order)) return "";
    return row.quantity->order > 0.0 ? fmt::format("{:.2f} of {:g}", row.order, row.quantity->order)
                                     : fmt::format("{:.2f}", row.order);
}

}  // namespace corpuscle::verify
