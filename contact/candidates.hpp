// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/cloth.hpp"
#include "contact/distance.hpp"
#include "contact/motion.hpp"
#include "contact/triangle_pairs.hpp"

namespace corpuscle::contact {

/// What a pair remembers while it is near.
struct PairMemory {
    int side = 0;  ///< node-triangle: side of the triangle that the node is on; 0: beside it
    Vec3 normal = Vec3::Zero();  ///< edge-edge: from the second edge to the first; zero: not known
    double account = 0.0;        ///< energy that it has taken and not given back             [J]
    double short_by = 0.0;       ///< contact thickness less the gap it was first seen with    [m]
    double born = 0.0;           ///< when that was                                            [s]
};

/// A node and a triangle, or two edges, that may touch before the lists are built anew.
struct Candidate {
    std::array<Index, 4> node;  ///< node, triangle's three; or first edge's two, second edge's two
    bool is_edges;
    double thickness;   ///< gap below which they push                               [m]
    std::uint64_t key;  ///< names the pair
    PairMemory memory;
};

/// Nearest distance, both ends of an edge included.                                            [m]
[[nodiscard]] double distance(const Candidate& pair, const Points& x);

/// Pairs that are near enough to be looked at.
///
/// Lists are built from FCL's patch pairs with a budget of motion for each patch, and live until a
/// patch has spent its own. Between builds a pair is looked at only when the motion since could
/// have brought it within reach: a sum of two numbers tells.
class Candidates {
public:
    /// @param reach  gap below which pairs matter, in contact thicknesses
    Candidates(const Cloth& cloth, double reach);

    /// Lists all pairs at x. Pairs in triangles that cross are left out, see crossing().
    void start(const Points& x, const Points& v, double t, double dt);

    /// Follows the cloth to x; builds the lists anew when it has to.
    void follow(const Points& x, double t);

    [[nodiscard]] std::size_t size() const { return list_.size(); }
    [[nodiscard]] Candidate& operator[](std::size_t i) { return list_[i]; }
    [[nodiscard]] const Candidate& operator[](std::size_t i) const { return list_[i]; }

    /// Whether pair i may come within reach in the step ahead.
    [[nodiscard]] bool is_due(std::size_t i) const {
        const Watch& w = watch_[i];
        return motion_.way(w.first) + motion_.way(w.second) + step_ahead(w) >= w.due;
    }
    /// Gap below which pair i may touch in the step ahead.                                     [m]
    [[nodiscard]] double range(std::size_t i) const {
        return reach_ * list_[i].thickness + step_ahead(watch_[i]);
    }
    /// Takes the distance of pair i at the present x.
    void tell_distance(std::size_t i, double distance) {
        Watch& w = watch_[i];
        w.due =
            motion_.way(w.first) + motion_.way(w.second) + distance - reach_ * list_[i].thickness;
    }

    /// Triangles that crossed at the start and still do, rows i < j, sorted. Their pairs do not
    /// push.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& crossing() const { return crossing_; }
    [[nodiscard]] std::size_t builds() const { return builds_; }

private:
    struct Watch {
        double due;           ///< sum of the patches' ways at which the pair is looked at      [m]
        Index first, second;  ///< patches
    };
    using Pairs = std::vector<std::pair<Index, Index>>;

    [[nodiscard]] double step_ahead(const Watch& w) const {
        return GROWTH * (motion_.step(w.first) + motion_.step(w.second));
    }
    static constexpr double GROWTH =
        1.5;  ///< the step ahead may be so much longer than the last one

    void build(const Points& x, double t);
    [[nodiscard]] bool are_spent() const;
    void set_budgets();
    void list_pairs(const Points& x);
    void list_pairs_of(Index a, Index b, const Points& x, std::vector<Candidate>& list,
                       std::vector<Watch>& watch) const;
    void consider(Candidate pair, Index a, Index b, const Points& x, std::vector<Candidate>& list,
                  std::vector<Watch>& watch) const;
    [[nodiscard]] Box grown(const Box& box, Index patch) const {
        return {box.low + growth_[patch].low, box.high + growth_[patch].high};
    }
    [[nodiscard]] double neighbours_thickness(const Candidate& pair) const;
    [[nodiscard]] bool is_barred(std::uint64_t key) const;
    void bar_crossing_pairs();
    void give_gentle_gaps(const std::vector<std::uint64_t>& keys, const Points& x, double t);
    void remember(std::vector<Candidate> old);

    const Cloth& cloth_;
    double reach_;
    Motion motion_;
    TrianglePairs near_triangles_;
    std::vector<Box> boxes_;
    std::vector<double> budget_;  ///< by patch: stray at which the lists are spent           [m]
    double most_budget_;          ///< [m]
    double life_ = 0.0;           ///< age at which they are                                  [s]
    std::vector<Box> growth_;     ///< by patch: what is added to the box of anything in it   [m]
    std::vector<Candidate> list_;
    std::vector<Watch> watch_;
    std::vector<std::vector<Candidate>> chunk_list_;
    std::vector<std::vector<Watch>> chunk_watch_;
    Pairs crossing_;
    std::vector<std::uint64_t> barred_;  ///< pairs of crossing triangles, ascending
    std::size_t builds_ = 0;
};

}  // namespace corpuscle::contact
