// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/tied_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"

namespace corpuscle {

/// In an order in which every node comes before those that it is tied to.
TiedNodes::TiedNodes(const Model& model) {
    std::map<Index, const TiedNode*> tie_of;
    for (const TiedNode& tie : model.tied_nodes) tie_of[tie.node] = &tie;
    std::map<Index, int> depth;  // ties between a node and one that is free
    const auto depth_of = [&](auto&& self, Index node, std::size_t steps) -> int {
        const auto tie = tie_of.find(node);
        if (tie == tie_of.end()) return 0;
        if (const auto known = depth.find(node); known != depth.end()) return known->second;
        if (steps > tie_of.size())
            throw InputError(
                fmt::format("node {} is tied to itself through others", model.node_id[node]));
        int most = 0;
        for (const Index end : tie->second->ends) most = std::max(most, self(self, end, steps + 1));
        return depth[node] = most + 1;
    };
    for (const TiedNode& tie : model.tied_nodes) {
        depth_of(depth_of, tie.node, 0);
        ties_.push_back(tie);
    }
    std::stable_sort(ties_.begin(), ties_.end(), [&](const TiedNode& a, const TiedNode& b) {
        return depth[a.node] > depth[b.node];
    });
}

void TiedNodes::share_mass(std::vector<double>& mass) const {
    for (const auto& [node, ends, w] : ties_) {
        mass[ends[0]] += (1.0 - w) * mass[node];
        mass[ends[1]] += w * mass[node];
        mass[node] = 0.0;
    }
}

void TiedNodes::share_momentum(std::vector<double> mass, Points& v) const {
    Points given(v.size(), Vec3::Zero());
    for (const auto& [node, ends, w] : ties_) {
        const Vec3 J =
            given[node] + mass[node] * (v[node] - (1.0 - w) * v[ends[0]] - w * v[ends[1]]);
        given[ends[0]] += (1.0 - w) * J;
        given[ends[1]] += w * J;
        mass[ends[0]] += (1.0 - w) * mass[node];
        mass[ends[1]] += w * mass[node];
        mass[node] = 0.0;
    }
    for (std::size_t n = 0; n < v.size(); ++n)
        if (mass[n] > 0.0) v[n] += given[n] / mass[n];
}

void TiedNodes::share_force(Points& f) const {
    for (const auto& [node, ends, w] : ties_) {
        f[ends[0]] += (1.0 - w) * f[node];
        f[ends[1]] += w * f[node];
        f[node].setZero();
    }
}

void TiedNodes::hold(Points& v) const {
    for (auto tie = ties_.rbegin(); tie != ties_.rend(); ++tie)
        v[tie->node] = (1.0 - tie->share) * v[tie->ends[0]] + tie->share * v[tie->ends[1]];
}

std::vector<double> TiedNodes::met_mass(const std::vector<double>& mass) const {
    std::vector<double> met = mass;
    for (auto tie = ties_.rbegin(); tie != ties_.rend(); ++tie) {
        const double w = tie->share, m_0 = met[tie->ends[0]], m_1 = met[tie->ends[1]];
        const double inverse =
            (m_0 > 0.0 ? (1.0 - w) * (1.0 - w) / m_0 : 0.0) + (m_1 > 0.0 ? w * w / m_1 : 0.0);
        met[tie->node] = inverse > 0.0 ? 1.0 / inverse : 0.0;
    }
    return met;
}

void TiedNodes::settle(const Points& before, const std::vector<double>& mass,
                       const std::vector<double>& met, const Points& x,
                       const std::vector<Index>& body_of_node,
                       std::vector<contact::RigidProxy>& proxies, Points& v) const {
    std::vector<Vec3> impulse(ties_.size(), Vec3::Zero());
    std::map<Index, Vec3> passed_on;  // to nodes that are tied themselves
    const auto push = [&](Index node, const Vec3& J) {
        const Index body = body_of_node.empty() ? -1 : body_of_node[node];
        if (body >= 0) {
            proxies[body].impulse += J;
            proxies[body].turning += Vec3(x[node] - proxies[body].centre).cross(J);
        } else if (mass[node] > 0.0) {
            v[node] += J / mass[node];
        } else {
            passed_on.try_emplace(node, Vec3::Zero()).first->second += J;
        }
    };
    for (const auto& [node, ends, w] : ties_) {
        Vec3 J = met[node] * (v[node] - before[node]);
        if (const auto more = passed_on.find(node); more != passed_on.end()) J += more->second;
        if (J.isZero(0.0)) continue;
        push(ends[0], (1.0 - w) * J);
        push(ends[1], w * J);
    }
    hold(v);
}

namespace {

/// Where a chain of ties in one place ends.
Index last_of(Index node, const std::map<Index, Index>& next) {
    for (auto at = next.find(node); at != next.end(); at = next.find(node)) node = at->second;
    return node;
}

}  // namespace

/// Of several nodes on one edge the middle one cuts it; the others lie on what is left.
TiedEdges::TiedEdges(const std::vector<TiedNode>& ties) {
    struct OnEdge {
        double share;
        Index node;
    };
    std::map<std::pair<Index, Index>, std::vector<OnEdge>> open;
    for (const auto& [node, ends, w] : ties)
        if (ends[0] == ends[1]) kept_.emplace(node, ends[0]);
    for (auto& [node, other] : kept_) other = last_of(node, kept_);
    for (const auto& [node, ends_as_told, w] : ties) {
        const std::array<Index, 2> ends{node_for(ends_as_told[0]), node_for(ends_as_told[1])};
        if (ends[0] == ends[1]) continue;
        const bool turned = ends[0] > ends[1];
        open[std::minmax(ends[0], ends[1])].push_back({turned ? 1.0 - w : w, node});
    }
    while (!open.empty()) {
        auto [edge, nodes] = *open.begin();
        open.erase(open.begin());
        std::sort(nodes.begin(), nodes.end(),
                  [](const OnEdge& a, const OnEdge& b) { return a.share < b.share; });
        const OnEdge middle = nodes[nodes.size() / 2];
        node_on_.emplace(edge, middle.node);
        for (const OnEdge& other : nodes) {
            if (other.node == middle.node) continue;
            const bool is_below = other.share < middle.share;
            const Index end = is_below ? edge.first : edge.second;
            const double share = is_below ? other.share / middle.share
                                          : (other.share - middle.share) / (1.0 - middle.share);
            const auto key = std::minmax(end, middle.node);
            const bool from_end = key.first == (is_below ? end : middle.node);
            open[key].push_back({from_end ? share : 1.0 - share, other.node});
        }
    }
}

}  // namespace corpuscle
