// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/nearest_four.hpp"
#include "contact/response/exposure.hpp"

namespace corpuscle::contact {
namespace {

/// What the kick may add to an approach.
constexpr double MARGIN = 1.25;

}  // namespace

/// Rows that are due, whose nearest places are found four at a time, edges and others apart. What
/// they need lies far apart in memory: it is asked for well ahead.
class NarrowPhase::Batch {
public:
    [[nodiscard]] bool is_full() const { return count_ == found_.size(); }
    void add(std::size_t row, const Candidates& pairs) {
        pairs.prefetch(row);
        found_[count_++].row = row;
    }
    /// visit(found), in the order in which rows were added; then it is empty.
    template <class Visit>
    void finish(const Candidates& pairs, const Points& x, Visit&& visit) {
        for (std::size_t i = 0; i < count_; ++i) {
            pairs.prefetch_memory(found_[i].row);
            Kind& kind = kind_[pairs[found_[i].row].is_edges ? 1 : 0];
            kind.place[kind.count++] = i;
        }
        for (Kind& kind : kind_) {
            for (std::size_t begin = 0; begin < kind.count; begin += FOUR)
                find_four(kind, begin, pairs, x);
            kind.count = 0;
        }
        for (std::size_t i = 0; i < count_; ++i) visit(found_[i]);
        count_ = 0;
    }

private:
    static constexpr std::size_t MOST = 64;
    struct Kind {
        std::array<std::size_t, MOST> place;
        std::size_t count = 0;
    };

    /// The last of a kind fills up what is missing to four.
    void find_four(const Kind& kind, std::size_t begin, const Candidates& pairs, const Points& x) {
        const auto at = [&](std::size_t l) {
            return kind.place[std::min(begin + l, kind.count - 1)];
        };
        std::array<const Pair*, FOUR> four;
        for (std::size_t l = 0; l < FOUR; ++l) four[l] = &pairs[found_[at(l)].row];
        const NearestFour places = nearest(four, x);
        for (std::size_t l = 0; l < FOUR; ++l) {
            found_[at(l)].places = places[l];
            found_[at(l)].gap = places.gap[l];
        }
    }

    std::array<Found, MOST> found_;
    std::size_t count_ = 0;
    std::array<Kind, 2> kind_;
};

void NarrowPhase::find(const Scene& scene, const ColumnColouring& columns, Candidates& pairs,
                       ContactList& contacts) const {
    contacts.lay_out(pairs.size());
    const auto look = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        contacts.clear_chunk(chunk);
        Batch batch;
        const auto finish = [&] {
            batch.finish(pairs, scene.x, [&](const Found& found) {
                take(found, scene, columns, pairs, contacts, chunk);
            });
        };
        const auto add = [&](std::size_t i) {
            batch.add(i, pairs);
            if (batch.is_full()) finish();
        };
        pairs.for_each_due_ahead(begin, end, add);
        finish();
    };
    parallel::for_chunks(pairs.size(), look, ContactList::CHUNK);
}

void NarrowPhase::take(const Found& found, const Scene& scene, const ColumnColouring& columns,
                       Candidates& pairs, ContactList& contacts, std::size_t chunk) const {
    const auto& [row, places, gap] = found;
    const int card = pairs.card(row);
    if (!scene.is_on[card]) return;
    pairs.tell_distance(row, places.apart, gap, scene.x);
    if (!places.is_inside || gap == 0.0) return;
    const double thickness = std::min(pairs.thickness(row), scene.most[card]);
    if (gap >= reach_ * thickness) {
        const double approach = greatest_approach(pairs[row], corners(pairs[row], scene.v));
        if (gap - MARGIN * scene.dt * approach >= thickness) return;
    }
    PairMemory* const memory = pairs.memory(row);
    const RestGap rest = rest_gap(thickness, scene.t, memory);
    const double exposed =
        gap < rest.now ? exposure(cloth_, pairs.parts(row), scene.x, pairs[row], places, gap) : 0.0;
    const NearPair near{pairs[row], pairs.memory_row(row), card,  pairs.side(row), row, gap,
                        rest.now,   pairs.modulus(row),    places};
    if (exposed == 0.0) return contacts.near(chunk).push_back(near);
    const Contact touching = contact_at(cloth_, scene.bodies, scene.x, pairs[row], places, gap);
    Contact& contact = contacts.add(chunk, columns.of(touching, scene.x), touching, near);
    contact.exposure = exposed;
    contact.rest_rate = rest.rate;
    contact.thickness = thickness;
}

/// A pair that began nearer than its thickness starts with the gap that it had.
NarrowPhase::RestGap NarrowPhase::rest_gap(double thickness, double t, PairMemory* memory) const {
    if (memory == nullptr || memory->short_by == 0.0) return {thickness, 0.0};
    const double missing = memory->missing(t, cloth_.growth_time);
    if (missing < 1e-6 * thickness) {
        memory->short_by = 0.0;
        return {thickness, 0.0};
    }
    if (missing < thickness) return {thickness - missing, missing / cloth_.growth_time};
    return {0.0, 0.0};
}

}  // namespace corpuscle::contact
