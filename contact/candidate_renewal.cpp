// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Listing the pairs of a few nodes anew, while the lists of all others live on.
#include <algorithm>

#include "contact/candidates.hpp"

namespace corpuscle::contact {

/// Nodes that are about to overspend are predicted anew, from where they are to the end of the
/// lists' life. The boxes of all others still hold, so what the renewed ones may meet is found
/// among them, by the same rules as in a build, with every node where it is predicted to be now.
void Candidates::renew(const Points& x) {
    ++renewals_;
    if (!knows_boxes_) near_triangles_.update(triangle_box_);
    knows_boxes_ = true;
    motion_.renew(strayed_, x);
    find_renewed_triangles();
    drop_renewed_pairs();
    list_renewed_pairs(x);
    for (const Index t : renewed_) {
        is_renewed_[t] = 0;
        has_renewed_[cloth_.patch_of[t]] = 0;
    }
}

void Candidates::find_renewed_triangles() {
    is_renewed_.resize(cloth_.triangles.size(), 0);
    has_renewed_.resize(cloth_.patches.size(), 0);
    renewed_.clear();
    for (const Index n : strayed_)
        for (const Index t : cloth_.triangles_of(n)) {
            if (is_renewed_[t]) continue;
            is_renewed_[t] = 1;
            has_renewed_[cloth_.patch_of[t]] = 1;
            renewed_.push_back(t);
        }
    std::sort(renewed_.begin(), renewed_.end());
}

/// Their rows stay, as pairs that are infinitely far apart.
void Candidates::drop_renewed_pairs() {
    handed_on_.clear();
    for (std::size_t i = 0; i < list_.size(); ++i) {
        Watch& w = watch_[i];
        if (w.sum == INF || !(has_renewed_[w.first] | has_renewed_[w.second])) continue;
        Candidate& c = list_[i];
        if (!(is_renewed_[c.first] | is_renewed_[c.second])) continue;
        if (c.memory >= 0) handed_on_.emplace_back(c.key, std::exchange(c.memory, -1));
        w.sum = INF;
        ++dead_;
    }
    std::sort(handed_on_.begin(), handed_on_.end());
}

void Candidates::list_renewed_pairs(const Points& x) {
    const double rest_of_life = life_ - motion_.age();
    for (const Index n : strayed_) set_node_box(n, motion_.predicted(n), rest_of_life);
    for (const Index t : renewed_) {
        set_triangle_box(t);
        near_triangles_.renew(t, triangle_box_[t]);
    }
    predicted_.resize(x.size());
    for (std::size_t n = 0; n < x.size(); ++n)
        predicted_[n] = motion_.predicted(static_cast<Index>(n));

    find_late(predicted_, rest_of_life);
    const Outlook ahead{predicted_, late_, x, rest_of_life, false};
    renewed_pairs_.list.clear();
    renewed_pairs_.watch.clear();
    for (const Index a : renewed_) {
        const Slab slab_a = slab_of(a, ahead);
        near_triangles_.for_each_near(a, [&](Index b) {
            if (is_renewed_[b] && b < a) return;
            list_pairs_of(a, slab_a, b, slab_of(b, ahead), ahead, renewed_pairs_);
        });
    }
    const std::size_t first = list_.size();
    list_.insert(list_.end(), renewed_pairs_.list.begin(), renewed_pairs_.list.end());
    watch_.insert(watch_.end(), renewed_pairs_.watch.begin(), renewed_pairs_.watch.end());
    hand_on_memories(first);
}

/// Pairs that were listed before keep what they know; what those know that are not listed again is
/// forgotten, but for their accounts.
void Candidates::hand_on_memories(std::size_t first) {
    for (std::size_t i = first; i < list_.size(); ++i) {
        const auto known = std::lower_bound(handed_on_.begin(), handed_on_.end(),
                                            std::pair(list_[i].key, Index{0}));
        if (known == handed_on_.end() || known->first != list_[i].key) continue;
        list_[i].memory = std::exchange(known->second, -1);
    }
    for (const auto& [key, memory] : handed_on_) {
        if (memory < 0) continue;
        parted_accounts_ += std::exchange(memories_[memory].account, 0.0);
        memories_[memory].short_by = 0.0;
    }
}

}  // namespace corpuscle::contact
