// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Building the lists of candidates.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "contact/broad_phase/intersections.hpp"
#include "contact/candidates/candidates.hpp"
#include "contact/geometry/orientation.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/sorted.hpp"

namespace corpuscle::contact {
namespace {

constexpr double SWEEP = 0.4;  ///< farthest that a node may go while lists live, in edge lengths
/// Steps for which patches have room to move: in open cloth; more than lists have lived, in folded.
constexpr std::size_t SPARSE = 2;  ///< candidates a triangle, in open cloth
constexpr double ROOM = 28.0, MORE_ROOM = 1.25;
constexpr std::size_t PATCH_PAIRS_A_CHUNK = 1;  ///< patch pairs; some hundred triangle pairs
constexpr std::size_t MEMORIES = 256;
/// Chunks whose findings wait at once to be put together: memory that the list has no more use for.
constexpr std::size_t ROUND = 512;

}  // namespace

void Candidates::start(const Points& x, const Points& v, double t, double dt) {
    motion_.start(x, t);
    admit(x, v, t, dt);
}

void Candidates::admit(const Points& x, const Points& v, double t, double dt) {
    patches_.start(x);
    patches_.foresee(v, dt);
    bar_all_crossing(x);
    build(x, v, t, dt);
    meet_gently(x, t);
}

/// Crossing triangles are nobody's contact, whichever card finds them first.
void Candidates::bar_all_crossing(const Points& x) {
    crossing_ = crossings(cloth_.triangles, cloth_.patches, x);
    std::erase_if(crossing_, [&](const auto& pair) {
        const Index a = cloth_.part[pair.first], b = cloth_.part[pair.second];
        const Index body = cloth_.body[cloth_.triangles[pair.first][0]];
        if (body >= 0 && body == cloth_.body[cloth_.triangles[pair.second][0]]) return true;
        return !cloth_.rules.may_touch(a, b);
    });
    bar_crossing_pairs(x);
}

/// Pairs for which a card has just begun to hold start with the gap, or the rest gap, that they have.
void Candidates::meet_gently(const Points& x, double t) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        const int card = list_[i].card;
        const auto [p, q] = parts(i);
        const int before = cloth_.rules.before(list_[i].pair.is_edges, p, q);
        if (card == before || !cloth_.rules.holds(card) || !give_gentle_gap(i, x, t, before))
            continue;
        close_starts_.push_back(std::minmax(verlet_.first[i], verlet_.second[i]));
    }
    sort_unique(close_starts_);
}

void Candidates::build(const Points& x, const Points& v, double t, double dt) {
    set_budget(dt);
    const bool is_sparse = list_.size() <= SPARSE * cloth_.triangles.size();
    patches_.find(x, is_sparse ? ROOM : MORE_ROOM * budget_.life / dt);
    motion_.restart(x, v, budget_.stray);
    motion_.foresee(x, v, dt);
    budget_.life = budget_.steps * dt;
    const double fastest = motion_.fastest();
    const double most = SWEEP * cloth_.mean_edge;
    if (fastest * budget_.life > most) budget_.life = std::max(dt, most / fastest);
    ++builds_;

    std::vector<std::uint64_t> freed;
    if (!crossing_.empty()) {
        freed = barred_;
        bar_crossing_pairs(x);
    }
    sort_memories();
    set_boxes(x);
    search_.build(x, late_, node_box_, own_);
    list_pairs(x);
    forget_parted_pairs();
    if (!freed.empty()) give_gentle_gaps(freed, x, t);
}

/// Boxes of what nodes may reach in the lists' life, and where they are predicted to be after it;
/// of two things that may come within reach they overlap.
void Candidates::set_boxes(const Points& x) {
    late_.resize(x.size());
    const auto& nodes = patches_.pieces().nodes;
    parallel::for_each(nodes.size(), [&](std::size_t i) {
        const Index n = nodes[i];
        set_node_box(n, x[n], budget_.life);
        late_[n] = x[n] + budget_.life * motion_.velocity(n);
    });
}

/// @param time  for which the node is predicted [s]
void Candidates::set_node_box(Index node, const Vec3& from, double time) {
    const Vec3 sweep = time * motion_.velocity(node);
    own_[node] = budget_.stray * motion_.slack(node);
    node_box_[node] = {from + sweep.cwiseMin(0.0), from + sweep.cwiseMax(0.0)};
    node_box_[node].inflate(0.5 * reach_ * cloth_.node_thickness[node] + own_[node]);
}

void Candidates::list_pairs(const Points& x) {
    const auto pairs = patches_.pairs();
    chunks_.resize(std::max(chunks_.size(), ROUND));
    const Outlook ahead{x, budget_.life, true};
    std::size_t first = 0;
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        Chunk& out = chunks_[c];
        out.list.clear();
        out.watch.clear();
        for (std::size_t i = begin; i < end; ++i)
            search_.for_each_in(
                pairs[first + i],
                [&](Feature a, Feature b, Distances apart) { meet_edges(a, b, apart, ahead, out); },
                [&](Feature n, Index t, Distances apart) { meet_node(n, t, apart, ahead, out); });
    };
    std::size_t rows = 0;
    for (; first < pairs.size(); first += ROUND * PATCH_PAIRS_A_CHUNK) {
        const std::size_t count = std::min(pairs.size() - first, ROUND * PATCH_PAIRS_A_CHUNK);
        parallel::for_chunks(count, search, PATCH_PAIRS_A_CHUNK);
        rows = add_chunks(rows, parallel::chunk_count(count, PATCH_PAIRS_A_CHUNK));
    }
    list_.resize(rows);
    verlet_.resize(rows);
    dead_ = 0;
}

/// Puts what the first chunks have found behind so many rows, in their order, in place of what is
/// there.
/// @returns rows up to the last of it
std::size_t Candidates::add_chunks(std::size_t rows, std::size_t count) {
    std::vector<std::size_t> start(count + 1, rows);
    for (std::size_t c = 0; c < count; ++c) start[c + 1] = start[c] + chunks_[c].list.size();
    if (start[count] > list_.size()) {
        list_.resize(start[count]);
        verlet_.resize(start[count]);
    }
    const auto copy = [&](std::size_t c) {
        const auto to = static_cast<std::ptrdiff_t>(start[c]);
        std::copy(chunks_[c].list.begin(), chunks_[c].list.end(), list_.begin() + to);
        for (std::size_t k = 0; k < chunks_[c].watch.size(); ++k)
            verlet_.put(start[c] + k, chunks_[c].watch[k]);
    };
    parallel::for_each(count, copy, PATCH_PAIRS_A_CHUNK);
    return start[count];
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
                const auto [first, second] = std::minmax(cloth_.edge[a][k], cloth_.edge[b][m]);
                barred_.push_back(key_of(true, first, second));
            }
        }
    std::sort(barred_.begin(), barred_.end());
}

/// Keeps the memories that say something, in the order of their keys. Those that were there at the
/// last build are in order, those made since come behind them.
void Candidates::sort_memories() {
    const auto by_key = [](const PairMemory& a, const PairMemory& b) { return a.key < b.key; };
    memories_.erase(
        std::remove_if(memories_.begin() + static_cast<std::ptrdiff_t>(sorted_), memories_.end(),
                       [](const PairMemory& m) { return m.is_empty(); }),
        memories_.end());
    const std::span<const PairMemory> made = std::span(memories_).subspan(sorted_);
    parallel::sort(std::span(memories_).subspan(sorted_), merging_.merged, by_key);
    std::vector<std::size_t>& kept = merging_.kept;
    std::vector<PairMemory>& merged = merging_.merged;
    kept.clear();
    merging_.found.find(
        sorted_, kept,
        [&](std::size_t m, auto&& take) {
            if (!memories_[m].is_empty()) take(m);
        },
        MEMORIES);
    // Each goes where those of lower keys end, of its own kind and of the other.
    merged.resize(kept.size() + made.size());
    const auto place_kept = [&](std::size_t i) {
        const PairMemory& memory = memories_[kept[i]];
        const auto before =
            std::lower_bound(made.begin(), made.end(), memory, by_key) - made.begin();
        merged[i + static_cast<std::size_t>(before)] = memory;
    };
    const auto place_made = [&](std::size_t i) {
        const PairMemory& memory = made[i];
        const auto before =
            std::partition_point(kept.begin(), kept.end(),
                                 [&](std::size_t m) { return memories_[m].key <= memory.key; }) -
            kept.begin();
        merged[i + static_cast<std::size_t>(before)] = memory;
    };
    parallel::side_by_side(parallel::each(kept.size(), place_kept, MEMORIES),
                           parallel::each(made.size(), place_made, MEMORIES));
    memories_.swap(merged);
    sorted_ = memories_.size();
    merging_.keys.resize(sorted_);
    parallel::for_each(
        sorted_, [&](std::size_t m) { merging_.keys[m] = memories_[m].key; }, MEMORIES);
}

/// Forgets the memories of pairs that are not in the list any more.
void Candidates::forget_parted_pairs() {
    is_used_.assign(memories_.size(), 0);
    parallel::for_each(list_.size(), [&](std::size_t i) {
        if (const Index m = list_[i].memory; m >= 0)
            std::atomic_ref(is_used_[m]).store(1, std::memory_order_relaxed);
    });
    parallel::for_each(memories_.size(), [&](std::size_t m) {
        if (is_used_[m] == 0) memories_[m].short_by = memories_[m].area = 0.0;
    });
}

Index Candidates::find_memory(std::uint64_t key) const {
    const std::vector<std::uint64_t>& keys = merging_.keys;
    const auto known = std::lower_bound(keys.begin(), keys.end(), key);
    const bool is_known = known != keys.end() && *known == key;
    return is_known ? static_cast<Index>(known - keys.begin()) : -1;
}

/// Pairs that are nearer than their contact thickness start with the gap that they have.
void Candidates::give_gentle_gaps(const std::vector<std::uint64_t>& keys, const Points& x,
                                  double t) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        if (!std::binary_search(keys.begin(), keys.end(), list_[i].key)) continue;
        give_gentle_gap(i, x, t);
    }
}

/// @param card_before  by which it touched until now, or NONE
bool Candidates::give_gentle_gap(std::size_t i, const Points& x, double t, int card_before) {
    if (verlet_.sum[i] - spent(i) >= thickness(i)) return false;
    const Pair& pair = list_[i].pair;
    PairMemory* const known = memory(i);
    double rest = nearest(pair, x).apart.norm();
    if (card_before != Rules::NONE) {
        const double before =
            std::min({cloth_.gap(card_before, parts(i), pair, verlet_.first[i], verlet_.second[i]),
                      neighbours_thickness(pair), cloth_.rules.most(card_before, t)});
        const double missing = known ? known->missing(t, cloth_.growth_time) : 0.0;
        rest = std::max(rest, before - missing);
        if (known) known->short_by = 0.0;
    }
    const double short_by = thickness(i) - rest;
    if (short_by <= 0.0) return false;
    PairMemory& memory = make_memory(i);
    memory.short_by = short_by;
    memory.born = t;
    return true;
}

}  // namespace corpuscle::contact
