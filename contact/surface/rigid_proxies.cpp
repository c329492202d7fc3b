// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface/rigid_proxies.hpp"

#include <Eigen/Eigenvalues>

namespace corpuscle::contact {
namespace {

Mat3 cross_matrix(const Vec3& a) {
    Mat3 out;
    out << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
    return out;
}

/// A⁻¹ b of a symmetric A >= 0, as far as it has one: along axes of no mobility nothing is given.
Vec3 solve(const Mat3& A, const Vec3& b) {
    constexpr double LEAST = 1e-12;  ///< of the greatest eigenvalue
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(A);
    Vec3 out = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double value = principal.eigenvalues()[k];
        const Vec3 axis = principal.eigenvectors().col(k);
        if (value > LEAST * principal.eigenvalues()[2]) out += axis.dot(b) / value * axis;
    }
    return out;
}

/// What an impulse of one along `direction` between a contact's places makes of their rate, by the
/// body with this number alone.                                                          [1/kg]
double inverse_mass(const RigidProxy& body, Index number, const Cloth& cloth, const Points& x,
                    const Contact& c, const Vec3& direction) {
    double weight = 0.0;
    Vec3 arm = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
        if (cloth.body[c.node[i]] != number) continue;
        weight += c.weight[i];
        arm += c.weight[i] * (x[c.node[i]] - body.centre);
    }
    const Vec3 moment = arm.cross(direction);
    return weight * weight * direction.dot(body.inverse_mass * direction) +
           moment.dot(body.inverse_inertia * moment);
}

}  // namespace

Mat3 RigidProxy::mobility(const Vec3& at) const {
    const Mat3 arm = cross_matrix(at - centre);
    return inverse_mass - arm * inverse_inertia * arm;
}

double RigidProxy::take(const BodyImpulse& by) {
    impulse += by.linear;
    turning += by.turning;
    velocity_change += inverse_mass * by.linear;
    spin_change += inverse_inertia * by.turning;
    return -by.linear.dot(held_velocity) - by.turning.dot(held_spin);
}

double mass_along(const Cloth& cloth, std::span<const RigidProxy> bodies, const Points& x,
                  const Contact& c, const Vec3& direction) {
    double inverse = 0.0;
    for (int i = 0; i < 4; ++i)
        inverse += c.weight[i] * c.weight[i] * direction.cwiseAbs2().dot(cloth.mobility[c.node[i]]);
    for_bodies_of(cloth, c,
                  [&](Index b) { inverse += inverse_mass(bodies[b], b, cloth, x, c, direction); });
    return 1.0 / inverse;
}

Contact contact_at(const Cloth& cloth, std::span<const RigidProxy> bodies, const Points& x,
                   const Pair& pair, const Nearest& nearest, double gap) {
    double inverse = 0.0;
    for (int i = 0; i < 4; ++i)
        inverse += nearest.weight[i] * nearest.weight[i] * cloth.inverse_mass[pair.node[i]];
    Contact c{pair.node, nearest.weight, nearest.apart / gap, gap, 1.0 / inverse, pair.is_edges};
    const bool has_held_axis = std::any_of(pair.node.begin(), pair.node.end(), [&](Index n) {
        const Vec3& m = cloth.mobility[n];
        return m.minCoeff() < m.maxCoeff();
    });
    const bool has_body = cloth.has_body(pair);
    if (has_held_axis || has_body) c.mass = mass_along(cloth, bodies, x, c, c.normal);
    if (has_body) for_bodies_of(cloth, c, [&](Index b) { c.on_body |= bodies[b].is_movable(); });
    return c;
}

double VelocityState::push(Index node, const Vec3& impulse) {
    assert(has_begun_);
    if (const Index body = cloth_.body[node]; body >= 0)
        return bodies_[body].push(impulse, x_[node]);
    const double work = held_work(node, impulse);
    v_[node] += cloth_.mobility[node].cwiseProduct(impulse);
    return work;
}

double VelocityState::held_work(Index node, const Vec3& impulse) const {
    if (const Index body = cloth_.body[node]; body >= 0) {
        const RigidProxy& of = bodies_[body];
        const Vec3 moment = (x_[node] - of.centre).cross(impulse);
        return -impulse.dot(of.held_velocity) - moment.dot(of.held_spin);
    }
    double work = 0.0;
    for (int k = 0; k < 3; ++k)
        if (cloth_.mobility[node][k] == 0.0) work -= impulse[k] * v_[node][k];
    return work;
}

VelocityState::Joined VelocityState::join(Index node, Index body) {
    const Index own = cloth_.body[node];
    if (own == body) return {};
    const Vec3& at = x_[node];
    RigidProxy& anchor = bodies_[body];
    const Vec3 apart = velocity(node) - anchor.velocity_at(at);
    Mat3 mobility = anchor.mobility(at);
    if (own >= 0)
        mobility += bodies_[own].mobility(at);
    else
        mobility += cloth_.inverse_mass[node] * Mat3::Identity();
    const Vec3 impulse = solve(mobility, apart);
    Joined out;
    out.held_work = push(node, -impulse) + anchor.push(impulse, at);
    out.taken = 0.5 * impulse.dot(apart + velocity(node) - anchor.velocity_at(at));
    return out;
}

void VelocityState::settle() {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        RigidProxy& body = bodies_[b];
        if (body.velocity_change.isZero(0.0) && body.spin_change.isZero(0.0)) continue;
        for (const Index n : cloth_.nodes_of_body(b)) v_[n] += body.change_at(x_[n]);
        body.velocity += body.velocity_change;
        body.spin += body.spin_change;
        body.velocity_change = body.spin_change = Vec3::Zero();
    }
}

}  // namespace corpuscle::contact
