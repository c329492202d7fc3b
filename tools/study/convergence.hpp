// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/study/estimate.hpp"
#include "tools/study/table.hpp"

namespace corpuscle::study {

/// What one factor of a star does to a response.
struct Refinement {
    std::size_t factor = 0;
    std::vector<double> values;   ///< the centre's first
    std::vector<Estimate> means;  ///< of the response there
    /// Of the response, from the centre to the factor's limit; NaN: the factor has no order, or the
    /// response is not there at two of its values.
    Estimate to_limit{NaN, NaN};
};

/// What a response is known to at the centre of a star.
struct Convergence {
    std::size_t response = 0;
    std::size_t seeds = 0;      ///< runs at the centre that have it
    Estimate centre{NaN, NaN};  ///< mean over the seeds
    std::vector<Refinement> refinements;
    double extrapolated = NaN;  ///< centre, and what all factors change to their limits
    double uncertainty = NaN;   ///< root of the sum of squares of seeds and factors

    /// Part of a factor in the uncertainty: the greater of the change to its limit and its interval.
    [[nodiscard]] static double part_of(const Refinement& refinement);
};

/// Value at the limit of y(v) = y* + C v^-k [Richardson 1911], by least squares weighted by the
/// squares of the means' intervals where all have one, less y at the first value of v.
/// @param order  k; < 0: the limit is at v = 0
/// @returns NaN for less than two values
[[nodiscard]] Estimate change_to_limit(const std::vector<double>& v, const std::vector<Estimate>& y,
                                       double order);

/// Of all responses of a study by plan STAR.
[[nodiscard]] std::vector<Convergence> convergence(const Table& table);

/// A table for each response, in Markdown: values, means with their 95 % intervals, changes to the
/// limits and shares of the square of the uncertainty.
[[nodiscard]] std::string convergence_text(const Table& table);

}  // namespace corpuscle::study
