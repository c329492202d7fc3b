// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/ccd_limiter.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "contact/geometry/time_of_impact.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/sorted.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t CANDIDATES_A_CHUNK = 512;  ///< candidates
constexpr int ROUNDS = 8;                        ///< of impulses before impact zones are made
constexpr int LOOKS = 4;      ///< at new dangers, before they are met with impact zones at once
constexpr double KEPT = 0.5;  ///< share of the path to the impact that a stopped pair may still go

Corners moves(const Pair& pair, double dt, const VelocityState& motion) {
    Corners move;
    for (int k = 0; k < 4; ++k) move[k] = dt * motion.velocity(pair.node[k]);
    return move;
}

}  // namespace

CcdLimiter::CcdLimiter(const Cloth& cloth)
    : cloth_(cloth), mass_(cloth.inverse_mass), changed_(mass_.size(), 0), parent_(mass_.size()) {
    for (double& m : mass_) m = m > 0.0 ? 1.0 / m : 0.0;
    std::iota(parent_.begin(), parent_.end(), 0);
}

void CcdLimiter::stop(double t, double dt, Candidates& pairs, StoppingImpulses& impulses,
                      FacetLoad& load, VelocityState& motion) {
    // Impulses change velocities, and so what may meet: look again until nothing new has to be
    // stopped.
    for (int look = 0;; ++look) {
        motion.settle();
        pairs.foresee(motion.x(), motion.v(), t, dt);
        list_dangers(t, dt, pairs, motion);
        if (!stop_dangers(look < LOOKS ? ROUNDS : 0, dt, pairs, impulses, load, motion)) break;
    }
    for (const Index node : joined_) {
        parent_[node] = node;
        parent_[speaker(node)] = speaker(node);
    }
    joined_.clear();
    is_hub_ = false;
}

/// Stops the listed pairs, by impulses for so many rounds, then by impact zones.
/// @returns whether there was anything to stop
bool CcdLimiter::stop_dangers(int rounds, double dt, Candidates& pairs, StoppingImpulses& impulses,
                              FacetLoad& load, VelocityState& motion) {
    int n = 0;
    for (; has_impacts(); ++n) {
        motion.begin();
        checked_ = ++round_;
        if (n < rounds && joined_.empty()) {
            stop_impacts(dt, pairs, impulses, load, motion);
        } else if (!join_zones(pairs, impulses, motion)) {
            // what hits a body in several places upsets each other: now it is one impact zone
            if (std::exchange(is_hub_, true)) {
                for (const auto& some : found_) unstopped_ += some.size();
                return false;
            }
        }
        const auto search = [&](std::size_t c) { find_impacts(c, dt, pairs, motion); };
        parallel::for_each(near_.size(), search, 1);
    }
    return n > 0;
}

/// Lists the pairs that may meet, and finds the first impacts among them.
void CcdLimiter::list_dangers(double t, double dt, const Candidates& pairs,
                              const VelocityState& motion) {
    checked_ = 0;
    const std::size_t chunks = parallel::chunk_count(pairs.size(), CANDIDATES_A_CHUNK);
    near_.resize(std::max(near_.size(), chunks));
    found_.resize(near_.size());
    for (std::size_t c = chunks; c < near_.size(); ++c) {
        near_[c].clear();
        found_[c].clear();
    }
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        near_[c].clear();
        pairs.for_each_meeting(begin, end, [&](std::size_t i) {
            pairs.prefetch(i);
            near_[c].push_back(i);
        });
        std::erase_if(near_[c],
                      [&](std::size_t i) { return !cloth_.rules.is_on(pairs.card(i), t); });
        find_impacts(c, dt, pairs, motion);
    };
    parallel::for_chunks(pairs.size(), search, CANDIDATES_A_CHUNK);
}

/// Finds impacts among a chunk's pairs that may meet, after the first round only where a velocity
/// has changed since.
void CcdLimiter::find_impacts(std::size_t chunk, double dt, const Candidates& pairs,
                              const VelocityState& motion) {
    found_[chunk].clear();
    for (const std::size_t i : near_[chunk]) {
        const Pair& pair = pairs[i];
        if (checked_ > 0 && std::none_of(pair.node.begin(), pair.node.end(),
                                         [&](Index n) { return changed_[speaker(n)] == checked_; }))
            continue;
        const double time = time_of_impact(pair, corners(pair, motion.x()), moves(pair, dt, motion),
                                           cloth_.greatest_thickness);
        if (time != NO_IMPACT) found_[chunk].push_back({i, time});
    }
}

bool CcdLimiter::has_impacts() const {
    return std::any_of(found_.begin(), found_.end(),
                       [](const auto& some) { return !some.empty(); });
}

/// Stops each pair as it is at its time of impact.
void CcdLimiter::stop_impacts(double dt, const Candidates& pairs, StoppingImpulses& impulses,
                              FacetLoad& load, VelocityState& motion) {
    for (const auto& some : found_)
        for (const auto& [i, time] : some) {
            const Pair& pair = pairs[i];
            for (const Index node : pair.node) mark(node);
            Corners there = corners(pair, motion.x());
            const Corners move = moves(pair, dt, motion);
            for (int k = 0; k < 4; ++k) there[k] += time * move[k];
            const Nearest places = nearest(pair, there);
            const double gap = places.apart.norm();
            if (gap == 0.0) continue;  // an earlier impulse has changed its course: next round
            Contact contact = contact_at(cloth_, motion.bodies(), motion.x(), pair, places, gap);
            contact.card = pairs.card(i);
            contact.side = pairs.side(i);
            const double rate = motion.rate(contact);
            if (rate >= 0.0 || contact.mass == INF) continue;
            impulses.raise_rate(KEPT * time * rate, contact, motion);
            load.add(contact);
            ++impacts_;
        }
}

/// Joins the nodes of all pairs that collide, with impact zones that they belong to already. Zones in
/// several places of a body are several: else a form, the pack under it and the housing that this
/// rests on would stop dead as one whenever a few layers collide.
/// @returns whether anything was joined that was not before
bool CcdLimiter::join_zones(const Candidates& pairs, StoppingImpulses& impulses,
                            VelocityState& motion) {
    bool is_new = false;
    for (const auto& some : found_)
        for (const auto& impact : some) {
            for (const Index node : pairs[impact.pair].node) {
                joined_.push_back(node);
                is_new |= unite(node, pairs[impact.pair].node[0]);
                if (is_hub_) is_new |= unite(node, speaker(node));
            }
        }
    sort_unique(joined_);
    std::stable_sort(joined_.begin(), joined_.end(),
                     [&](Index a, Index b) { return root(a) < root(b); });
    for (std::size_t i = 0, j = 0; i < joined_.size(); i = j) {
        while (j < joined_.size() && root(joined_[j]) == root(joined_[i])) mark(joined_[j++]);
        impulses.join_zone(std::span(joined_).subspan(i, j - i), mass_, motion);
        ++zones_;
    }
    return is_new;
}

/// Name of the impact zone that a node belongs to.
Index CcdLimiter::root(Index node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
}

}  // namespace corpuscle::contact
