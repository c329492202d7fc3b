// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "contact/contact.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// Contacts of a step, filled by chunks of candidates in parallel and read in the candidates'
/// order.
class ContactList {
public:
    static constexpr std::size_t CHUNK = 2048;  ///< candidates; most are skipped

    void clear(std::size_t candidates) {
        used_ = parallel::chunk_count(candidates, CHUNK);
        if (chunk_.size() < used_) chunk_.resize(used_);
        for (auto& chunk : chunk_) chunk.clear();
    }
    [[nodiscard]] std::vector<Contact>& chunk(std::size_t c) { return chunk_[c]; }

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
    void for_each_apart(Body&& body) {
        parallel::for_chunks(
            used_,
            [&](std::size_t begin, std::size_t, std::size_t) {
                for (Contact& contact : chunk_[begin]) body(contact);
            },
            1);
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(chunk_, used_);
    }

private:
    std::vector<std::vector<Contact>> chunk_;
    std::size_t used_ = 0;
};

}  // namespace corpuscle::contact
