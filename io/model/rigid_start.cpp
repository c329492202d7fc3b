// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/rigid_start.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

#include "solver/bodies/rigid_parts.hpp"

namespace corpuscle::io {

namespace {

/// Mass of a body's nodes: of each shell density · thickness · area, a share at each corner; or
/// the area alone, where the body has a mass of its own.
std::map<Index, double> corner_masses(const Model& model, const std::vector<Index>& parts,
                                      bool has_own_mass) {
    std::map<Index, double> mass;
    for (const Shell& shell : model.shells) {
        if (std::find(parts.begin(), parts.end(), shell.part) == parts.end()) continue;
        const auto x = [&](std::size_t i) -> const Vec3& {
            return model.x[static_cast<std::size_t>(shell.nodes[i])];
        };
        const double area =
            0.5 * (x(2) - x(0)).cross(shell.is_triangle() ? x(1) - x(0) : x(3) - x(1)).norm();
        const Part& part = model.parts[static_cast<std::size_t>(shell.part)];
        const auto& card = model.materials[static_cast<std::size_t>(part.material)].card;
        const double per_area =
            has_own_mass ? 1.0 : std::get<fabric::RigidCard>(card).density * part.thickness;
        const std::size_t corners = shell.is_triangle() ? 3 : 4;
        for (std::size_t i = 0; i < corners; ++i)
            mass[shell.nodes[i]] += per_area * area / static_cast<double>(corners);
    }
    return mass;
}

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

/// spin of I spin = turning
Vec3 spin_by(const Mat3& inertia, const Vec3& turning) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia);
    Vec3 spin = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const double moment = principal.eigenvalues()[axis];
        const Vec3 along = principal.eigenvectors().col(axis);
        // a straight row of nodes has no moment about itself, and no spin
        if (moment > 1e-12 * principal.eigenvalues()[2])
            spin += along.dot(turning) / moment * along;
    }
    return spin;
}

const RigidInertia* given(const Model& model, Index part) {
    for (const RigidInertia& body : model.rigid_inertia)
        if (body.part == part) return &body;
    return nullptr;
}

/// V = sum m v / sum m,   I spin = sum m r x v about the centre of mass; parts of one mass.
Moving motion(const Model& model, const std::vector<Index>& parts, const RigidInertia* own) {
    const std::map<Index, double> mass = corner_masses(model, parts, own != nullptr);
    Moving body;
    for (const auto& [node, m] : mass) {
        body.mass += m;
        body.centre += m * model.x[static_cast<std::size_t>(node)];
        body.velocity += m * model.velocity[static_cast<std::size_t>(node)];
    }
    if (!(body.mass > 0.0)) return body;
    body.centre /= body.mass;
    body.velocity /= body.mass;
    Vec3 turning = Vec3::Zero();
    for (const auto& [node, m] : mass) {
        const Vec3 r = model.x[static_cast<std::size_t>(node)] - body.centre;
        body.inertia += point_inertia(m, r);
        turning += m * r.cross(model.velocity[static_cast<std::size_t>(node)] - body.velocity);
    }
    body.spin = spin_by(body.inertia, turning);
    if (own == nullptr) return body;
    body.velocity += body.spin.cross(own->centre - body.centre);  // that of its own centre
    body.mass = own->mass;
    body.centre = own->centre;
    body.inertia = own->inertia;
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
    all.spin = spin_by(all.inertia, turning);
    return all;
}

RigidVelocity start_of(const Model& model, Index lead) {
    std::vector<Moving> bodies;
    std::vector<Index> others;
    for (const Index part : merged_parts(model, lead)) {
        if (const RigidInertia* own = given(model, part))
            bodies.push_back(motion(model, {part}, own));
        else
            others.push_back(part);
    }
    if (!others.empty()) bodies.push_back(motion(model, others, nullptr));
    std::erase_if(bodies, [](const Moving& body) { return !(body.mass > 0.0); });
    if (bodies.empty()) return {lead};
    const Moving all = bodies.size() == 1 ? bodies.front() : joined(bodies);
    RigidVelocity start{lead, all.velocity, all.spin};
    const auto keeps = [&](const RigidMerge& m) { return m.lead == lead && m.keeps_inertia; };
    if (std::any_of(model.rigid_merges.begin(), model.rigid_merges.end(), keeps))
        start.velocity += all.spin.cross(given(model, lead)->centre - all.centre);
    return start;
}

}  // namespace

void start_rigid_parts(Model& model) {
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        const Index material = model.parts[p].material;
        const bool is_rigid =
            material >= 0 && std::holds_alternative<fabric::RigidCard>(
                                 model.materials[static_cast<std::size_t>(material)].card);
        const bool has_own = std::any_of(model.rigid_velocity.begin(), model.rigid_velocity.end(),
                                         [&](const RigidVelocity& v) { return v.part == part; });
        const bool is_led = std::any_of(model.rigid_merges.begin(), model.rigid_merges.end(),
                                        [&](const RigidMerge& m) { return m.part == part; });
        if (!is_rigid || is_led || has_own) continue;
        const RigidVelocity rigid = start_of(model, part);
        if (!rigid.velocity.isZero(0.0) || !rigid.spin.isZero(0.0))
            model.rigid_velocity.push_back(rigid);
    }
}

}  // namespace corpuscle::io
