// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <tuple>

#include "fabric/element_frequency.hpp"
#include "fabric/element_pack.hpp"
#include "fabric/elements/frequency_bound.hpp"
#include "fabric/materials/stretch.hpp"
#include "fabric/membrane_block.hpp"
#include "fabric/point_history.hpp"

namespace corpuscle::fabric {

/// The loop over a block; it knows no mechanics. The law is settled at construction.
template <template <class> class Element, class Law>
class BlockOf final : public MembraneBlock {
public:
    static constexpr int CORNERS = Element<Lanes>::CORNERS;
    static constexpr std::size_t POINTS = Element<Lanes>::POINTS;
    static constexpr std::size_t STRIDE = 3 * LANES * CORNERS;  ///< corner forces of a pack
    static constexpr bool HAS_PAST = Remembering<Law>;
    static constexpr bool IS_SHARP = KnowsBound<Element<Lanes>> && !StiffensBeyond<Law>;

    template <class Make>
    BlockOf(const BlockInput& in, const Law& law, const Make& make)
        : law_(law),
          liner_(in.law.liner),
          moduli_(liner_ ? law.moduli() + liner_->moduli() : law.moduli()),
          packs_((in.shells.size() + LANES - 1) / LANES) {
        part = in.part;
        corners = CORNERS;
        is_damped = in.law.damping > 0.0;
        shells = in.shells;
        mass.resize(size() * CORNERS);
        stiffness.resize(size());
        damping_time_.resize(packs_.size() * LANES, 0.0);
        if constexpr (Remembering<Law>) memory_.resize(packs_.size());
        if (IS_SHARP && in.law.damping >= CALM) mobility_.resize(packs_.size());
        for (std::size_t e = 0; e < packs_.size() * LANES; ++e)
            place(in, e, make(in.shapes[std::min(e, size() - 1)], in.thickness));
        if (liner_ || in.law.restoration.any()) history_.resize(packs_.size());
        if (in.law.restoration.any() && !in.start.empty()) note_start(in.start);
    }

    Result force(std::size_t begin, std::size_t end, const Points& x, const Points& v,
                 double* elastic, double* damping) override {
        return is_damped ? pass<true>(begin, end, x, v, elastic, damping)
                         : pass<false>(begin, end, x, v, elastic, damping);
    }

    Index first_broken(const Points& x, const double* elastic,
                       const double* damping) const override {
        Index first = -1;
        for (std::size_t e = 0; e < size(); ++e) {
            const std::size_t p = e / LANES, lane = e % LANES;
            const Element<Lanes>& shape = packs_[p].shape;
            const auto motion = shape.motion(corners_of(x.data()->data(), packs_[p].nodes));
            Lanes stored;
            recall(p, motion, shape.strain(motion), stored);
            bool is_finite = std::isfinite(stored[lane]);
            for (std::size_t k = 0; k < 3 * CORNERS; ++k) {
                const std::size_t at = p * STRIDE + k * LANES + lane;
                is_finite &=
                    std::isfinite(elastic[at]) && (!is_damped || std::isfinite(damping[at]));
            }
            if (!is_finite && (first < 0 || shells[e] < first)) first = shells[e];
        }
        return first;
    }

    void stress_strain(const Points& x, std::span<std::array<float, 3>> stress,
                       std::span<std::array<float, 3>> strain) const override {
        for (std::size_t p = 0; p < packs_.size(); ++p) {
            const Element<Lanes>& shape = packs_[p].shape;
            const auto motion = shape.motion(corners_of(x.data()->data(), packs_[p].nodes));
            Strain<Lanes> e{};
            Stress<Lanes> s{};
            const auto strains = shape.strain(motion);
            for (std::size_t k = 0; k < POINTS; ++k) {
                const Strain<Lanes>& at = strains[k];
                const Stress<Lanes> here = recalled(p, k, at);
                e = {e.warp + at.warp, e.weft + at.weft, e.shear + at.shear};
                s = {s.warp + here.warp, s.weft + here.weft, s.shear + here.shear, s.energy};
            }
            for (std::size_t l = 0; l < LANES && p * LANES + l < size(); ++l)
                store_means(l, e, s, POINTS, stress[row(p, l)], strain[row(p, l)]);
        }
    }

    Index node(std::size_t element, int corner) const override {
        return packs_[element / LANES].nodes[static_cast<std::size_t>(corner)][element % LANES];
    }
    double rate(std::size_t element) const override {
        return packs_[element / LANES].rate[element % LANES];
    }
    void set_rate(std::size_t element, double rate) override {
        packs_[element / LANES].rate[element % LANES] = rate;
    }
    double damping_time(std::size_t element) const override { return damping_time_[element]; }

    void take_masses() override {
        if constexpr (IS_SHARP) {
            for (std::size_t p = 0; p < mobility_.size(); ++p)
                mobility_[p] = corner_mobility(packs_[p].shape, per_mass<CORNERS>(mass, p));
        }
    }

    void visit_past(const PastVisitor& visit) override {
        visit(std::as_writable_bytes(std::span(memory_)));
        visit(std::as_writable_bytes(std::span(history_)));
    }
    void inherit(const MembraneBlock& from, const std::vector<std::uint8_t>& is_new) override {
        const auto& other = dynamic_cast<const BlockOf&>(from);
        assert(other.shells == shells);
        for (std::size_t e = 0; e < size(); ++e) {
            if (is_new[static_cast<std::size_t>(shells[e])]) continue;
            const std::size_t p = e / LANES, lane = e % LANES;
            for (std::size_t k = 0; k < POINTS; ++k) {
                if constexpr (HAS_PAST) memory_[p][k].lanes[lane] = other.memory_[p][k].lanes[lane];
                if (!history_.empty())
                    history_[p][k].was_taut[lane] = other.history_[p][k].was_taut[lane];
            }
        }
    }

private:
    std::size_t row(std::size_t pack, std::size_t lane) const {
        return static_cast<std::size_t>(shells[pack * LANES + lane]);
    }

    void place(const BlockInput& in, std::size_t e, Element<double> one) {
        Pack<Element>& pack = packs_[e / LANES];
        const std::size_t lane = e % LANES, source = std::min(e, size() - 1);
        for (std::size_t c = 0; c < CORNERS; ++c) pack.nodes[c][lane] = in.nodes[source][c];
        if (e < size()) {
            const ReferenceShape& shape = in.shapes[e];
            double* corner = mass.data() + e * CORNERS;
            std::fill_n(corner, CORNERS, in.law.density * in.thickness * shape.area / CORNERS);
            stiffness[e] = rest_stiffness(one, shape, moduli_);
            const double frequency = highest_frequency_squared(stiffness[e], corner);
            damping_time_[e] = 2.0 * in.law.damping / std::sqrt(frequency);
            pack.rate[lane] = step_rate(frequency, damping_time_[e]);
        } else {
            one.empty();
            pack.rate[lane] = 0.0;
        }
        pack.set(static_cast<int>(lane), one);
    }

    /// Flattened: with so many laws in one file the compiler would call what must be inline.
    template <bool DAMPED>
    [[gnu::flatten]] Result pass(std::size_t begin, std::size_t end, const Points& x,
                                 const Points& v, double* elastic, double* damping) {
        Lanes energy{}, rate = Lanes{} + rest_rate, pack_of{}, lost{}, pull{};
        for (std::size_t p = begin; p < end; ++p) {
            const Pack<Element>& pack = packs_[p];
            const auto motion = pack.shape.motion(corners_of(x.data()->data(), pack.nodes));
            const auto strain = pack.shape.strain(motion);
            Lanes stored;
            const auto load = respond(p, motion, strain, stored, lost, pull);
            store_corners(elastic + p * STRIDE, pack.shape.spread(motion, load, Lanes{} + 1.0));
            energy += stored;
            if constexpr (DAMPED) damp(p, motion, v, damping);

            Lanes now = pack.rate * stiffening(strain);
            if (!mobility_.empty() && any(now > rate)) now = sharpened(p, motion, load, now);
            pack_of = select(now > rate, Lanes{} + static_cast<double>(p), pack_of);
            rate = greater(now, rate);
        }
        Result out = summary(energy, rate, pack_of);
        if constexpr (Remembering<Law>) out.lost = sum_of(lost);
        if (!history_.empty()) out.pull = sum_of(pull);
        return out;
    }

    using At = AtPack<Law, Element<Lanes>, POINTS>;

    /// Load of a pack; what depends on its past moves on.
    auto respond(std::size_t p, const auto& motion, const auto& strain, Lanes& stored, Lanes& lost,
                 Lanes& pull) {
        const Element<Lanes>& shape = packs_[p].shape;
        if (!HAS_PAST && history_.empty()) return shape.elastic(law_, motion, strain, stored);
        const At law{law_,
                     shape,
                     moduli_,
                     memory_.empty() ? nullptr : &memory_[p],
                     history_.empty() ? nullptr : &history_[p],
                     liner_,
                     strain_left};
        const auto load = shape.elastic(law, motion, strain, stored);
        lost += law.lost;
        pull += law.pull;
        return load;
    }

    /// The energy alone, from what is remembered; nothing moves on.
    void recall(std::size_t p, const auto& motion, const auto& strain, Lanes& stored) const {
        Past past(*this, p);
        packs_[p].shape.elastic(past.law(*this, p), motion, strain, stored);
    }
    Stress<Lanes> recalled(std::size_t p, std::size_t k, const Strain<Lanes>& e) const {
        Past past(*this, p);
        return past.law(*this, p).stress(static_cast<int>(k), e);
    }

    /// A copy of what one pack remembers, to look without moving on.
    struct Past {
        std::vector<typename At::Memories> memory;
        std::vector<typename At::Histories> history;

        Past(const BlockOf& block, std::size_t p) {
            if (!block.memory_.empty()) memory.push_back(block.memory_[p]);
            if (!block.history_.empty()) history.push_back(block.history_[p]);
        }
        At law(const BlockOf& block, std::size_t p) {
            return {block.law_,
                    block.packs_[p].shape,
                    block.moduli_,
                    memory.empty() ? nullptr : memory.data(),
                    history.empty() ? nullptr : history.data(),
                    block.liner_,
                    block.strain_left};
        }
    };

    /// E_0 of every point: the strain in tension that the start's places bring.
    void note_start(std::span<const Vec3> start) {
        for (std::size_t p = 0; p < packs_.size(); ++p) {
            const Element<Lanes>& shape = packs_[p].shape;
            const auto strain =
                shape.strain(shape.motion(corners_of(start.data()->data(), packs_[p].nodes)));
            for (std::size_t k = 0; k < POINTS; ++k) history_[p][k].start = tensile_part(strain[k]);
        }
    }

    void damp(std::size_t p, const auto& motion, const Points& v, double* damping) const {
        const Pack<Element>& pack = packs_[p];
        const auto rate = pack.shape.motion(corners_of(v.data()->data(), pack.nodes));
        const auto load = pack.shape.viscous(moduli_, motion, rate);
        const Lanes time = load_lanes(damping_time_.data() + p * LANES);
        store_corners(damping + p * STRIDE, pack.shape.spread(motion, load, time));
    }

    /// How much (2/dt)² may have grown since rest: the most of all points.
    Lanes stiffening(const auto& strain) const {
        Lanes most{};
        for (const Strain<Lanes>& e : strain) {
            if constexpr (StiffensBeyond<Law>) {
                most = greater(most, law_.stiffening(e));
                if (!liner_) continue;
            }
            most = greater(most, stretch_stiffening(e, moduli_));
        }
        return most;
    }

    /// The lesser of (2/dt)² as stretch alone bounds it and as the element does.
    [[gnu::noinline]] Lanes sharpened(std::size_t p, const auto& motion, const auto& load,
                                      const Lanes& by_stretch) const {
        if constexpr (!IS_SHARP) {
            return by_stretch;
        } else {
            const Lanes square =
                packs_[p].shape.frequency_bound(moduli_, motion, load, mobility_[p]);
            const Lanes bound = step_rate(square, load_lanes(damping_time_.data() + p * LANES));
            return select(bound < by_stretch, bound, by_stretch);
        }
    }

    Result summary(const Lanes& energy, const Lanes& rate, const Lanes& pack_of) const {
        Result out;
        for (std::size_t l = 0; l < LANES; ++l) {
            out.energy += energy[l];
            if (rate[l] <= rest_rate || rate[l] < out.rate) continue;
            const Index shell = shells[static_cast<std::size_t>(pack_of[l]) * LANES + l];
            if (rate[l] > out.rate || shell < out.shell) out.shell = shell;
            out.rate = rate[l];
        }
        return out;
    }

    Law law_;
    std::optional<WaitingLiner> liner_;
    PlaneModuli moduli_;  ///< of law and liner
    std::vector<Pack<Element>> packs_;
    std::vector<CornerMobility<Lanes>> mobility_;  ///< empty: stretch alone bounds the step
    std::vector<double> damping_time_;             ///< β, for every lane                     [s]
    std::vector<typename MemoryOf<Law, POINTS>::PerPack> memory_;  ///< empty: nothing to remember
    std::vector<std::array<PointHistory, POINTS>> history_;  ///< empty: neither TSRFAC nor LNRC
};

}  // namespace corpuscle::fabric
