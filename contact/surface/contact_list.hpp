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
            columns_.resize(used_);
        }
        for (std::size_t c = used_; c < chunk_.size(); ++c) clear_chunk(c);
    }
    void clear_chunk(std::size_t c) {
        chunk_[c].clear();
        near_[c].clear();
        columns_[c].clear();
    }
    [[nodiscard]] std::size_t chunks() const { return used_; }

    /// That push; and pairs that were only near when found, and then came too near too fast.
    [[nodiscard]] std::vector<Contact>& chunk(std::size_t c) { return chunk_[c]; }
    [[nodiscard]] const std::vector<Contact>& chunk(std::size_t c) const { return chunk_[c]; }
    /// Adds one to a chunk, of this column and this pair.
    Contact& add(std::size_t c, std::uint16_t column, const Contact& contact, const NearPair& of) {
        columns_[c].push_back(column);
        Contact& added = chunk_[c].emplace_back(contact);
        added.column = column;
        added.pair = of.pair;
        added.memory = of.memory;
        added.card = of.card;
        added.side = of.side;
        added.rest = added.thickness = of.rest;
        added.modulus = of.modulus;
        return added;
    }
    /// Columns of the contacts of a chunk: all that sorting reads of them.
    [[nodiscard]] const auto& columns(std::size_t c) const { return columns_[c]; }
    /// The others within reach.
    [[nodiscard]] std::vector<NearPair>& near(std::size_t c) { return near_[c]; }
    [[nodiscard]] const std::vector<NearPair>& near(std::size_t c) const { return near_[c]; }

    /// body(contact), one after the other, always in the same order.
    template <class Body>
    void for_each(Body&& body) const {
        for (std::size_t c = 0; c < used_; ++c)
            for (const Contact& contact : chunk_[c]) body(contact);
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
        archive(chunk_, near_, columns_, used_);
    }

private:
    std::vector<std::vector<Contact>> chunk_;
    std::vector<std::vector<NearPair>> near_;
    std::vector<std::vector<std::uint16_t>> columns_;
    std::size_t used_ = 0;
};

}  // namespace corpuscle::contact
