// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "fabric/nodes.hpp"
#include "solver/bodies/riding_cloth.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Loads that the deck prescribes: base acceleration, pressure on facets, forces on nodes and on
/// rigid bodies.
class Loads {
public:
    /// @param model  whose loads on bodies, facets and nodes it takes
    explicit Loads(const Model& model);

    /// Which share of each node's mass, with that of tied nodes that it bears, the parts of cloth
    /// have that a load on some parts is about.
    /// @param shell_mass  E                                                            [kg]
    void share_mass(const Model& model, const std::vector<double>& shell_mass,
                    const TiedNodes& ties);

    /// Takes note of cloth that rides on bodies: a load on some parts pulls it at its nodes, beside
    /// what acceleration() gives to the body as a whole.
    void ride(const std::vector<RidingNode>& riding, const std::vector<RigidBody>& bodies);

    /// Whether no load acts on nodes: find_force() would give 0.
    [[nodiscard]] bool empty() const { return body_.empty() && pressure_.empty() && node_.empty(); }

    /// What the frame's acceleration gives to a part at t: -a(t).                        [m/s^2]
    [[nodiscard]] Vec3 acceleration(double t, Index part) const;

    /// Force at a body's mass centre, and moment about it.
    struct Push {
        Vec3 force = Vec3::Zero(),  ///< [N]
            moment = Vec3::Zero();  ///< [N m]
    };
    /// What *LOAD_RIGID_BODY gives at t to a body.
    /// @param x      of all nodes at t, N × 3                                            [m]
    /// @param parts  rows of the parts that the body is made of
    [[nodiscard]] Push push(double t, const Points& x, const std::vector<Index>& parts) const;

    /// f = loads at t.
    ///
    ///     body: -m a(t) (a frame that accelerates upward pulls bodies down), m of its parts; at
    ///     nodes that ride on bodies what their cloth feels beside the whole
    ///     pressure: -p(t) (A n of what the corner has), a third of a triangle; of a quad, in the
    ///     mean of both ways to cut it, (A + A_i) / 6, A_i: the triangle of corner i and its two
    ///     neighbours; in a scene with contact, of the two triangles that contact sees. Positive
    ///     pressure presses against the facet's normal
    ///     node: F(t) along an axis
    void find_force(double t, const Points& x, const std::vector<double>& mass, Points& f) const;

private:
    struct Body {
        int axis;
        double scale;
        Curve curve;                ///< empty: constant 1
        std::vector<Index> parts;   ///< rows; none: all
        std::vector<double> share;  ///< N, of each node's mass; empty: all of it            [-]
        std::vector<std::pair<Index, double>> riding;  ///< nodes on bodies: mass of theirs that
                                                       ///< feels it, less what the body's does

        [[nodiscard]] double value(double t) const {
            return scale * (curve.empty() ? 1.0 : curve(t));
        }
    };
    struct Pressure {
        std::vector<std::array<Index, 4>> facets;  ///< triangles end with a node twice
        double scale, arrival;
        Curve curve;  ///< empty: constant 1
    };
    std::vector<Body> body_;
    struct Node {
        std::vector<Index> nodes;
        int axis;
        double scale;
        Curve curve;
    };
    struct Rigid {
        RigidLoad load;
        Curve curve;
    };
    std::vector<Pressure> pressure_;
    std::vector<Node> node_;
    std::vector<Rigid> rigid_;
};

}  // namespace corpuscle
