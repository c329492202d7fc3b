// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "fabric/lanes.hpp"
#include "fabric/materials/curved.hpp"
#include "fabric/materials/waiting_liner.hpp"

namespace corpuscle::fabric {

/// What TSRFAC and LNRC need to know of one point of LANES elements.
struct PointHistory {
    Strain<Lanes> start{};  ///< E_0: strain in tension at the start; TSRFAC only       [-]
    Lanes was_taut{};       ///< 1: the waiting liner has been taut here; LNRC only
};

/// The part of a strain along its extended principal directions.
template <class Real>
Strain<Real> tensile_part(const Strain<Real>& e) {
    const Real mean = 0.5 * (e.warp + e.weft), half = 0.5 * (e.warp - e.weft);
    const Real radius = square_root(half * half + 0.25 * e.shear * e.shear);
    const Real major = mean + radius, minor = mean - radius;
    // E+ = c·1 + d·deviator: (major, 0) between the signs, all or nothing elsewhere
    const auto all = minor >= Real{}, none = major <= Real{};
    const Real over = select(radius > Real{}, 0.5 * major / radius, Real{});
    const Real d = select(all, Real{} + 1.0, select(none, Real{}, over));
    const Real c = select(all, mean, select(none, Real{}, 0.5 * major));
    return {c + d * half, c - d * half, d * e.shear};
}

/// What a block keeps for each pack of a law that remembers; nothing for others.
template <class Law, std::size_t POINTS>
struct MemoryOf {
    struct Nothing {};
    using PerPack = Nothing;
};
template <Remembering Law, std::size_t POINTS>
struct MemoryOf<Law, POINTS> {
    using PerPack = std::array<typename Law::Memory, POINTS>;
};

/// A law at the points of one pack, where it depends on what they have been through: loops of
/// unloading, strains of the start that do not count yet, a liner that waits:
///
///     S = S_law(E - r·E_0) + S_liner(E - r·E_0),   r: what is left of E_0
template <class Law, class Shape, std::size_t POINTS>
struct AtPack {
    using Memories = typename MemoryOf<Law, POINTS>::PerPack;
    using Histories = std::array<PointHistory, POINTS>;

    const Law& law;
    const Shape& shape;
    PlaneModuli stiffness;  ///< of law and liner
    Memories* memories;
    Histories* histories;  ///< null: neither TSRFAC nor LNRC
    const std::optional<WaitingLiner>& liner;
    double left;           ///< r
    mutable Lanes lost{};  ///< by loops in this move                                  [J]
    mutable Lanes pull{};  ///< V·S:E_0                                                [J]

    [[nodiscard]] const PlaneModuli& moduli() const { return stiffness; }

    [[nodiscard]] Stress<Lanes> stress(int point, const Strain<Lanes>& e) const {
        const auto k = static_cast<std::size_t>(point);
        if (histories == nullptr) return by_law(point, e);
        PointHistory& history = (*histories)[k];
        const Strain<Lanes>& start = history.start;
        const Strain<Lanes> counts{e.warp - left * start.warp, e.weft - left * start.weft,
                                   e.shear - left * start.shear};
        Stress<Lanes> s = by_law(point, counts);
        if (liner) {
            const Stress<Lanes> l = liner->move(counts, history.was_taut);
            s = {s.warp + l.warp, s.weft + l.weft, s.shear + l.shear, s.energy + l.energy};
        }
        pull += shape.volume_at(point) *
                (s.warp * start.warp + s.weft * start.weft + s.shear * start.shear);
        return s;
    }

private:
    Stress<Lanes> by_law(int point, const Strain<Lanes>& e) const {
        if constexpr (Remembering<Law>) {
            Lanes density{};
            const Stress<Lanes> s =
                law.move(e, (*memories)[static_cast<std::size_t>(point)], density);
            lost += density * shape.volume_at(point);
            return s;
        } else {
            return law.stress(e);
        }
    }
};

}  // namespace corpuscle::fabric
