// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "solver/base/error.hpp"

namespace corpuscle {
namespace {

constexpr int MOST_SWEEPS = 30;
constexpr double CONVERGED = 1e-14;  ///< gap over coordinates
constexpr double APART = 1e-6;       ///< the same, where holds keep a joint open
constexpr double FLOOR = 1e-12;      ///< on S's diagonal, for joints that say one thing twice

}  // namespace

RigidJoints::RigidJoints(const Model& model, const std::vector<RigidBody>& bodies)
    : passed_on_(bodies.size(), Vec3::Zero()) {
    for (const RigidJoint& joint : model.rigid_joints) {
        Pin pin;
        pin.name = joint.name;
        pin.joint = given_.size();
        given_.emplace_back();
        for (std::size_t k = 0; k < 2; ++k) pin.bodies[k] = body_of(bodies, joint.parts[k]);
        if (pin.bodies[0] < 0 || pin.bodies[1] < 0 || pin.bodies[0] == pin.bodies[1])
            throw InputError(joint.name + ": joins one body with itself, expected two");
        for (const Vec3& place : joint.places) {
            for (std::size_t k = 0; k < 2; ++k) pin.arms[k] = bodies[pin.bodies[k]].arm_of(place);
            pins_.push_back(pin);
            rows_ += pin.rows;
            pin.rows = 2;
        }
    }
}

/// Places and directions at t.
void RigidJoints::look(const std::vector<RigidBody>& bodies) {
    for (std::size_t p = 0; p < pins_.size(); ++p) {
        Pin& pin = pins_[p];
        pin.place =
            0.5 * (bodies[pin.bodies[0]].at(pin.arms[0]) + bodies[pin.bodies[1]].at(pin.arms[1]));
        pin.directions = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
        if (pin.rows == 3) continue;
        const Vec3 axis = (pin.place - pins_[p - 1].place).normalized();
        pin.directions[0] = axis.unitOrthogonal();
        pin.directions[1] = axis.cross(pin.directions[0]);
    }
}

/// S, from what an impulse of one along each row's direction does to all others.
void RigidJoints::factor(const std::vector<contact::RigidProxy>& proxies) {
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(rows_, rows_);
    Eigen::Index column = 0;
    for (const Pin& from : pins_)
        for (int j = 0; j < from.rows; ++j, ++column) {
            Eigen::Index row = 0;
            for (const Pin& to : pins_)
                for (int i = 0; i < to.rows; ++i, ++row)
                    for (int a = 0; a < 2; ++a)
                        for (int b = 0; b < 2; ++b) {
                            if (from.bodies[a] != to.bodies[b]) continue;
                            const contact::RigidProxy& body = proxies[from.bodies[a]];
                            const Vec3& d = from.directions[j];
                            const Vec3 turned =
                                body.inverse_inertia * (from.place - body.centre).cross(d);
                            const Vec3 moved =
                                body.inverse_mass * d + turned.cross(to.place - body.centre);
                            S(row, column) += (a == b ? 1.0 : -1.0) * to.directions[i].dot(moved);
                        }
        }
    double greatest = 0.0;
    for (Eigen::Index row = 0; row < rows_; ++row) greatest = std::max(greatest, S(row, row));
    S.diagonal().array() += FLOOR * greatest;
    mobility_.compute(S);
}

/// give(body, impulse, place) for each body of each pin.
template <class Give>
void RigidJoints::share(const Eigen::VectorXd& impulse, Give&& give) {
    Eigen::Index row = 0;
    Vec3 first = Vec3::Zero();
    for (const Pin& pin : pins_) {
        Vec3 J = Vec3::Zero();
        for (int i = 0; i < pin.rows; ++i, ++row) J += impulse[row] * pin.directions[i];
        if (pin.rows == 3) first = pin.place;
        given_[pin.joint].impulse += J;
        given_[pin.joint].turning += (pin.place - first).cross(J);
        give(pin.bodies[0], J, pin.place);
        give(pin.bodies[1], Vec3(-J), pin.place);
    }
}

void RigidJoints::hold(double t, double dt, double span, After after,
                       std::vector<RigidBody>& bodies, std::vector<contact::RigidProxy>& proxies,
                       fabric::Nodes& nodes) {
    if (empty()) return;
    if (after == After::KICK) std::fill(passed_on_.begin(), passed_on_.end(), Vec3::Zero());
    look(bodies);
    factor(proxies);
    Eigen::VectorXd gap(rows_);
    for (int sweep = 0; sweep < MOST_SWEEPS; ++sweep) {
        Eigen::Index row = 0;
        double size = 0.0, widest = 0.0;
        const Pin* open = &pins_.front();
        for (const Pin& pin : pins_) {
            const Vec3 then = bodies[pin.bodies[0]].then(pin.arms[0]);
            const Vec3 apart = then - bodies[pin.bodies[1]].then(pin.arms[1]);
            for (int i = 0; i < pin.rows; ++i, ++row) gap[row] = pin.directions[i].dot(apart);
            size = std::max({size, then.norm(), pin.arms[0].norm(), pin.arms[1].norm()});
            if (apart.norm() <= widest) continue;
            widest = apart.norm();
            open = &pin;
        }
        if (gap.cwiseAbs().maxCoeff() <= CONVERGED * size) break;
        if (sweep + 1 == MOST_SWEEPS && widest > APART * size)
            throw PhysicsError(t, fmt::format("{}: what holds its bodies keeps them {:.3g} apart",
                                              open->name, widest));
        share(mobility_.solve(-gap / dt), [&](Index b, const Vec3& J, const Vec3& place) {
            bodies[b].pull(proxies[b], J, (place - proxies[b].centre).cross(J), span,
                           after == After::KICK);
        });
        for (const Pin& pin : pins_)
            for (const Index b : pin.bodies) bodies[b].foresee(dt);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (std::none_of(pins_.begin(), pins_.end(), [&](const Pin& pin) {
                return pin.bodies[0] == static_cast<Index>(b) ||
                       pin.bodies[1] == static_cast<Index>(b);
            }))
            continue;
        bodies[b].carry(dt, nodes);
        if (after == After::CONTACT) continue;
        bodies[b].book_kick();
        proxies[b] = bodies[b].proxy();
    }
}

double RigidJoints::pass_on(std::vector<contact::RigidProxy>& proxies) {
    if (empty()) return 0.0;
    Eigen::VectorXd apart(rows_);
    Eigen::Index row = 0;
    const auto gained = [&](Index b, const Vec3& place) {
        const contact::RigidProxy& body = proxies[b];
        return Vec3(body.inverse_mass * body.impulse +
                    (body.inverse_inertia * body.turning).cross(place - body.centre));
    };
    for (const Pin& pin : pins_) {
        const Vec3 v = gained(pin.bodies[0], pin.place) - gained(pin.bodies[1], pin.place);
        for (int i = 0; i < pin.rows; ++i, ++row) apart[row] = pin.directions[i].dot(v);
    }
    double work = 0.0;
    if (apart.isZero(0.0)) return work;
    share(mobility_.solve(-apart), [&](Index b, const Vec3& J, const Vec3& place) {
        work += proxies[b].push(J, place);
        passed_on_[b] += J;
    });
    return work;
}

std::vector<int> RigidJoints::ids() const {
    std::vector<int> numbers;
    for (const Pin& pin : pins_)
        if (pin.rows == 3) numbers.push_back(std::stoi(pin.name.substr(pin.name.rfind(' ') + 1)));
    const std::set<int> distinct(numbers.begin(), numbers.end());
    if (distinct.size() < numbers.size()) std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

std::vector<RigidJoints::Given> RigidJoints::take_given() {
    return std::exchange(given_, std::vector<Given>(given_.size()));
}

}  // namespace corpuscle
