// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/geometry/distance.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// Two places of the cloth, or of rigid bodies, that are near each other: gap = |sum of weight x|,
/// rate = normal · sum of weight v. The weights add up to zero, so forces along them keep momentum.
struct Contact {
    static constexpr std::uint16_t ALONE = 320;  ///< `column` of a contact outside of all columns

    std::array<Index, 4> node;     ///< rows: a node and a triangle's three, or two edges'
    std::array<double, 4> weight;  ///< of x: > 0 on the first place, < 0 on the second
    Vec3 normal;                   ///< from the second place to the first, unit
    double gap;                    ///< between the two places  [m]
    double mass;    ///< 1 / (what an impulse of one makes of the rate)             [kg]
    bool is_edges;  ///< two edges, else a node and a triangle
    std::uint16_t column = ALONE;  ///< name of its column (contact/response/column_colouring.hpp)
    bool on_body = false;          ///< on a rigid body that may move: `mass` is along the normal
    int card = 0;                  ///< row of the card by which they touch
    int side = 0;       ///< 1: the first place is on SURFA, -1: the second is; 0: a single surface
    double rest = 0.0;  ///< gap below which it pushes                                  [m]
    double rest_rate = 0.0;  ///< growth of `rest`                                           [m/s]
    double stiffness = 0.0;  ///< of the pair, normal to it  [N/m]
    double thickness = 0.0;  ///< of contact, at full                                        [m]
    double modulus = 0.0;    ///< through the thickness                                     [Pa]
    double area = 0.0;       ///< that it stands for                                       [m^2]
    double own_area = 0.0;   ///< of the lesser of its places                              [m^2]
    double exposure = 1.0;   ///< how far its places face each other                        [-]
    std::uint32_t area_until = 0;  ///< step from which on its area is out of date
    double owed = 0.0;             ///< energy that it owes to the motion                        [J]
    double force = 0.0;    ///< normal, >= 0                                              [N]
    double impulse = 0.0;  ///< likewise, of the step                                     [N s]
    Vec3 rubbed = Vec3::Zero();  ///< by friction, on the first place                          [N s]
    std::size_t pair = 0;        ///< candidate row
    Index memory = -1;           ///< row of what the pair remembers, or -1; until lists change

    /// Velocity of the first place against the second; v by node row.                       [m/s]
    [[nodiscard]] Vec3 relative(const Points& v) const {
        return weight[0] * v[node[0]] + weight[1] * v[node[1]] + weight[2] * v[node[2]] +
               weight[3] * v[node[3]];
    }
    /// Of the gap: the same along the normal, > 0 as it opens.                              [m/s]
    [[nodiscard]] double rate(const Points& v) const { return normal.dot(relative(v)); }
};

/// A pair within reach that does not push, with what a Contact has of its candidate: its gap is
/// rest or more, or the cloth beside its places is nearer (exposure 0).
struct NearPair {
    Pair nodes;        ///< rows
    Index memory;      ///< row, or -1
    int card;          ///< row, as in Contact
    int side;          ///< as in Contact
    std::size_t pair;  ///< candidate row
    double gap;        ///< [m]
    double rest;       ///< [m]
    double modulus;    ///< [Pa]
    Nearest places;    ///< nearest points of the two
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
    /// Empties a chunk.
    void clear_chunk(std::size_t c) {
        chunk_[c].clear();
        near_[c].clear();
        columns_[c].clear();
    }
    /// In use.
    [[nodiscard]] std::size_t chunks() const { return used_; }

    /// That push; and pairs that were only near when found, and then came too near too fast.
    [[nodiscard]] std::vector<Contact>& chunk(std::size_t c) { return chunk_[c]; }
    /// The same.
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
    /// The same.
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
