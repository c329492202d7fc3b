// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Building the lists of candidates.
#include <algorithm>
#include <cmath>

#include "contact/candidates.hpp"
#include "contact/intersections.hpp"
#include "contact/orientation.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr double SWEEP = 0.5;  ///< farthest that a node may sweep while lists live, in edge lengths
constexpr std::size_t CHUNK = 8;  ///< patch pairs; some thousand triangle pairs

std::uint64_t key_of(bool is_edges, Index first, Index second) {
    return static_cast<std::uint64_t>(is_edges) << 63 | static_cast<std::uint64_t>(first) << 32 |
           static_cast<std::uint64_t>(second);
}

bool has_node(const Triangle& t, Index node) {
    return t[0] == node || t[1] == node || t[2] == node;
}

bool by_key(const PairMemory& memory, std::uint64_t key) {
    return memory.key < key;
}

}  // namespace

void Candidates::start(const Points& x, const Points& v, double t, double dt) {
    motion_.start(x, t);
    motion_.foresee(x, v, dt);
    crossing_ = crossings(cloth_.triangles, cloth_.patches, x);
    bar_crossing_pairs(x);
    build(x, v, t, dt);
    for (std::size_t i = 0; i < list_.size(); ++i)
        if (least_distance(i) < thickness(i)) {
            PairMemory& memory = make_memory(i);
            memory.short_by = thickness(i) - least_distance(i);
            memory.born = t;
        }
}

void Candidates::build(const Points& x, const Points& v, double t, double dt) {
    set_budget(dt);
    motion_.restart(x);
    motion_.foresee(x, v, dt);
    life_ = steps_ * dt;
    const double fastest = motion_.fastest();
    if (fastest * life_ > SWEEP * cloth_.mean_edge)
        life_ = std::max(dt, SWEEP * cloth_.mean_edge / fastest);
    ++builds_;

    std::vector<std::uint64_t> freed;
    if (!crossing_.empty()) {
        freed = barred_;
        bar_crossing_pairs(x);
    }
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        boxes_[i] = Box{};
        for (const Index node : cloth_.triangles[i]) include(node, x, boxes_[i]);
        boxes_[i].inflate(0.5 * reach_ * cloth_.greatest_thickness + budget_);
    }
    near_triangles_.update(boxes_);
    list_pairs(x);
    find_memories(freed, t);
}

void Candidates::list_pairs(const Points& x) {
    const auto pairs = near_triangles_.patch_pairs();
    const std::size_t count = parallel::chunk_count(pairs.size(), CHUNK);
    chunks_.resize(std::max(chunks_.size(), count));
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        chunks_[c].list.clear();
        chunks_[c].watch.clear();
        for (std::size_t i = begin; i < end; ++i)
            near_triangles_.for_each_in(
                pairs[i], [&](Index a, Index b) { list_pairs_of(a, b, x, chunks_[c]); });
    };
    parallel::for_chunks(pairs.size(), search, CHUNK);

    list_.clear();
    watch_.clear();
    for (std::size_t c = 0; c < count; ++c) {
        list_.insert(list_.end(), chunks_[c].list.begin(), chunks_[c].list.end());
        watch_.insert(watch_.end(), chunks_[c].watch.begin(), chunks_[c].watch.end());
    }
}

/// Nodes of a against b, of b against a, edges of a against edges of b, as far as they own them.
void Candidates::list_pairs_of(Index a, Index b, const Points& x, Chunk& out) const {
    const Triangle& ta = cloth_.triangles[a];
    const Triangle& tb = cloth_.triangles[b];
    const Index p = cloth_.patch_of[a], q = cloth_.patch_of[b];
    const double margin = 0.5 * reach_ * cloth_.greatest_thickness + budget_;
    const double h = 0.5 * (cloth_.thickness[a] + cloth_.thickness[b]);
    const auto node_against = [&](Index node, Index t) {
        const Triangle& n = cloth_.triangles[t];
        if (has_node(n, node)) return;
        Box box;
        include(node, x, box);
        box.inflate(margin);
        if (!box.overlaps(boxes_[t])) return;
        consider({{node, n[0], n[1], n[2]}, false}, h, key_of(false, node, t), p, q, x, out);
    };
    for (int k = 0; k < 3; ++k) {
        if (cloth_.owns_node(a, k)) node_against(ta[k], b);
        if (cloth_.owns_node(b, k)) node_against(tb[k], a);
        if (!cloth_.owns_edge(a, k)) continue;
        const Index i = ta[k], j = ta[(k + 1) % 3];
        Box edge = edge_box(i, j, x);
        edge.inflate(2.0 * margin);
        for (int m = 0; m < 3; ++m) {
            const Index r = tb[m], s = tb[(m + 1) % 3];
            if (!cloth_.owns_edge(b, m) || i == r || i == s || j == r || j == s) continue;
            if (!edge.overlaps(edge_box(r, s, x))) continue;
            consider({{i, j, r, s}, true}, h, key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]), p,
                     q, x, out);
        }
    }
}

Box Candidates::edge_box(Index a, Index b, const Points& x) const {
    Box box;
    include(a, x, box);
    include(b, x, box);
    return box;
}

/// Bound of the predicted rate at which a pair's gap shrinks.
double Candidates::approach_speed(const Pair& pair) const {
    const auto& n = pair.node;
    Vec3 mean = Vec3::Zero();
    for (const Index node : n) mean += 0.25 * motion_.velocity(node);
    std::array<double, 4> square;
    for (int k = 0; k < 4; ++k) square[k] = (motion_.velocity(n[k]) - mean).squaredNorm();
    return pair.is_edges
               ? std::sqrt(std::max(square[0], square[1])) +
                     std::sqrt(std::max(square[2], square[3]))
               : std::sqrt(square[0]) + std::sqrt(std::max({square[1], square[2], square[3]}));
}

/// Keeps a pair that may come within reach while the lists live.
void Candidates::consider(const Pair& pair, double thickness, std::uint64_t key, Index p, Index q,
                          const Points& x, Chunk& out) const {
    double mobility = 0.0;
    for (const Index node : pair.node) mobility += cloth_.inverse_mass[node];
    if (mobility == 0.0) return;  // held against held

    const double gap = nearest(pair, x).apart.norm();
    if (gap > reach_ * thickness + 2.0 * budget_ + life_ * approach_speed(pair)) return;
    if (std::binary_search(barred_.begin(), barred_.end(), key)) return;
    out.list.push_back({pair, -1, thickness, key, false});
    out.watch.push_back({gap + motion_.way(p) + motion_.way(q), p, q});
}

/// Bars the pairs of all triangles that crossed at the start and still do.
void Candidates::bar_crossing_pairs(const Points& x) {
    std::erase_if(crossing_, [&](const auto& pair) {
        return !triangles_cross(cloth_.triangles[pair.first], cloth_.triangles[pair.second], x);
    });
    barred_.clear();
    for (const auto& [a, b] : crossing_)
        for (int k = 0; k < 3; ++k) {
            barred_.push_back(key_of(false, cloth_.triangles[a][k], b));
            barred_.push_back(key_of(false, cloth_.triangles[b][k], a));
            for (int m = 0; m < 3; ++m) {
                barred_.push_back(key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]));
                barred_.push_back(key_of(true, cloth_.edge[b][m], cloth_.edge[a][k]));
            }
        }
    std::sort(barred_.begin(), barred_.end());
}

/// Gives the new list what the old one remembered; pairs that were barred until now start with
/// their gap.
void Candidates::find_memories(const std::vector<std::uint64_t>& freed, double t) {
    std::vector<PairMemory> old;
    old.swap(memories_);
    std::erase_if(old, [](const PairMemory& m) { return m.account == 0.0 && m.short_by == 0.0; });
    std::sort(old.begin(), old.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
    if (old.empty() && freed.empty()) return;
    for (std::size_t i = 0; i < list_.size(); ++i) {
        if (!is_due(i)) continue;  // only what is near has anything to remember
        const auto known = std::lower_bound(old.begin(), old.end(), list_[i].key, by_key);
        if (known != old.end() && known->key == list_[i].key) {
            make_memory(i) = *known;
        } else if (std::binary_search(freed.begin(), freed.end(), list_[i].key) &&
                   least_distance(i) < thickness(i)) {
            PairMemory& memory = make_memory(i);
            memory.short_by = thickness(i) - least_distance(i);
            memory.born = t;
        }
    }
}

}  // namespace corpuscle::contact
