// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/surface/contact.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// A pair within reach that does not push, with what a Contact has of its candidate: its gap is
/// rest or more, or the cloth beside its places is nearer (exposure 0).
struct NearPair {
    Pair nodes;
    Index memory;  ///< row, or -1
    int card, side;
    std::size_t pair;  ///< candidate row
    double gap, rest;  ///< [m]
    double modulus;    ///< [Pa]
    Nearest places;
};

/// Contacts of a step, filled by chunks of candidates in parallel and read in the candidates'
/// order.
class ContactList {
public:
    static constexpr std::size_t CHUNK = 256;  ///< candidates; most are skipped, or none

    /// Room for what so many candidates have, each chunk of which is yet to be cleared.
    void lay_out(std::size_t candidates) {
        used_ = parallel::chunk_count(candidates, CHUNK);
        if (chunk_.size() < used_) {
            chunk_.resize(used_);
            near_.resize(used_);
            briefs_.resize(used_);
        }
        for (std::size_t c = used_; c < chunk_.size(); ++c) clear_chunk(c);
    }
    void clear_chunk(std::size_t c) {
        chunk_[c].clear();
        near_[c].clear();
        briefs_[c].clear();
    }
    void clear(std::size_t candidates) {
        lay_out(candidates);
        for (std::size_t c = 0; c < used_; ++c) clear_chunk(c);
    }
    [[nodiscard]] std::size_t chunks() const { return used_; }

    /// That push; and pairs that were only near when found, and then came too near too fast.
    [[nodiscard]] std::vector<Contact>& chunk(std::size_t c) { return chunk_[c]; }
    [[nodiscard]] const std::vector<Contact>& chunk(std::size_t c) const { return chunk_[c]; }
    /// Adds one to a chunk, of this column.
    Contact& add(std::size_t c, std::uint16_t column, const Contact& contact) {
        briefs_[c].push_back({contact.node, column});
        Contact& added = chunk_[c].emplace_back(contact);
        added.column = column;
        return added;
    }
    /// What is read of all contacts of a chunk, and seldom anything else.
    struct Brief {
        std::array<Index, 4> node;
        std::uint16_t column;
    };
    [[nodiscard]] const std::vector<Brief>& briefs(std::size_t c) const { return briefs_[c]; }
    /// The others within reach.
    [[nodiscard]] std::vector<NearPair>& near(std::size_t c) { return near_[c]; }
    [[nodiscard]] const std::vector<NearPair>& near(std::size_t c) const { return near_[c]; }

    /// body(contact), one after the other, always in the same order.
    template <class Body>
    void for_each(Body&& body) {
        for (std::size_t c = 0; c < used_; ++c)
            for (Contact& contact : chunk_[c]) body(contact);
    }
    template <class Body>
    void for_each(Body&& body) const {
        for (std::size_t c = 0; c < used_; ++c)
            for (const Contact& contact : chunk_[c]) body(contact);
    }
    /// body(contact), in parallel.
    template <class Body>
    void for_each_apart(Body&& body, parallel::Cut::Where where = parallel::Cut::Where::current()) {
        const auto over_chunk = [&](std::size_t c) {
            for (Contact& contact : chunk_[c]) body(contact);
        };
        for_each_chunk(over_chunk, where);
    }
    /// body(chunk), in parallel.
    template <class Body>
    void for_each_chunk(Body&& body,
                        parallel::Cut::Where where = parallel::Cut::Where::current()) const {
        parallel::for_each(used_, body, parallel::Cut(1, where));
    }
    /// Sum of term(contact), by chunks in parallel, then theirs in their order.
    template <class Term>
    [[nodiscard]] double sum(Term&& term,
                             parallel::Cut::Where where = parallel::Cut::Where::current()) const {
        const auto chunk_sum = [&](std::size_t c) {
            double s = 0.0;
            for (const Contact& contact : chunk_[c]) s += term(contact);
            return s;
        };
        return parallel::sum(used_, 0.0, chunk_sum, parallel::Cut(1, where));
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(chunk_, near_, briefs_, used_);
    }

private:
    std::vector<std::vector<Contact>> chunk_;
    std::vector<std::vector<NearPair>> near_;
    std::vector<std::vector<Brief>> briefs_;
    std::size_t used_ = 0;
};

}  // namespace corpuscle::contact
