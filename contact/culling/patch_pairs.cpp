// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/patch_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr Index SEVERAL = -1;
constexpr std::size_t PATCHES_A_CHUNK = 16;
constexpr std::size_t ASKING = 4;   ///< patches a chunk that ask the tree
constexpr int MOST_LOOKS = 6;       ///< for a plane between two patches
constexpr double LEAST_ROOM = 0.5;  ///< in edge lengths: where cloth rests, a node may dash off

/// What `of(triangle)` is for all triangles of a patch, or SEVERAL.
template <class Of>
Index common_of(std::span<const Index> triangles, Of&& of) {
    const Index first = of(triangles.front());
    const auto is_other = [&](Index t) { return of(t) != first; };
    return std::any_of(triangles.begin(), triangles.end(), is_other) ? SEVERAL : first;
}

/// The greatest margin of each patch's triangles.                                           [m]
std::vector<double> by_patch(const Cloth& cloth, std::span<const double> margin) {
    std::vector<double> greatest(cloth.patches.size(), 0.0);
    for (std::size_t p = 0; p < greatest.size(); ++p)
        for (const Index t : cloth.patches[p]) greatest[p] = std::max(greatest[p], margin[t]);
    return greatest;
}

}  // namespace

PatchPairs::PatchPairs(const Cloth& cloth, std::span<const double> margin)
    : cloth_(cloth),
      motion_(cloth),
      margin_(by_patch(cloth, margin)),
      room_(margin_.size(), 0.0),
      regions_(cloth, margin_),
      box_(margin_.size()),
      middle_(margin_.size()) {
    const auto body_of = [&](Index t) {
        const auto& [a, b, c] = cloth.triangles[t];
        const Index body = cloth.body[a];
        return body == cloth.body[b] && body == cloth.body[c] ? body : SEVERAL;
    };
    for (std::size_t p = 0; p < margin_.size(); ++p) {
        const auto triangles = cloth.patches[p];
        const auto part_of = [&](Index t) {
            return cloth.is_on_border(t) ? SEVERAL : cloth.part[t];
        };
        part_.push_back(common_of(triangles, part_of));
        body_.push_back(common_of(triangles, body_of));
    }
}

bool PatchPairs::holds(const Points& x) {
    for (std::size_t i = 0; i < room_.size(); ++i) {
        const auto p = static_cast<Index>(i);
        const auto is_over = [&] { return motion_.gone(p) + motion_.ahead(p) > room_[p]; };
        if (!is_over()) continue;
        motion_.measure(p, x);
        if (is_over()) return false;
    }
    return regions_.hold(x, motion_);
}

void PatchPairs::find(const Points& x, double steps) {
    motion_.mark(x);
    regions_.find(x, motion_);
    const auto bound = [&](std::size_t p) {
        const double ahead = motion_.ahead(static_cast<Index>(p));
        room_[p] = std::max(steps * ahead, LEAST_ROOM * cloth_.mean_edge);
        box_[p] = {};
        for (const Index n : motion_.nodes(p)) box_[p].include(x[n]);
        middle_[p] = 0.5 * (box_[p].low + box_[p].high);
        box_[p].inflate(room_[p] + margin_[p]);
    };
    parallel::for_each(room_.size(), bound, PATCHES_A_CHUNK);
    tree_.update(box_);
    find_pairs();
    drop_apart(x);
    pieces_.list(cloth_, motion_, pairs_);
}

/// Each patch with itself and with those behind it that its box overlaps.
void PatchPairs::find_pairs() {
    pairs_.clear();
    found_pairs_.find(
        box_.size(), pairs_,
        [&](std::size_t p, auto&& take) {
            thread_local std::vector<Index> overlapped;
            tree_.overlapping(box_[p], overlapped);
            const auto first = static_cast<Index>(p);
            for (const Index second : overlapped)
                if (second >= first) take({first, second});
        },
        ASKING);
}

/// Leaves out pairs that may not touch, that lie flat, or between which there is a plane.
void PatchPairs::drop_apart(const Points& x) {
    is_met_.resize(pairs_.size());
    const auto look = [&](std::size_t i) {
        const auto& [p, q] = pairs_[i];
        is_met_[i] = may_touch(p, q) && !regions_.are_flat(p, q) && !are_apart(p, q, x);
    };
    parallel::for_each(pairs_.size(), look, PATCHES_A_CHUNK);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
        if (is_met_[i]) pairs_[kept++] = pairs_[i];
    pairs_.resize(kept);
}

/// Not a body with itself, and only parts that a card has touch.
bool PatchPairs::may_touch(Index p, Index q) const {
    if (body_[p] != SEVERAL && body_[p] == body_[q]) return false;
    const Index a = part_[p], b = part_[q];
    return a == SEVERAL || b == SEVERAL || cloth_.rules.may_touch(a, b);
}

/// Whether a plane lies between two patches and their rooms: corners of boxes overlap though what
/// is in them does not. Seen from the one, the other's nodes are at z; the nearest z of their hull
/// is approached along straight lines [Gilbert 1966].
bool PatchPairs::are_apart(Index p, Index q, const Points& x) const {
    if (p == q) return false;
    const double needed = margin_[p] + room_[p] + margin_[q] + room_[q];
    Vec3 z = middle_[q] - middle_[p];
    for (int look = 0; look < MOST_LOOKS; ++look) {
        const double length = z.norm();
        if (length <= needed) return false;
        const Vec3 s = farthest(q, -z, x) - farthest(p, z, x);
        if (z.dot(s) > needed * length) return true;
        const Vec3 on = s - z;
        z += std::clamp(-z.dot(on) / on.squaredNorm(), 0.0, 1.0) * on;
    }
    return false;
}

/// A patch's node that lies farthest along a direction.                                     [m]
const Vec3& PatchPairs::farthest(Index patch, const Vec3& along, const Points& x) const {
    double most = -INF;
    Index at = 0;
    for (const Index n : motion_.nodes(patch))
        if (const double far = along.dot(x[n]); far > most) {
            most = far;
            at = n;
        }
    return x[at];
}

void Pieces::list(const Cloth& cloth, const PatchMotion& motion, std::span<const PatchPair> pairs) {
    patches.clear();
    nodes.clear();
    triangles.clear();
    is_met_.assign(motion.size(), 0);
    for (const auto& [p, q] : pairs) is_met_[p] = is_met_[q] = 1;
    for (std::size_t p = 0; p < is_met_.size(); ++p)
        if (is_met_[p]) patches.push_back(static_cast<Index>(p));
    if (patches.empty()) return;
    const auto list_those = [&](std::size_t all, std::size_t rows, auto&& of_patch, auto&& row_of,
                                std::vector<Index>& out) {
        constexpr std::size_t PATCHES = 4, ROWS = 1024;  // a chunk
        is_met_.assign(all, 0);
        parallel::for_each(
            patches.size(),
            [&](std::size_t i) {
                for (const Index n : of_patch(patches[i]))
                    std::atomic_ref(is_met_[n]).store(1, std::memory_order_relaxed);
            },
            PATCHES);
        met_.find(
            rows, out,
            [&](std::size_t i, auto&& take) {
                if (is_met_[row_of(i)] != 0) take(row_of(i));
            },
            ROWS);
    };
    list_those(
        cloth.inverse_mass.size(), cloth.nodes.size(), [&](Index p) { return motion.nodes(p); },
        [&](std::size_t i) { return cloth.nodes[i]; }, nodes);
    list_those(
        cloth.triangles.size(), cloth.triangles.size(), [&](Index p) { return cloth.patches[p]; },
        [](std::size_t i) { return static_cast<Index>(i); }, triangles);
}

}  // namespace corpuscle::contact
