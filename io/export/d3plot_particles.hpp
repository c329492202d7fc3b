// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/export/d3plot_words.hpp"
#include "io/results/hdf5.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// The airbag particles of a d3plot (its control word NPEFG), as *AIRBAG_PARTICLE writes them:
/// what a particle's values are, behind the control words; the bags, behind the numbering; values
/// of bags and particles, at the end of each state [LS-DYNA database manual; lasso-python].
///
/// A d3plot has the same particles in every state: those of any frame, by bag and id. One that a
/// frame does not have has no mass and no energy; it lies where it will come in, or where it was
/// last, and LEAKAGE is 2 of one that is gone.
class D3plotParticles {
public:
    explicit D3plotParticles(const Hdf5Reader& results);

    /// 0 without particles, else 3000 and the number of bags.
    [[nodiscard]] std::int64_t flag() const;
    void variables(D3plotWords& file) const;
    void bags(D3plotWords& file) const;
    /// @param at   "/frames/00007/", in the order of time
    /// @param row  of the histories
    void state(D3plotWords& file, const std::string& at, std::size_t row);

private:
    struct Bag {
        std::int32_t id;
        std::size_t first, count;  ///< particles
        std::int64_t gases;
        std::vector<double> volume;  ///< T
    };
    /// Values of one particle as they are now.
    struct Particle {
        std::pair<std::int32_t, std::int64_t> name;  ///< bag, id
        Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
        double mass = 0.0, spin = 0.0;
        std::int32_t gas = 0;
        bool was_there = false, is_there = false;
    };
    void take(const std::string& at, bool as_first_place);

    const Hdf5Reader& results_;
    std::vector<Bag> bags_;
    std::vector<Particle> all_;  ///< ascending by name
};

}  // namespace corpuscle::io
