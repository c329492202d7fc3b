// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::gas {

/// What particles of one kind of gas in a group keep of their internal energies' deviations, when
/// the mean changes:
///
///     e' = lowest + kept (e - least),     mean of e' = the new mean
///
/// kept: `memory`, or the most that leaves no e' below zero. Neither term is below zero, so that
/// rounding makes no e' so either. A mean that is below zero itself (Species) is every e'.
///
/// Number: double, or a vector of them with a group a lane.
template <class Number>
struct Deviation {
    Number lowest;  ///< e' of the particle that has least                                  [J]
    Number kept;    ///< [-]

    /// @param mean    of e'                                                                [J]
    /// @param before  mean of e                                                            [J]
    /// @param least   of all e                                                             [J]
    /// @param memory  kept at most                                                         [-]
    static Deviation of(const Number& mean, const Number& before, const Number& least,
                        double memory) {
        const Number none{}, below = before - least, lowered = mean - memory * below;
        const auto is_free = lowered >= none;
        const Number floor = mean < none ? mean : none, share = mean > none ? mean / below : none;
        return {is_free ? lowered : floor, is_free ? none + memory : share};
    }
};

}  // namespace corpuscle::gas
