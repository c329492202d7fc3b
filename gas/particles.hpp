// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Particles inside a bag, one array a quantity (64 bytes a particle).
///
/// Every particle stands for the same number of moles `moles_each` of its species, so its mass is
/// moles_each · M: only then do collisions between species end in equipartition.
struct Particles {
    std::vector<Vec3> x;                  ///< position                                    [m]
    std::vector<Vec3> v;                  ///< velocity                                    [m/s]
    std::vector<double> e;                ///< internal (spin + vibration) energy          [J]
    std::vector<std::int32_t> species;    ///< row among the bag's species
    std::vector<std::int32_t> id;         ///< born 0, 1, 2, ...; never reused

    [[nodiscard]] std::size_t size() const { return x.size(); }

    void resize(std::size_t n) {
        x.resize(n);
        v.resize(n);
        e.resize(n);
        species.resize(n);
        id.resize(n);
    }
    void erase(std::size_t row) {
        const auto at = static_cast<std::ptrdiff_t>(row);
        x.erase(x.begin() + at);
        v.erase(v.begin() + at);
        e.erase(e.begin() + at);
        species.erase(species.begin() + at);
        id.erase(id.begin() + at);
    }
    void add(const Vec3& at, const Vec3& velocity, double internal, std::int32_t kind,
             std::int32_t born) {
        x.push_back(at);
        v.push_back(velocity);
        e.push_back(internal);
        species.push_back(kind);
        id.push_back(born);
    }
};

}  // namespace corpuscle::gas
