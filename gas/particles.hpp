// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/parallel.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Particles inside a bag, one array a quantity (68 bytes a particle).
///
/// Every particle stands for the same number of moles `moles_each` of its species, so its mass is
/// moles_each · M: only then do collisions between species end in equipartition.
struct Particles {
    std::vector<Vec3> x;                ///< position                                    [m]
    std::vector<Vec3> v;                ///< velocity                                    [m/s]
    std::vector<double> e;              ///< internal (spin + vibration) energy          [J]
    std::vector<std::int32_t> species;  ///< row among the bag's species
    std::vector<std::int32_t> id;       ///< born 0, 1, 2, ...; never reused
    std::vector<std::int16_t> room;     ///< that it is in; empty where a bag has one room
    std::vector<float> safe_distance;   ///< free of facets (safe_distances.hpp), 0: not known  [m]

    /// Particles.
    [[nodiscard]] std::size_t size() const { return x.size(); }
    /// Room that particle i is in; 0 where the bag has one.
    [[nodiscard]] std::size_t room_of(std::size_t i) const {
        return room.empty() ? 0 : static_cast<std::size_t>(room[i]);
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(x, v, e, species, id, room);
        safe_distance.assign(x.size(), 0.0F);
    }

    /// Makes it n particles: the last ones go, or new ones come, whose x and v are not set.
    void resize(std::size_t n) {
        x.resize(n);
        v.resize(n);
        e.resize(n);
        species.resize(n);
        id.resize(n);
        safe_distance.resize(n);
        if (!room.empty()) room.resize(n);
    }
    /// Room for n in all: growing bit by bit would take up to twice the memory.
    void reserve(std::size_t n) {
        x.reserve(n);
        v.reserve(n);
        e.reserve(n);
        species.reserve(n);
        id.reserve(n);
        safe_distance.reserve(n);
    }
    /// Takes out rows, ascending; the order of the others stays.
    void erase(std::span<const std::size_t> rows) {
        if (rows.empty()) return;
        constexpr std::size_t ARRAYS = 7;
        parallel::for_each(
            ARRAYS,
            [&](std::size_t k) {
                if (k == 0) close_gaps(rows, x);
                if (k == 1) close_gaps(rows, v);
                if (k == 2) close_gaps(rows, e);
                if (k == 3) close_gaps(rows, species);
                if (k == 4) close_gaps(rows, id);
                if (k == 5) close_gaps(rows, safe_distance);
                if (k == 6 && !room.empty()) close_gaps(rows, room);
            },
            1);
        resize(size() - rows.size());
    }
    /// Appends one particle; its room, where there are several, is the caller's to append.
    /// @param at        [m]
    /// @param velocity  [m/s]
    /// @param internal  spin and vibration energy                                              [J]
    /// @param kind      row among the bag's species
    /// @param born      its id
    void add(const Vec3& at, const Vec3& velocity, double internal, std::int32_t kind,
             std::int32_t born) {
        x.push_back(at);
        v.push_back(velocity);
        e.push_back(internal);
        species.push_back(kind);
        id.push_back(born);
        safe_distance.push_back(0.0F);
    }

private:
    /// Moves what is behind each of the rows forward; as many at the end are left over.
    template <class Array>
    static void close_gaps(std::span<const std::size_t> rows, Array& all) {
        auto* to = all.data() + rows[0];
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const std::size_t next = k + 1 < rows.size() ? rows[k + 1] : all.size();
            to = std::copy(all.data() + rows[k] + 1, all.data() + next, to);
        }
    }
};

}  // namespace corpuscle::gas
