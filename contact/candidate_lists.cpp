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

Vec3 normal_of(const Triangle& t, const Points& x) {
    return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).stableNormalized();
}

bool has_node(const Triangle& t, Index node) {
    return t[0] == node || t[1] == node || t[2] == node;
}

}  // namespace

void Candidates::start(const Points& x, const Points& v, double t, double dt,
                       std::span<const std::uint8_t> is_on) {
    motion_.start(x, t);
    was_on_.assign(is_on.size(), 0);
    admit(x, v, t, dt, is_on);
}

void Candidates::admit(const Points& x, const Points& v, double t, double dt,
                       std::span<const std::uint8_t> is_on) {
    motion_.foresee(x, v, dt);
    bar_all_crossing(x);
    build(x, v, t, dt);
    meet_gently(t, is_on);
}

/// Crossing triangles are nobody's contact, whichever card finds them first.
void Candidates::bar_all_crossing(const Points& x) {
    crossing_ = crossings(cloth_.triangles, cloth_.patches, x);
    std::erase_if(crossing_, [&](const auto& pair) {
        const Index a = cloth_.part[pair.first], b = cloth_.part[pair.second];
        const Index body = cloth_.body[cloth_.triangles[pair.first][0]];
        if (body >= 0 && body == cloth_.body[cloth_.triangles[pair.second][0]]) return true;
        return cloth_.rules.nodes_against(a, b) == Rules::NONE &&
               cloth_.rules.nodes_against(b, a) == Rules::NONE;
    });
    bar_crossing_pairs(x);
}

/// Pairs of the cards that have just become valid start with the gap that they have.
void Candidates::meet_gently(double t, std::span<const std::uint8_t> is_on) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        const auto card = static_cast<std::size_t>(list_[i].card);
        if (was_on_[card] || !is_on[card] || !give_gentle_gap(i, t)) continue;
        close_starts_.push_back(std::minmax(list_[i].first, list_[i].second));
    }
    std::sort(close_starts_.begin(), close_starts_.end());
    close_starts_.erase(std::unique(close_starts_.begin(), close_starts_.end()),
                        close_starts_.end());
    was_on_.assign(is_on.begin(), is_on.end());
}

void Candidates::build(const Points& x, const Points& v, double t, double dt) {
    set_budget(dt);
    motion_.restart(x, budget_);
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
    sort_memories();
    set_boxes(x);
    near_triangles_.update(triangle_box_);
    knows_boxes_ = true;
    list_pairs(x);
    forget_parted_pairs();
    if (!freed.empty()) give_gentle_gaps(freed, t);
}

/// Boxes of what nodes and triangles may reach; two of them overlap where a gap may come within
/// reach.
void Candidates::set_boxes(const Points& x) {
    parallel::for_each(x.size(),
                       [&](std::size_t n) { set_node_box(static_cast<Index>(n), x[n], life_); });
    normal_.resize(triangle_box_.size());
    parallel::for_each(triangle_box_.size(), [&](std::size_t t) {
        set_triangle_box(static_cast<Index>(t));
        normal_[t] = normal_of(cloth_.triangles[t], x);
    });
}

/// @param time  for which the node is predicted [s]
void Candidates::set_node_box(Index node, const Vec3& from, double time) {
    const Vec3 sweep = time * motion_.velocity(node);
    node_box_[node] = {from + sweep.cwiseMin(0.0), from + sweep.cwiseMax(0.0)};
    node_box_[node].inflate(0.5 * reach_ * cloth_.node_thickness[node] +
                            budget_ * motion_.slack(node));
}

void Candidates::set_triangle_box(Index triangle) {
    const auto& [a, b, c] = cloth_.triangles[triangle];
    Box& box = triangle_box_[triangle];
    box = node_box_[a];
    box.include(node_box_[b]);
    box.include(node_box_[c]);
}

void Candidates::list_pairs(const Points& x) {
    const auto pairs = near_triangles_.patch_pairs();
    const std::size_t count = parallel::chunk_count(pairs.size(), CHUNK);
    chunks_.resize(std::max(chunks_.size(), count));
    const Outlook ahead{x, x, life_, true};
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        chunks_[c].list.clear();
        chunks_[c].watch.clear();
        for (std::size_t i = begin; i < end; ++i)
            near_triangles_.for_each_in(pairs[i], [&](Index a, Index b) {
                if (!stay_apart(a, b, ahead)) list_pairs_of(a, b, ahead, chunks_[c]);
            });
    };
    parallel::for_chunks(pairs.size(), search, CHUNK);

    list_.clear();
    watch_.clear();
    dead_ = 0;
    for (std::size_t c = 0; c < count; ++c) {
        list_.insert(list_.end(), chunks_[c].list.begin(), chunks_[c].list.end());
        watch_.insert(watch_.end(), chunks_[c].watch.begin(), chunks_[c].watch.end());
    }
}

/// Will the two triangles, as they are predicted to fly, stay out of reach of each other while the
/// lists live? Boxes of layers overlap long before the layers touch; seen along a layer's normal
/// they are apart.
bool Candidates::stay_apart(Index a, Index b, const Outlook& ahead) const {
    double thickness = 0.0;
    for (const auto& of : cloth_.thickness) thickness = std::max(thickness, 0.5 * (of[a] + of[b]));
    const auto slack = [&](Index t) {
        double most = 0.0;
        for (const Index n : cloth_.triangles[t]) most = std::max(most, motion_.slack(n));
        return most;
    };
    const double apart = reach_ * thickness + budget_ * (slack(a) + slack(b));
    const auto normal = [&](Index t) {
        return ahead.is_build ? normal_[t] : normal_of(cloth_.triangles[t], ahead.x);
    };
    return are_parted_along(normal(a), apart, a, b, ahead) ||
           are_parted_along(normal(b), apart, a, b, ahead);
}

/// Along a fixed axis every node's place is linear in time, and so is each pair's distance: what is
/// parted by more than `apart`, to the same side, at both ends of the time is so in between.
bool Candidates::are_parted_along(const Vec3& axis, double apart, Index a, Index b,
                                  const Outlook& ahead) const {
    const auto span = [&](Index t, double time) {
        double low = INF, high = -INF;
        for (const Index n : cloth_.triangles[t]) {
            const double at = axis.dot(ahead.x[n] + time * motion_.velocity(n));
            low = std::min(low, at);
            high = std::max(high, at);
        }
        return std::pair(low, high);
    };
    const auto [low_a, high_a] = span(a, 0.0);
    const auto [low_b, high_b] = span(b, 0.0);
    const bool is_above = low_b - high_a > apart;
    if (!is_above && !(low_a - high_b > apart)) return false;
    const auto [late_low_a, late_high_a] = span(a, ahead.life);
    const auto [late_low_b, late_high_b] = span(b, ahead.life);
    return is_above ? late_low_b - late_high_a > apart : late_low_a - late_high_b > apart;
}

/// Nodes of a against b, of b against a, edges of a against edges of b, as far as they own them and
/// a card has them touch.
void Candidates::list_pairs_of(Index a, Index b, const Outlook& ahead, Chunk& out) const {
    const Triangle& ta = cloth_.triangles[a];
    const Triangle& tb = cloth_.triangles[b];
    const Rules& rules = cloth_.rules;
    const Index part_a = cloth_.part[a], part_b = cloth_.part[b];
    const int a_on_b = rules.nodes_against(part_a, part_b),
              b_on_a = rules.nodes_against(part_b, part_a),
              edges = rules.edges_against(part_a, part_b);
    const auto node_against = [&](int card, Index from, Index node, Index t) {
        const Triangle& n = cloth_.triangles[t];
        if (has_node(n, node) || !node_box_[node].overlaps(triangle_box_[t])) return;
        consider({{node, n[0], n[1], n[2]}, false}, card, key_of(false, node, t),
                 {from, t, ahead, out});
    };
    for (int k = 0; k < 3; ++k) {
        if (a_on_b != Rules::NONE && cloth_.owns_node(a, k)) node_against(a_on_b, a, ta[k], b);
        if (b_on_a != Rules::NONE && cloth_.owns_node(b, k)) node_against(b_on_a, b, tb[k], a);
        if (edges == Rules::NONE || !cloth_.owns_edge(a, k)) continue;
        const Index i = ta[k], j = ta[(k + 1) % 3];
        const Box edge = edge_box(i, j);
        for (int m = 0; m < 3; ++m) {
            const Index r = tb[m], s = tb[(m + 1) % 3];
            if (!cloth_.owns_edge(b, m) || i == r || i == s || j == r || j == s) continue;
            if (!edge.overlaps(edge_box(r, s))) continue;
            consider({{i, j, r, s}, true}, edges,
                     key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]), {a, b, ahead, out});
        }
    }
}

Box Candidates::edge_box(Index a, Index b) const {
    Box box = node_box_[a];
    box.include(node_box_[b]);
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

/// Of both sides together, in budgets.
double Candidates::slack_of(const Pair& pair) const {
    std::array<double, 4> of;
    for (int k = 0; k < 4; ++k) of[k] = motion_.slack(pair.node[k]);
    return pair.is_edges ? std::max(of[0], of[1]) + std::max(of[2], of[3])
                         : of[0] + std::max({of[1], of[2], of[3]});
}

/// Keeps a pair that may come within reach while the lists live.
void Candidates::consider(const Pair& pair, int card, std::uint64_t key,
                          const Meeting& where) const {
    const double thickness = cloth_.gap(card, where.a, where.b);
    const Outlook& ahead = where.ahead;
    double gap = nearest(pair, ahead.x).apart.norm();
    const double certain = reach_ * thickness + budget_ * slack_of(pair);
    if (gap > certain && gap > certain + ahead.life * approach_speed(pair)) return;
    if (cloth_.is_held(pair) || std::binary_search(barred_.begin(), barred_.end(), key)) return;
    // only what is near has anything to remember
    const bool may_know = ahead.is_build && gap <= reach_ * thickness;
    const Index memory = may_know ? memory_row(key) : -1;
    if (&ahead.x != &ahead.now) gap = nearest(pair, ahead.now).apart.norm();
    const Index p = cloth_.patch_of[where.a], q = cloth_.patch_of[where.b];
    const int side = cloth_.rules.side_of(card, cloth_.part[where.a], cloth_.part[where.b]);
    where.out.list.push_back({pair, memory, thickness, key, where.a, where.b,
                              static_cast<std::int16_t>(card), static_cast<std::int16_t>(side),
                              false});
    where.out.watch.push_back({gap + motion_.way(p) + motion_.way(q), p, q});
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

/// Keeps the memories that say something, in the order of their keys.
void Candidates::sort_memories() {
    std::erase_if(memories_, [](const PairMemory& m) { return m.is_empty(); });
    std::sort(memories_.begin(), memories_.end(),
              [](const auto& a, const auto& b) { return a.key < b.key; });
}

/// Forgets the memories of pairs that are not in the list any more; their accounts are not lost.
void Candidates::forget_parted_pairs() {
    std::vector<std::uint8_t> is_used(memories_.size(), 0);
    for (const Candidate& c : list_)
        if (c.memory >= 0) is_used[c.memory] = 1;
    for (std::size_t m = 0; m < memories_.size(); ++m) {
        if (is_used[m]) continue;
        parted_accounts_ += memories_[m].account;
        memories_[m].account = memories_[m].short_by = 0.0;
    }
}

Index Candidates::memory_row(std::uint64_t key) const {
    const auto by_key = [](const PairMemory& memory, std::uint64_t k) { return memory.key < k; };
    const auto known = std::lower_bound(memories_.begin(), memories_.end(), key, by_key);
    const bool is_known = known != memories_.end() && known->key == key;
    return is_known ? static_cast<Index>(known - memories_.begin()) : -1;
}

/// Pairs that are nearer than their contact thickness start with the gap that they have.
void Candidates::give_gentle_gaps(const std::vector<std::uint64_t>& keys, double t) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        if (!std::binary_search(keys.begin(), keys.end(), list_[i].key)) continue;
        give_gentle_gap(i, t);
    }
}

bool Candidates::give_gentle_gap(std::size_t i, double t) {
    const double short_by = thickness(i) - least_distance(i);
    if (short_by <= 0.0) return false;
    PairMemory& memory = make_memory(i);
    memory.short_by = short_by;
    memory.born = t;
    return true;
}

}  // namespace corpuscle::contact
