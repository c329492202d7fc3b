// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/each_group.hpp"
#include "gas/collisions/lin.hpp"
#include "gas/collisions/lin_few.hpp"
#include "gas/collisions/lin_lanes.hpp"
#include "gas/collisions/relax.hpp"

/// LIN: a group's thermal velocities are mapped by one matrix, such that its stress is reversed
/// rather than only relaxed. What viscosity the free flight between collisions makes is thereby
/// mostly undone.
///
///     v = U + G dx + c,  c' = A c,  A = F' Ω L⁻¹
///
/// G: velocity gradient fitted by least squares, so angular momentum is kept. L Lᵀ = P = sum m c cᵀ
/// (Cholesky), F' F'ᵀ the stress wanted after. Ω: a random rotation.
namespace corpuscle::gas {

namespace {

/// Particles that a velocity gradient can be fitted to.
constexpr std::size_t FIT_FROM = 8;
/// Degrees of freedom along each axis from which a group has a stress to speak of; at least 3.
constexpr double STRESS_FROM = 5.0;
/// L with L Lᵀ = P, unless P is all but singular: Cholesky, 3 sqrt.
std::optional<Mat3> lower_factor(const Mat3& P) {
    const double least = lin::FLATTEST * P.trace();
    Mat3 L = Mat3::Zero();
    for (int j = 0; j < 3; ++j) {
        double pivot = P(j, j);
        for (int k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k);
        if (!(pivot > least)) return std::nullopt;
        L(j, j) = std::sqrt(pivot);
        for (int i = j + 1; i < 3; ++i) {
            double sum = P(i, j);
            for (int k = 0; k < j; ++k) sum -= L(i, k) * L(j, k);
            L(i, j) = sum / L(j, j);
        }
    }
    return L;
}

/// Inverse of a lower triangle.
Mat3 inverse_of(const Mat3& L) {
    Mat3 inverse = Mat3::Identity();
    L.triangularView<Eigen::Lower>().solveInPlace(inverse);
    return inverse;
}

/// Least-squares velocity gradients of a group.
class GradientFit {
public:
    /// None for a group that is too small, or all but in a plane.
    static std::optional<GradientFit> of(const CellSample& sample) {
        if (sample.size() < FIT_FROM) return std::nullopt;
        const std::optional<Mat3> L = lower_factor(sample.moment(sample.dx, sample.dx));
        if (!L) return std::nullopt;
        return GradientFit(inverse_of(*L));
    }
    /// Takes the gradient out of c and returns it: G = sum m c dxᵀ S⁻¹, S = sum m dx dxᵀ.  [1/s]
    Mat3 take_out(CellSample& sample) const {
        const Mat3 G = sample.moment(sample.c, sample.dx) * inverse_L_.transpose() * inverse_L_;
        sample.add_gradient(-G);
        return G;
    }
    /// A gradient as thermal agitation makes it at kT: rows are normal with covariance kT S⁻¹.
    [[nodiscard]] Mat3 thermal(double kT, Random& draw) const {
        Mat3 normal;
        for (int i = 0; i < 9; ++i) normal(i) = draw.normal();
        return std::sqrt(kT) * normal * inverse_L_;
    }

private:
    explicit GradientFit(const Mat3& inverse_L) : inverse_L_(inverse_L) {}
    Mat3 inverse_L_;  ///< S = L Lᵀ
};

/// A factor, F Fᵀ ~ P', of the stress wanted after the collision: that of P turned round.
///
/// At equilibrium P has Wishart's distribution with n degrees of freedom, and the entries of its
/// Cholesky factor are independent: beside the diagonal normal, on it roots of chi² with n, n-1,
/// n-2 degrees [Bartlett 1933], whose cube roots are nearly normal [Wilson & Hilferty 1931]. Each
/// is turned about its mean, and thermal noise makes up for what is lost: z' = -β z + sqrt(1 - β²)
/// ξ. Fluctuations then stay those of equilibrium. (Without noise U and G would be colder than the
/// gas: by 1 % of all translational energy at 14 particles a group.) The axes are taken in random
/// order.
Mat3 turned_factor(const Mat3& P, double n, Random& draw) {
    const int first = static_cast<int>(draw.below(3));
    const std::array<int, 3> axis = {first, (first + 1) % 3, (first + 2) % 3};
    Mat3 ordered;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) ordered(i, j) = P(axis[i], axis[j]);
    const std::optional<Mat3> L = lower_factor(ordered);
    if (!L) return std::sqrt(P.trace() / 3.0) * Mat3::Identity();

    const double kT = P.trace() / (3.0 * n);
    Mat3 F = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < i; ++j)
            F(axis[i], j) =
                -lin::BETA * (*L)(i, j) + lin::NOISE * std::sqrt(kT) * nearly_normal(draw);
        const double k = n - i, variance = 2.0 / (9.0 * k), mean = 1.0 - variance;
        const double z = std::cbrt((*L)(i, i) * (*L)(i, i) / (k * kT)) - mean;
        const double turned =
            mean - lin::BETA * z + lin::NOISE * std::sqrt(variance) * nearly_normal(draw);
        const double kept = std::max(turned, lin::LEAST_TURNED);
        F(axis[i], i) = std::sqrt(k * kT * kept * kept * kept);
    }
    return F;
}

/// A with A P Aᵀ = F Fᵀ, or merely a rotation where P is not that of a gas.
Mat3 mapping(const Mat3& P, const Mat3& F, Random& draw) {
    const Mat3 turn = random_rotation(draw);
    const std::optional<Mat3> L = lower_factor(P);
    return L ? Mat3(F * turn * inverse_of(*L)) : turn;
}

/// Pair collisions between light and heavy particles, which a linear map would bring to one
/// temperature but slowly. They would lose angular momentum: so c, which has no gradient, is lent a
/// thermal one, and whatever gradient it has afterwards is taken out. At equilibrium that leaves c
/// as it was distributed.
void exchange(const GradientFit& fit, double kT, CellSample& sample, Random& draw) {
    sample.add_gradient(fit.thermal(kT, draw));
    sample.collide_unlike(draw);
    fit.take_out(sample);
}

bool collide_group(const CollisionStep& step, CellSample& sample, Random& draw) {
    const double E_all = sample.translational();
    if (is_rigid(sample, E_all)) return relax(step.mixture, sample, draw);
    const std::optional<GradientFit> fit = GradientFit::of(sample);
    if (!fit) return collide_few(step, sample, draw);
    const double energy = E_all + sample.internal() + sample.heat;

    // Motion in common: U and G. What is left is c, of energy E_0.
    const Mat3 G = fit->take_out(sample);
    const Mat3 P_0 = sample.moment(sample.c, sample.c);
    const double E_0 = 0.5 * P_0.trace();
    const double E_gradient = E_all - E_0;

    // Its energy at equilibrium, E_1.
    const double along_each_axis = static_cast<double>(sample.size()) - lin::FITTED;
    const double freedom = 3.0 * along_each_axis;
    const bool has_heat = !is_rigid(sample, E_0);
    std::optional<double> E_1;
    if (has_heat)
        E_1 = share(energy - E_gradient, freedom, step.mixture, Fluctuation::IN_GAS, sample, draw);
    if (!E_1) {
        sample.add_gradient(G);
        return leave_unrelaxed(sample) || !has_heat;
    }

    if (sample.is_mixed()) exchange(*fit, 2.0 * E_0 / freedom, sample, draw);
    const Mat3 P = sample.is_mixed() ? sample.moment(sample.c, sample.c) : P_0;
    const Mat3 A = along_each_axis >= STRESS_FROM
                       ? mapping(P, turned_factor(P_0, along_each_axis, draw), draw)
                       : random_rotation(draw);
    const double exact = std::sqrt(2.0 * *E_1 / (A * P * A.transpose()).trace());
    sample.transform(exact * A);
    sample.add_gradient(G);
    return true;
}

/// Asks the memory for particles that will be collided soon: rows of a group lie apart until they
/// are moved again (CellSort), which no processor foresees.
void fetch(std::span<const Index> rows, const Particles& particles) {
    for (const Index row : rows) {
        __builtin_prefetch(&particles.x[row]);
        __builtin_prefetch(&particles.v[row]);
        __builtin_prefetch(&particles.e[row]);
    }
}

}  // namespace

CollisionReport collide_lin_plainly(const CollisionStep& step, Particles& particles) {
    return for_each_group(step, particles, [&](CellSample& sample, Random& draw, auto rows) {
        sample.gather_places(rows, particles);
        return collide_group(step, sample, draw);
    });
}

/// Large groups of one kind of gas by fours; all others one by one.
CollisionReport collide_lin(const CollisionStep& step, Particles& particles) {
    constexpr std::size_t AHEAD = 2, LEAST = 4, MOST = 16, CHUNKS = 512;
    const std::size_t a_chunk =
        LEAST * std::clamp<std::size_t>(step.groups.size() / (LEAST * CHUNKS), 1, MOST / LEAST);
    const auto plainly = [&](std::size_t g) {
        return collide_one_group(step, g, particles,
                                 [&](CellSample& sample, Random& draw, auto rows) {
                                     sample.gather_places(rows, particles);
                                     return collide_group(step, sample, draw);
                                 });
    };
    const auto some = [&](std::size_t chunk) {
        CollisionReport report;
        LinLanes four(step.mixture);
        const auto collide_four = [&] {
            const auto thermal =
                four.collide(particles, [&](std::uint64_t g) { report += plainly(g); });
            for (const double energy : thermal) report.thermal += energy;
        };
        const std::size_t end = std::min(step.groups.size(), (chunk + 1) * a_chunk);
        for (std::size_t g = chunk * a_chunk; g < end; ++g) {
            const auto rows = step.groups[g];
            if (g + AHEAD < end) fetch(step.groups[g + AHEAD], particles);
            const Random draw(step.seed, Stream::COLLISION, step.step, g);
            if (rows.size() < LinLanes::FEWEST ||
                !four.add(rows, g, step.heat_of(rows, particles), draw, particles))
                report += plainly(g);
            else if (four.size() == FOUR)
                collide_four();
        }
        if (four.size() > 0) collide_four();
        return report;
    };
    return parallel::sum(parallel::chunk_count(step.groups.size(), a_chunk), CollisionReport{},
                         some, 1);
}

}  // namespace corpuscle::gas
