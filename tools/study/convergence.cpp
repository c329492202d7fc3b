// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corpuscle::study {
namespace {

/// Runs at a point that have a response.
std::vector<double> at_point(const Table& table, const std::vector<double>& point,
                             std::size_t response) {
    std::vector<double> values;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const double value = table.outcomes[k].responses[response];
        if (table.rows[k].values == point && !std::isnan(value)) values.push_back(value);
    }
    return values;
}

Refinement refine(const Table& table, std::size_t factor, std::size_t response) {
    const Factor& of = table.study.factors[factor];
    Refinement refinement;
    refinement.factor = factor;
    refinement.values = of.values;
    std::vector<double> known;
    std::vector<Estimate> means;
    for (const double value : of.values) {
        std::vector<double> point = table.rows.front().values;
        point[factor] = value;
        refinement.means.push_back(mean_of(at_point(table, point, response)));
        if (std::isnan(refinement.means.back().value)) continue;
        known.push_back(value);
        means.push_back(refinement.means.back());
    }
    const bool is_known = !known.empty() && known.front() == of.values.front();
    if (is_known && !std::isnan(of.order))
        refinement.to_limit = change_to_limit(known, means, of.order);
    return refinement;
}

std::string shown(const Estimate& estimate) {
    if (std::isnan(estimate.value)) return "-";
    return std::isnan(estimate.half_width)
               ? fmt::format("{:.4g}", estimate.value)
               : fmt::format("{:.4g} ± {:.2g}", estimate.value, estimate.half_width);
}

std::string share(double part, double whole) {
    return whole > 0.0 && !std::isnan(part) ? fmt::format("{:.0f} %", 100.0 * part * part / whole)
                                            : "-";
}

std::string text_of(const Table& table, const Convergence& of) {
    const Study& study = table.study;
    std::string text = fmt::format("{} [{}]: **{}**", study.responses[of.response],
                                   unit_of(table, of.response), shown(of.centre));
    const char* before = " at ";
    for (const Factor& factor : study.factors) {
        text += fmt::format("{}{} = {:g}", before, factor.name, factor.values.front());
        before = ", ";
    }
    text += fmt::format("; all factors at their limits {:.4g}, uncertainty {:.2g} ({:.2g} %)\n\n",
                        of.extrapolated, of.uncertainty,
                        100.0 * of.uncertainty / std::abs(of.centre.value));
    text +=
        "| factor | mean at each value | order | to its limit | share |\n|---|---|---|---|---|\n";
    const double whole = of.uncertainty * of.uncertainty;
    for (const Refinement& r : of.refinements) {
        const Factor& factor = study.factors[r.factor];
        std::string means;
        for (std::size_t k = 0; k < r.values.size(); ++k)
            means += fmt::format("{}{:g}: {}", k == 0 ? "" : "; ", r.values[k], shown(r.means[k]));
        text += fmt::format("| {} | {} | {} | {} | {} |\n", factor.name, means,
                            std::isnan(factor.order) ? "-" : fmt::format("{:g}", factor.order),
                            shown(r.to_limit), share(Convergence::part_of(r), whole));
    }
    const double half = of.centre.half_width;
    return text + fmt::format("| seeds | {} | | {} | {} |\n\n", of.seeds,
                              std::isnan(half) ? "-" : fmt::format("± {:.2g}", half),
                              share(half, whole));
}

}  // namespace

double Convergence::part_of(const Refinement& refinement) {
    const auto [change, half] = refinement.to_limit;
    return std::isnan(half) ? std::abs(change) : std::max(std::abs(change), half);
}

Estimate change_to_limit(const std::vector<double>& v, const std::vector<Estimate>& y,
                         double order) {
    if (v.size() < 2) return {NaN, NaN};
    const bool is_weighted = std::all_of(y.begin(), y.end(), [](const Estimate& e) {
        return e.half_width > 0.0;  // false for what is not a number
    });
    double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double x = std::pow(v[i] / v[0], -order);
        const double weight = is_weighted ? 1.0 / (y[i].half_width * y[i].half_width) : 1.0;
        w += weight;
        wx += weight * x;
        wy += weight * y[i].value;
        wxx += weight * x * x;
        wxy += weight * x * y[i].value;
    }
    const double spread = wxx - wx * wx / w;
    // y = y* + C x with x = 1 at the first value: to the limit it changes by -C
    const double slope = (wxy - wx * wy / w) / spread;
    return {-slope, is_weighted ? std::sqrt(1.0 / spread) : NaN};
}

std::vector<Convergence> convergence(const Table& table) {
    std::vector<Convergence> all;
    for (std::size_t r = 0; r < table.study.responses.size(); ++r) {
        Convergence one;
        one.response = r;
        const std::vector<double> centre = at_point(table, table.rows.front().values, r);
        one.seeds = centre.size();
        one.centre = mean_of(centre);
        one.extrapolated = one.centre.value;
        double squares = 0.0;
        const auto take = [&](double part) { squares += std::isnan(part) ? 0.0 : part * part; };
        take(one.centre.half_width);
        for (std::size_t f = 0; f < table.study.factors.size(); ++f) {
            one.refinements.push_back(refine(table, f, r));
            const Refinement& last = one.refinements.back();
            take(Convergence::part_of(last));
            if (!std::isnan(last.to_limit.value)) one.extrapolated += last.to_limit.value;
        }
        one.uncertainty = std::sqrt(squares);
        all.push_back(std::move(one));
    }
    return all;
}

std::string convergence_text(const Table& table) {
    std::string text;
    for (const Convergence& one : convergence(table)) text += text_of(table, one);
    return text;
}

}  // namespace corpuscle::study
