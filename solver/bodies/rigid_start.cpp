// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_start.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

#include "solver/bodies/free_rotation.hpp"
#include "solver/bodies/rigid_parts.hpp"

namespace corpuscle {
namespace {

/// Nodes at the start.
struct StartNodes {
    const Model& model;
    const std::vector<double>& mass;
    const Points& v;
};

/// A part's or body's mass, and how it moves.
struct Moving {
    double mass = 0.0;
    Vec3 centre = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();  ///< about the centre
    Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

/// I of a mass at r.
Mat3 point_inertia(double mass, const Vec3& r) {
    return mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

/// ω of I ω = turning.                                                                 [rad/s]
Vec3 start_spin(const Mat3& inertia, const Vec3& turning) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia);
    const Mat3& axes = principal.eigenvectors();
    return axes * spin_by(principal_moments(principal.eigenvalues()), axes.transpose() * turning);
}

const RigidInertia* own_inertia(const Model& model, Index part) {
    for (const RigidInertia& body : model.rigid_inertia)
        if (body.part == part) return &body;
    return nullptr;
}

/// Of nodes with some weights.
Moving mean_motion(const StartNodes& nodes, const std::map<Index, double>& weight) {
    Moving body;
    for (const auto& [node, m] : weight) {
        body.mass += m;
        body.centre += m * nodes.model.x[node];
        body.velocity += m * nodes.v[node];
    }
    if (!(body.mass > 0.0)) return body;
    body.centre /= body.mass;
    body.velocity /= body.mass;
    Vec3 turning = Vec3::Zero();
    for (const auto& [node, m] : weight) {
        const Vec3 r = nodes.model.x[node] - body.centre;
        body.inertia += point_inertia(m, r);
        turning += m * r.cross(nodes.v[node] - body.velocity);
    }
    body.spin = start_spin(body.inertia, turning);
    return body;
}

/// Of a part whose nodes' masses are not its own: the areas of its shells, else these masses, else
/// 1 each.
std::map<Index, double> weights_of(const StartNodes& nodes, Index part) {
    std::map<Index, double> weight;
    for (const Shell& shell : nodes.model.shells) {
        if (shell.part != part) continue;
        const auto x = [&](int i) -> const Vec3& { return nodes.model.x[shell.nodes[i]]; };
        const double area =
            0.5 * (x(2) - x(0)).cross(shell.is_triangle() ? x(1) - x(0) : x(3) - x(1)).norm();
        const int corners = shell.is_triangle() ? 3 : 4;
        for (int i = 0; i < corners; ++i) weight[shell.nodes[i]] += area / corners;
    }
    if (!weight.empty()) return weight;
    double all = 0.0;
    for (const Index n : nodes_of_rigid_parts(nodes.model, {part}))
        all += weight[n] = nodes.mass[n];
    if (all == 0.0)
        for (auto& [node, w] : weight) w = 1.0;
    return weight;
}

/// Of a part with a mass of its own, as its nodes move.
Moving motion_of(const StartNodes& nodes, const RigidInertia& own) {
    Moving body = mean_motion(nodes, weights_of(nodes, own.part));
    if (!(body.mass > 0.0)) return body;
    body.velocity += body.spin.cross(own.centre - body.centre);
    body.mass = own.mass;
    body.centre = own.centre;
    body.inertia = own.inertia;
    return body;
}

/// Of parts whose mass is that of their nodes; the tensors of *ELEMENT_INERTIA turn with them.
Moving motion_of(const StartNodes& nodes, const std::vector<Index>& parts) {
    std::map<Index, double> mass;
    for (const Index n : nodes_of_rigid_parts(nodes.model, parts)) mass[n] = nodes.mass[n];
    Moving body = mean_motion(nodes, mass);
    for (const NodeInertia& tensor : nodes.model.node_inertias)
        if (mass.contains(tensor.node)) body.inertia += tensor.inertia;
    return body;
}

/// Bodies that become one keep their momentum and angular momentum.
Moving joined(const std::vector<Moving>& bodies) {
    Moving all;
    for (const Moving& body : bodies) {
        all.mass += body.mass;
        all.centre += body.mass * body.centre;
        all.velocity += body.mass * body.velocity;
    }
    all.centre /= all.mass;
    all.velocity /= all.mass;
    Vec3 turning = Vec3::Zero();
    for (const Moving& body : bodies) {
        const Vec3 r = body.centre - all.centre;
        all.inertia += body.inertia + point_inertia(body.mass, r);
        turning += body.inertia * body.spin + body.mass * r.cross(body.velocity - all.velocity);
    }
    all.spin = start_spin(all.inertia, turning);
    return all;
}

RigidVelocity start_of(const StartNodes& nodes, Index lead) {
    const Model& model = nodes.model;
    std::vector<Moving> bodies;
    std::vector<Index> others;
    for (const Index part : merged_parts(model, lead)) {
        if (const RigidInertia* own = own_inertia(model, part))
            bodies.push_back(motion_of(nodes, *own));
        else
            others.push_back(part);
    }
    if (!others.empty()) bodies.push_back(motion_of(nodes, others));
    std::erase_if(bodies, [](const Moving& body) { return !(body.mass > 0.0); });
    if (bodies.empty()) return {lead};
    const Moving all = bodies.size() == 1 ? bodies.front() : joined(bodies);
    RigidVelocity start{lead, all.velocity, all.spin};
    const auto keeps = [&](const RigidMerge& m) { return m.lead == lead && m.keeps_inertia; };
    if (const RigidInertia* own = own_inertia(model, lead);
        own != nullptr && std::any_of(model.rigid_merges.begin(), model.rigid_merges.end(), keeps))
        start.velocity += all.spin.cross(own->centre - all.centre);
    return start;
}

}  // namespace

void start_rigid_parts(Model& model, const std::vector<double>& node_mass, const Points& velocity) {
    const auto rests = [](const Vec3& v) { return v.isZero(0.0); };
    if (std::all_of(velocity.begin(), velocity.end(), rests)) return;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        const bool has_own = std::any_of(model.rigid_velocity.begin(), model.rigid_velocity.end(),
                                         [&](const RigidVelocity& v) { return v.part == part; });
        const bool is_led = std::any_of(model.rigid_merges.begin(), model.rigid_merges.end(),
                                        [&](const RigidMerge& m) { return m.part == part; });
        if (!is_rigid(model, part) || is_led || has_own) continue;
        const RigidVelocity rigid = start_of({model, node_mass, velocity}, part);
        if (!rigid.velocity.isZero(0.0) || !rigid.spin.isZero(0.0))
            model.rigid_velocity.push_back(rigid);
    }
}

}  // namespace corpuscle
