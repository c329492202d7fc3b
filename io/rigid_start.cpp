// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/rigid_start.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

namespace corpuscle::io {

namespace {

/// A share of each shell's area at its corners: mass, up to a factor that a rigid part has once.
std::map<Index, double> corner_areas(const Model& model, Index part) {
    std::map<Index, double> area;
    for (const Shell& shell : model.shells) {
        if (shell.part != part) continue;
        const auto x = [&](std::size_t i) -> const Vec3& {
            return model.x[static_cast<std::size_t>(shell.nodes[i])];
        };
        const double a =
            0.5 * (x(2) - x(0)).cross(shell.is_triangle() ? x(1) - x(0) : x(3) - x(1)).norm();
        const std::size_t corners = shell.is_triangle() ? 3 : 4;
        for (std::size_t i = 0; i < corners; ++i)
            area[shell.nodes[i]] += a / static_cast<double>(corners);
    }
    return area;
}

/// V = sum m v / sum m,   I spin = sum m r x v about the centre of mass.
RigidVelocity motion(const Model& model, Index part) {
    const std::map<Index, double> mass = corner_areas(model, part);
    RigidVelocity rigid;
    rigid.part = part;
    double total = 0.0;
    Vec3 centre = Vec3::Zero();
    for (const auto& [node, m] : mass) {
        total += m;
        centre += m * model.x[static_cast<std::size_t>(node)];
        rigid.velocity += m * model.velocity[static_cast<std::size_t>(node)];
    }
    if (!(total > 0.0)) return rigid;
    centre /= total;
    rigid.velocity /= total;
    Mat3 inertia = Mat3::Zero();
    Vec3 turning = Vec3::Zero();
    for (const auto& [node, m] : mass) {
        const Vec3 r = model.x[static_cast<std::size_t>(node)] - centre;
        inertia += m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
        turning += m * r.cross(model.velocity[static_cast<std::size_t>(node)] - rigid.velocity);
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia);
    for (int axis = 0; axis < 3; ++axis) {
        const double moment = principal.eigenvalues()[axis];
        const Vec3 along = principal.eigenvectors().col(axis);
        // a straight row of nodes has no moment about itself, and no spin
        if (moment > 1e-12 * principal.eigenvalues()[2])
            rigid.spin += along.dot(turning) / moment * along;
    }
    for (const RigidInertia& body : model.rigid_inertia)  // the velocity is that of its centre
        if (body.part == part) rigid.velocity += rigid.spin.cross(body.centre - centre);
    return rigid;
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
        if (!is_rigid || has_own) continue;
        const RigidVelocity rigid = motion(model, part);
        if (!rigid.velocity.isZero(0.0) || !rigid.spin.isZero(0.0))
            model.rigid_velocity.push_back(rigid);
    }
}

}  // namespace corpuscle::io
