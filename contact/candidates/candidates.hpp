// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/candidates/motion.hpp"
#include "contact/candidates/near_search.hpp"
#include "contact/candidates/verlet_list.hpp"
#include "contact/culling/patch_pairs.hpp"
#include "contact/geometry/distance.hpp"
#include "contact/surface/cloth.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// State of a pair from step to step.
struct PairMemory {
    std::uint64_t key;      ///< identifies the pair
    double short_by = 0.0;  ///< contact thickness less the gap it was first seen with         [m]
    double born = 0.0;      ///< time of that                                                  [s]
    double force = 0.0;     ///< normal, in its last step                                      [N]
    double area = 0.0;      ///< of the contact then                                         [m^2]
    double own_area = 0.0;  ///< of the lesser of its places then                          [m^2]
    double owed = 0.0;      ///< energy that it owes to the motion (implicit_response.hpp)      [J]
    Vec3 friction = Vec3::Zero();  ///< then, on the first place                               [N]
    std::uint32_t step = 0;        ///< that last step's number
    std::uint32_t area_until = 0;  ///< step from which on the area is out of date

    [[nodiscard]] bool is_empty() const { return short_by == 0.0 && area == 0.0; }
    /// What its rest gap lacks at t of the contact thickness.                                  [m]
    /// @param growth_time  in which all but 1/e of it comes                                    [s]
    [[nodiscard]] double missing(double t, double growth_time) const {
        return short_by * std::exp(-(t - born) / growth_time);
    }
};

/// Verlet lists of pairs that may come within reach.
///
/// Pairs of patches that cannot meet are rejected. For the others lists are built for a time ahead:
/// each node is predicted to keep its velocity, and may deviate from that by a budget. Lists are
/// valid until that time. A few nodes that are about to exceed their budget are predicted anew and
/// their pairs alone listed again; if many are, all lists are rebuilt.
/// Between builds a pair is tested only when the motion since could have brought it within reach: a
/// sum of two numbers decides.
class Candidates {
public:
    /// @param reach  gap below which pairs matter, in contact thicknesses
    Candidates(const Cloth& cloth, double reach);

    /// Lists all pairs at x, at the beginning; those nearer than their contact thickness are
    /// remembered with the gap that they have. Pairs of triangles that cross are left out, see
    /// crossing().
    void start(const Points& x, const Points& v, double t, double dt);

    /// Does the same once a card has begun to hold for a pair of parts (Rules::choose()): its pairs
    /// start with the gap that they have, or with the rest gap that they had by the card before. All
    /// others keep what they know.
    void admit(const Points& x, const Points& v, double t, double dt);

    /// Follows the cloth to x. The lists hold all pairs that can be within reach there, since the
    /// step that led to x was foreseen.
    /// @param dt  the step ahead                                                           [s]
    void follow(const Points& x, double t, double dt) {
        patches_.follow(x);
        motion_.follow(x, t, dt);
    }

    /// Makes sure that the lists hold all pairs that can meet in the step ahead, from x to x + dt
    /// v.
    void foresee(const Points& x, const Points& v, double t, double dt);

    /// Rows, among them some that are no pairs any more.
    [[nodiscard]] std::size_t size() const { return list_.size(); }
    [[nodiscard]] std::size_t pairs() const { return list_.size() - dead_; }
    [[nodiscard]] const Pair& operator[](std::size_t i) const { return list_[i].pair; }

    /// Has pair i, or what it remembers, brought near, to be read soon.
    void prefetch(std::size_t i) const { __builtin_prefetch(&list_[i]); }
    void prefetch_memory(std::size_t i) const { prefetch_memory_at(list_[i].memory); }

    /// Likewise a memory; of none nothing.
    void prefetch_memory_at(Index row) const {
        if (row < 0) return;
        __builtin_prefetch(&memories_[row]);
        __builtin_prefetch(&memories_[row].step);
    }

    /// Parts by which the two sides of pair i touch.
    [[nodiscard]] PartPair parts(std::size_t i) const { return parts_of(list_[i].key); }
    /// Row of the card by which pair i touches.
    [[nodiscard]] int card(std::size_t i) const { return list_[i].card; }

    /// 1: the first of pair i is on its card's SURFA, -1: the second is; 0: a single surface.
    [[nodiscard]] int side(std::size_t i) const { return list_[i].side; }

    /// Modulus of both sides through their thickness, one behind the other.                    [Pa]
    [[nodiscard]] double modulus(std::size_t i) const {
        const double a = cloth_.modulus[verlet_.first[i]], b = cloth_.modulus[verlet_.second[i]];
        return 2.0 * a * b / (a + b);
    }

    /// Gap below which pair i pushes, at most.                                                 [m]
    [[nodiscard]] double thickness(std::size_t i);

    /// visit(i) for the pairs in rows begin ... end - 1 that may be within reach now.
    template <class Visit>
    void for_each_due(std::size_t begin, std::size_t end, Visit&& visit) const {
        verlet_.for_each_within<true>(begin, end, motion_.age(), motion_.displacements(), visit);
    }

    /// Likewise those that may be within reach in the step ahead, if nodes go on as they did; after
    /// follow().
    template <class Visit>
    void for_each_due_ahead(std::size_t begin, std::size_t end, Visit&& visit) const {
        verlet_.for_each_within<true>(begin, end, motion_.age_ahead(),
                                      motion_.displacement_bounds(), visit);
    }

    /// Likewise those that may meet in the step that was foreseen last.
    template <class Visit>
    void for_each_meeting(std::size_t begin, std::size_t end, Visit&& visit) const {
        verlet_.for_each_within<false>(begin, end, motion_.age(), motion_.displacement_bounds(),
                                       visit);
    }

    /// Takes how far the sides of pair i are apart at the present x, as a vector and a distance.
    void tell_distance(std::size_t i, const Vec3& apart, double distance, const Points& x);

    /// What pair i remembers, or nothing.
    [[nodiscard]] PairMemory* memory(std::size_t i) {
        return list_[i].memory < 0 ? nullptr : &memories_[list_[i].memory];
    }
    /// Row of that, or -1; until the lists change.
    [[nodiscard]] Index memory_row(std::size_t i) const { return list_[i].memory; }
    [[nodiscard]] PairMemory& memory_at(Index row) { return memories_[row]; }
    PairMemory& make_memory(std::size_t i);
    /// Makes memories of pairs i_of(k), none of which has one, k in 0..n; theirs are the rows from
    /// the one that is returned on.
    template <class PairOf>
    Index make_memories(std::size_t n, PairOf&& i_of) {
        constexpr std::size_t A_CHUNK = 32;  // each is far from the one before
        const std::size_t first = memories_.size();
        memories_.resize(first + n);
        parallel::for_each(
            n,
            [&](std::size_t k) {
                list_[i_of(k)].memory = static_cast<Index>(first + k);
                memories_[first + k] = {list_[i_of(k)].key};
            },
            A_CHUNK);
        return static_cast<Index>(first);
    }

    /// Triangles that crossed at the start and still do, rows i < j, sorted. Their pairs do not
    /// push.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& crossing() const { return crossing_; }
    /// Pairs of triangles that had pairs nearer than their contact thickness when these became
    /// valid, rows i < j, sorted.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& close_starts() const {
        return close_starts_;
    }
    /// Triangles that are searched: those of all patches that may meet.
    [[nodiscard]] std::size_t searched() const { return patches_.pieces().triangles.size(); }
    [[nodiscard]] std::size_t builds() const { return builds_; }
    /// Times that the pairs of a few nodes were listed anew.
    [[nodiscard]] std::size_t renewals() const { return renewals_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(patches_, motion_, budget_, list_, verlet_, memories_, sorted_, crossing_,
                close_starts_, barred_, builds_, renewals_, dead_, node_box_, own_, search_);
    }

private:
    struct Candidate {
        Pair pair;
        Index memory;      ///< row in memories_, or -1
        double thickness;  ///< [m]
        std::uint64_t key;
        std::int16_t card, side;
        bool is_settled;  ///< thickness allows for neighbours on the cloth
    };
    struct Chunk {
        std::vector<Candidate> list;
        std::vector<VerletEntry> watch;
    };

    /// By what a pair's distance has shrunk at most since the lists were built, and more. [m]
    [[nodiscard]] double spent(std::size_t i) const {
        return verlet_.spent(i, motion_.age(), motion_.displacements());
    }
    void build(const Points& x, const Points& v, double t, double dt);
    void set_budget(double dt);
    void set_boxes(const Points& x);
    void set_node_box(Index node, const Vec3& from, double time);
    void list_pairs(const Points& x);
    void renew(const Points& x);
    void find_renewed_triangles();
    void drop_renewed_pairs();
    void list_renewed_pairs(const Points& x);
    void hand_on_memories(std::size_t first);
    std::size_t add_chunks(std::size_t rows, std::size_t count);
    struct Outlook {        ///< how far it is looked ahead
        const Points& now;  ///< where the nodes are                                        [m]
        double life;        ///< [s]
        bool is_build;      ///< nodes are where they are predicted, and memories are sorted
    };
    struct TrianglePair {  ///< of two triangles
        Index a, b;        ///< rows; the pair's first is of a
        Distances apart;
        const Outlook& ahead;
        Chunk& out;
    };
    static std::uint64_t key_of(bool is_edges, Index first, Index second) {
        return static_cast<std::uint64_t>(is_edges) << 63 |
               static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second);
    }
    void meet_edges(Feature a, Feature b, Distances apart, const Outlook& ahead, Chunk& out) const;
    void meet_node(Feature n, Index triangle, Distances apart, const Outlook& ahead,
                   Chunk& out) const;
    [[nodiscard]] PartPair parts_of(std::uint64_t key) const;
    void list(const Pair& pair, std::uint64_t key, const TrianglePair& where) const;
    [[nodiscard]] double closing_rate(const Pair& pair, const Vec3& apart, double gap,
                                      const Points& x, double time) const;
    [[nodiscard]] double neighbours_thickness(const Pair& pair) const;
    void bar_all_crossing(const Points& x);
    void bar_crossing_pairs(const Points& x);
    void sort_memories();
    void forget_parted_pairs();
    [[nodiscard]] Index find_memory(std::uint64_t key) const;
    void give_gentle_gaps(const std::vector<std::uint64_t>& keys, const Points& x, double t);
    bool give_gentle_gap(std::size_t i, const Points& x, double t, int card_before = Rules::NONE);
    void meet_gently(const Points& x, double t);

    /// Budget of the nodes' deviation while the lists are valid.
    struct Budget {
        double stray = 0.0;  ///< at which they are                                       [m]
        double steps = 4.0;  ///< that they are meant to live
        double life = 0.0;   ///< age at which they are                                   [s]

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(stray, steps, life);
        }
    };
    /// What is listed anew between builds.
    struct Renewal {
        std::vector<Index> strayed, renewed;   ///< nodes, triangles, ascending
        std::vector<std::uint8_t> is_renewed;  ///< by triangle
        std::vector<std::pair<std::uint64_t, Index>> handed_on,
            sorting;  ///< key and memory of dropped pairs
        parallel::Gathered<std::pair<std::uint64_t, Index>> dropped;
        std::vector<Index> known;  ///< by pair listed anew: row there, or -1
        Points predicted;          ///< N × 3                [m]
    };

    /// Of memories, those in order and those made since: kept for its memory.
    struct Merging {
        std::vector<std::size_t> kept;  ///< rows of those in order that say something
        parallel::Gathered<std::size_t> found;
        std::vector<PairMemory> merged;
        std::vector<std::uint64_t> keys;  ///< of all, at the last build
    };

    const Cloth& cloth_;
    double reach_;
    PatchPairs patches_;
    Motion motion_;
    NearSearch search_;
    Budget budget_;
    std::vector<Box> node_box_;  ///< of what they may reach                               [m]
    std::vector<double> own_;    ///< by node: its part of the budget                      [m]
    Points late_;                ///< N × 3                                                [m]
    std::vector<Candidate> list_;
    VerletList verlet_;
    std::vector<Chunk> chunks_;
    std::vector<PairMemory> memories_;
    Merging merging_;
    std::size_t sorted_ = 0;             ///< memories that are in the order of their keys
    std::vector<std::uint8_t> is_used_;  ///< by memory
    std::vector<std::pair<Index, Index>> crossing_, close_starts_;
    std::vector<std::uint64_t> barred_;  ///< pairs of crossing triangles, ascending
    std::size_t builds_ = 0, renewals_ = 0;

    Renewal renewal_;
    std::size_t dead_ = 0;  ///< rows of dropped pairs
};

}  // namespace corpuscle::contact
