// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// When a pair has to be looked at.
struct VerletEntry {
    double sum;           ///< distance when it was last known, and what was spent then      [m]
    float reach;          ///< gap from which it matters, at least                           [m]
    float approach;       ///< rate at which the gap is predicted to shrink, at most       [m/s]
    Index first, second;  ///< triangles
};

/// Entries, each of their numbers in a row of its own: all are read in every step, four at a time.
class VerletList {
public:
    std::vector<double> sum;           ///< as in VerletEntry
    std::vector<float> reach;          ///< likewise
    std::vector<Index> first, second;  ///< likewise

    void resize(std::size_t size) {
        sum.resize(size);
        reach.resize(size);
        approach_.resize(size);
        first.resize(size);
        second.resize(size);
    }
    void put(std::size_t row, const VerletEntry& watch) {
        sum[row] = watch.sum;
        reach[row] = watch.reach;
        approach_[row] = watch.approach;
        first[row] = watch.first;
        second[row] = watch.second;
    }
    void set_approach(std::size_t row, float approach) { approach_[row] = approach; }

    /// What a distance has shrunk by at most, at an age and after these displacements of triangles:
    ///     age · approach + displacement(first) + displacement(second)                                        [m]
    [[nodiscard]] double spent(std::size_t i, double age,
                               const std::vector<double>& displacement) const {
        return age * static_cast<double>(approach_[i]) +
               (displacement[first[i]] + displacement[second[i]]);
    }

    /// visit(row) for those in begin ... end - 1 with sum - spent <= reach, or <= 0.
    template <bool WITH_REACH, class Visit>
    void for_each_within(std::size_t begin, std::size_t end, double age,
                         const std::vector<double>& displacement, Visit&& visit) const {
        std::size_t i = begin;
        for (; i + FOUR <= end; i += FOUR)
            for (unsigned bits = within<WITH_REACH>(i, age, displacement); bits != 0;
                 bits &= bits - 1)
                visit(i + static_cast<std::size_t>(std::countr_zero(bits)));
        for (; i < end; ++i)
            if (sum[i] - spent(i, age, displacement) <=
                (WITH_REACH ? static_cast<double>(reach[i]) : 0.0))
                visit(i);
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(sum, reach, approach_, first, second);
    }

private:
    /// Bit l: row i + l is within.
    template <bool WITH_REACH>
    [[nodiscard]] unsigned within(std::size_t i, double age,
                                  const std::vector<double>& displacement) const {
        const Four is_at = load(&sum[i]), rate = load(&approach_[i]);
        const Four left =
            is_at -
            (age * rate + (gather(displacement, &first[i]) + gather(displacement, &second[i])));
        const FourBits is_within = left <= (WITH_REACH ? load(&reach[i]) : Four{});
        return bits_of(is_within);
    }
    static Four load(const double* a) { return Four{a[0], a[1], a[2], a[3]}; }
    static Four load(const float* a) { return Four{a[0], a[1], a[2], a[3]}; }
    static Four gather(const std::vector<double>& of, const Index* at) {
        return Four{of[at[0]], of[at[1]], of[at[2]], of[at[3]]};
    }

    std::vector<float> approach_;
};

}  // namespace corpuscle::contact
