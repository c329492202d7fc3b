// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "contact/surface/rigid_proxies.hpp"
#include "solver/base/surface.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Nodes that move with the two ends of an edge, x = (1 - w) x_0 + w x_1 (TiedNode). A node that is
/// tied to one that is tied itself comes before it.
class TiedNodes {
public:
    /// @throws InputError  for a node that is tied to itself through others
    explicit TiedNodes(const Model& model);

    /// Whether no node is tied.
    [[nodiscard]] bool empty() const { return ties_.empty(); }
    /// In an order in which each comes before those that it is tied to.
    [[nodiscard]] const std::vector<TiedNode>& all() const { return ties_; }

    /// Mass to the ends: m_0 += (1 - w) m, m_1 += w m, m = 0.                            [kg]
    void share_mass(std::vector<double>& mass) const;
    /// Momentum to the ends: what a tied node has beyond the velocity of its place on the edge goes
    /// to the ends in the shares of its mass; of nodes in one place v = sum m v / sum m.
    /// @param mass  before share_mass()                                                  [kg]
    void share_momentum(std::vector<double> mass, Points& v) const;
    /// Force to the ends, in the same shares.                                              [N]
    void share_force(Points& f) const;
    /// v = (1 - w) v_0 + w v_1.                                                          [m/s]
    void hold(Points& v) const;

    /// The mass that a push at a tied node meets, where ends have those of `mass`; of other nodes
    /// theirs. An end of a rigid body counts as held.
    ///
    ///     1 / m = (1 - w)² / m_0 + w² / m_1                                              [kg]
    [[nodiscard]] std::vector<double> met_mass(const std::vector<double>& mass) const;

    /// What has changed a tied node's velocity since `before` is an impulse on its ends; then
    /// hold().
    /// @param met  met_mass()
    void settle(const Points& before, const std::vector<double>& mass,
                const std::vector<double>& met, const Points& x,
                const std::vector<Index>& body_of_node, std::vector<contact::RigidProxy>& proxies,
                Points& v) const;

private:
    std::vector<TiedNode> ties_;
};

/// Triangles whose edges have tied nodes on them, cut there, and with one node where several are
/// tied in one place: two that share an edge share its nodes again.
class TiedEdges {
public:
    /// @param ties  in any order; nodes that are tied to one node count as that node
    explicit TiedEdges(const std::vector<TiedNode>& ties);

    /// The triangle, or its pieces in its own sense of turning; none where two corners are one.
    template <class Add>
    void cut(const Triangle& whole, Add&& add) const {
        const Triangle t{node_for(whole[0]), node_for(whole[1]), node_for(whole[2])};
        if (t == whole || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])) cut_edges(t, add);
    }

    /// The one node that stands for all that are tied in the place of this one; by itself: itself.
    [[nodiscard]] Index node_for(Index node) const {
        const auto at = kept_.find(node);
        return at == kept_.end() ? node : at->second;
    }

    /// Whether cut() leaves every triangle whole.
    [[nodiscard]] bool empty() const { return node_on_.empty() && kept_.empty(); }

private:
    template <class Add>
    void cut_edges(const Triangle& t, Add&& add) const {
        for (int k = 0; k < 3; ++k) {
            const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
            const auto at = node_on_.find(std::minmax(a, b));
            if (at == node_on_.end() || at->second == c) continue;
            cut_edges({a, at->second, c}, add);
            cut_edges({at->second, b, c}, add);
            return;
        }
        add(t);
    }

    std::map<std::pair<Index, Index>, Index> node_on_;  ///< ends, lower row first
    std::map<Index, Index> kept_;  ///< of nodes tied in one place: the one that is free
};

}  // namespace corpuscle
