// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "contact/candidates/candidates.hpp"
#include "contact/response/column_colouring.hpp"
#include "contact/surface/contact_list.hpp"
#include "contact/surface/rigid_proxies.hpp"

namespace corpuscle::contact {

/// Looks at candidate pairs: which are near, which touch.
class NarrowPhase {
public:
    /// @param reach  gap below which pairs are kept, in contact thicknesses
    NarrowPhase(const Cloth& cloth, double reach) : cloth_(cloth), reach_(reach) {}

    struct Scene {
        const Points &x, &v;                  ///< N × 3                                  [m, m/s]
        double t;                             ///< [s]
        double dt;                            ///< looked ahead                                [s]
        std::span<const RigidProxy> bodies;   ///< by number
        std::span<const std::uint8_t> is_on;  ///< by card
        std::span<const double> most;         ///< contact thickness now, by card          [m]
    };
    /// Fills the list, which is empty.
    void find(const Scene& scene, const ColumnColouring& columns, Candidates& pairs,
              ContactList& contacts) const;

private:
    class Batch;
    struct Found {
        std::size_t row;
        Nearest places;
        double gap;  ///< [m]
    };
    struct RestGap {
        double now;   ///< [m]
        double rate;  ///< at which it grows                                               [m/s]
    };
    void take(const Found& found, const Scene& scene, const ColumnColouring& columns,
              Candidates& pairs, ContactList& contacts, std::size_t chunk) const;
    [[nodiscard]] RestGap rest_gap(double thickness, double t, PairMemory* memory) const;

    const Cloth& cloth_;
    double reach_;
};

}  // namespace corpuscle::contact
