// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Listing the pairs of a few nodes anew, while the lists of all others live on.
#include <algorithm>
#include <functional>

#include "contact/candidates/candidates.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t ROWS = 2048, TRIANGLES = 4;  ///< a chunk, of pairs and of renewed triangles
constexpr std::size_t LISTED = 128;                ///< likewise of pairs that were listed anew

}  // namespace

/// Nodes that are about to overspend are predicted anew, from where they are to the end of the
/// lists' life. The boxes of all others still hold, so what the renewed ones may meet is found
/// among them, by the same rules as in a build, with every node where it is predicted to be now.
void Candidates::renew(const Points& x) {
    ++renewals_;
    motion_.renew(renewal_.strayed, x);
    find_renewed_triangles();
    drop_renewed_pairs();
    list_renewed_pairs(x);
    for (const Index t : renewal_.renewed) renewal_.is_renewed[t] = 0;
}

/// Those of the patches that are searched: no others are in any pair.
void Candidates::find_renewed_triangles() {
    const std::vector<Index>& searched = patches_.pieces().triangles;
    renewal_.is_renewed.resize(cloth_.triangles.size(), 0);
    renewal_.renewed.clear();
    for (const Index n : renewal_.strayed)
        for (const Index t : cloth_.triangles_of(n)) {
            if (renewal_.is_renewed[t] || !std::binary_search(searched.begin(), searched.end(), t))
                continue;
            renewal_.is_renewed[t] = 1;
            renewal_.renewed.push_back(t);
        }
    std::sort(renewal_.renewed.begin(), renewal_.renewed.end());
}

/// Their rows stay, as pairs that are infinitely far apart.
void Candidates::drop_renewed_pairs() {
    renewal_.handed_on.clear();
    const auto drop = [&](std::size_t i, auto&& take) {
        const bool is_renewed =
            (renewal_.is_renewed[verlet_.first[i]] | renewal_.is_renewed[verlet_.second[i]]) != 0;
        if (!is_renewed || !(verlet_.sum[i] < INF)) return;
        verlet_.sum[i] = INF;
        take(std::pair(list_[i].key, std::exchange(list_[i].memory, -1)));
    };
    renewal_.dropped.find(list_.size(), renewal_.handed_on, drop, ROWS);
    dead_ += renewal_.handed_on.size();
    std::erase_if(renewal_.handed_on, [](const auto& dropped) { return dropped.second < 0; });
    parallel::sort(std::span(renewal_.handed_on), renewal_.sorting, std::less<>());
}

void Candidates::list_renewed_pairs(const Points& x) {
    const double rest_of_life = budget_.life - motion_.age();
    for (const Index n : renewal_.strayed) set_node_box(n, motion_.predicted(n), rest_of_life);
    renewal_.predicted.resize(x.size());
    late_.resize(x.size());
    const auto& nodes = patches_.pieces().nodes;
    parallel::for_each(nodes.size(), [&](std::size_t i) {
        const Index n = nodes[i];
        renewal_.predicted[n] = motion_.predicted(n);
        late_[n] = renewal_.predicted[n] + rest_of_life * motion_.velocity(n);
    });
    search_.renew(renewal_.renewed, renewal_.predicted, late_, node_box_, own_);

    const Outlook ahead{x, rest_of_life, false};
    const std::size_t count = parallel::chunk_count(renewal_.renewed.size(), TRIANGLES);
    chunks_.resize(std::max(chunks_.size(), count));
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        Chunk& out = chunks_[c];
        out.list.clear();
        out.watch.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const Index mine = renewal_.renewed[i];
            // two renewed triangles find each other twice
            const auto is_the_others = [&](Index other) {
                return renewal_.is_renewed[other] && other < mine;
            };
            search_.for_each_near(
                mine,
                [&](Feature a, Feature b, Distances apart) {
                    if (!is_the_others(b.triangle)) meet_edges(a, b, apart, ahead, out);
                },
                [&](Feature n, Index t, Distances apart) {
                    if (!is_the_others(n.triangle == mine ? t : n.triangle))
                        meet_node(n, t, apart, ahead, out);
                });
        }
    };
    parallel::for_chunks(renewal_.renewed.size(), search, TRIANGLES);
    const std::size_t first = list_.size();
    add_chunks(first, count);
    hand_on_memories(first);
}

/// Pairs that were listed before keep what they know; what those know that are not listed again is
/// forgotten.
void Candidates::hand_on_memories(std::size_t first) {
    if (renewal_.handed_on.empty()) return;
    const auto handed_on = renewal_.handed_on.begin();
    renewal_.known.resize(list_.size() - first);
    parallel::for_each(
        renewal_.known.size(),
        [&](std::size_t k) {
            const std::uint64_t key = list_[first + k].key;
            const auto at =
                std::lower_bound(handed_on, renewal_.handed_on.end(), std::pair(key, Index{0}));
            const bool is_known = at != renewal_.handed_on.end() && at->first == key;
            renewal_.known[k] = is_known ? static_cast<Index>(at - handed_on) : -1;
        },
        LISTED);
    for (std::size_t k = 0; k < renewal_.known.size(); ++k)
        if (renewal_.known[k] >= 0)
            list_[first + k].memory = std::exchange(handed_on[renewal_.known[k]].second, -1);
    for (const auto& [key, memory] : renewal_.handed_on) {
        if (memory < 0) continue;
        memories_[memory].short_by = memories_[memory].area = 0.0;
    }
}

}  // namespace corpuscle::contact
