// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/lin_lanes.hpp"

#include <algorithm>

#include "gas/collisions/deviation.hpp"
#include "gas/collisions/lin.hpp"
#include "gas/collisions/relax.hpp"

namespace corpuscle::gas {

namespace {

/// x, y, z and one: products with it add up the sums as well.
Four with_one(const Vec3& a) {
    return Four{a[0], a[1], a[2], 1.0};
}

Four in_order(const Four& first, const Four& second, const Four& third, const Four& axis) {
    return axis == 0.0 ? first : axis == 1.0 ? second : third;
}

}  // namespace

bool LinLanes::add(std::span<const Index> rows, std::uint64_t group, const Heat& heat, Random draw,
                   const Particles& particles) {
    const std::int32_t species = mixture_.kind(particles.species[rows[0]]);
    const Vec3 x_0 = particles.x[rows[0]], v_0 = particles.v[rows[0]];
    std::array<Four, 3> xx{}, vx{}, vv{};
    double e = 0.0, least = particles.e[rows[0]];
    bool is_mixed = false;
    for (const Index row : rows) {
        is_mixed |= mixture_.kind(particles.species[row]) != species;
        const Four x = with_one(particles.x[row] - x_0), v = with_one(particles.v[row] - v_0);
        for (int k = 0; k < 3; ++k) {
            xx[k] += x[k] * x;
            vx[k] += x[k] * v;
            vv[k] += v[k] * v;
        }
        e += particles.e[row];
        least = std::min(least, particles.e[row]);
    }
    if (is_mixed) return false;

    const std::size_t l = size_++;
    for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) {
            xx_[j][k][l] = xx[k][j];
            vx_[j][k][l] = vx[k][j];
            vv_[j][k][l] = vv[k][j];
        }
        x_[k][l] = xx[k][3];
        v_[k][l] = vv[k][3];
        first_v_[k][l] = v_0[k];
    }
    rows_[l] = rows;
    group_[l] = group;
    species_[l] = species;
    e_[l] = e;
    least_[l] = least;
    n_[l] = static_cast<double>(rows.size());
    m_[l] = mixture_.particle_mass(species);
    factor_[l] = heat.factor;
    added_[l] = heat.per_mass * m_[l] * n_[l];
    share_[l] = nearly_normal(draw);
    axis_[l] = draw.below(3);
    for (auto& by_lane : stress_) by_lane[l] = nearly_normal(draw);
    for (auto& by_lane : turn_) by_lane[l] = draw.uniform();
    return true;
}

/// Thermal energy shared out, as gas::share() does it with Fluctuation::IN_GAS.
struct LinLanes::Energy {
    Four lowest, kept, translational;
    FourBits is_good;
};

/// @param motion  energy of the motion relative to U, @param thermal  that of c alone          [J]
LinLanes::Energy LinLanes::share(const Four& motion, const Four& thermal) const {
    const Four n = load_four(n_.data()), before = load_four(e_.data());
    const Four energy = load_four(factor_.data()) * (motion + before) + load_four(added_.data()) -
                        (motion - thermal);
    const Four freedom = 3.0 * (n - lin::FITTED);
    const Four T = temperature(energy, freedom);
    Four inside, slope, curvature;
    for (int l = 0; l < FOUR; ++l) {
        const EnergyPolynomial& internal = mixture_.particle_internal(species_[l]);
        inside[l] = internal(T[l]);
        slope[l] = internal.slope(T[l]);
        curvature[l] = internal.curvature(T[l]);
    }
    const Four internal = inside * n, left = energy - internal;

    const Four half_heat = all_four(mixture_.half_heat());
    const Four C_t = freedom * half_heat, C_i = n * slope;
    const Four least = internal < left ? internal : left;
    const Four part = C_t / (C_t + C_i), scatter = T / (C_t + C_i);
    const Four spread = T * roots_of(2.0 * half_heat * C_t * (1.0 - part * part));
    const Four less = SCATTER * half_heat * C_t * (n * curvature) * scatter * scatter;
    const Four most = MOST_NOISE * least, wanted = spread * load_four(share_.data()) - less;
    Four more = wanted > most ? most : wanted < -most ? -most : wanted;
    more = ((C_i > 0.0) & (least > 0.0)) ? more : all_four(0.0);
    const auto [lowest, kept] =
        Deviation<Four>::of(inside + more / n, before / n, load_four(least_.data()), MEMORY);
    const Four translational = left - more;
    return {lowest, kept, translational, (T > 0.0) & (translational > 0.0)};
}

Four LinLanes::temperature(const Four& energy, const Four& freedom) const {
    Four T;
    for (int l = 0; l < FOUR; ++l) {
        const EnergyPolynomial& internal = mixture_.particle_internal(species_[l]);
        T[l] = internal.b == 0.0 && internal.c == 0.0
                   ? energy[l] / (n_[l] * internal.a + freedom[l] * mixture_.half_heat())
                   : equilibrium_temperature(energy[l], freedom[l], mixture_.half_heat(),
                                             n_[l] * internal);
    }
    return T;
}

/// Uniform on SO(3), from a uniform unit quaternion [Shoemake 1992].
Four33 LinLanes::random_rotation() const {
    const Four u = load_four(turn_[0].data());
    const auto [sin_a, cos_a] = turn(load_four(turn_[1].data()));
    const auto [sin_b, cos_b] = turn(load_four(turn_[2].data()));
    const Four r = roots_of(1.0 - u), s = roots_of(u);
    const Four w = s * cos_b, x = r * sin_a, y = r * cos_a, z = s * sin_b;
    return {{{{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
              {2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
              {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}}}};
}

/// F with F Fᵀ ~ the stress turned round: see collide_lin.cpp.
Four33 LinLanes::turned_factor(const Four33& P, const Four& n, FourBits& is_good) const {
    const Four axis = load_four(axis_.data());
    Four33 ordered;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
            ordered(i, j) =
                in_order(P(i, j), P((i + 1) % 3, (j + 1) % 3), P((i + 2) % 3, (j + 2) % 3), axis);
    const auto [L, is_solid] = lower_factor(ordered, lin::FLATTEST * trace(P));
    is_good &= is_solid;
    const Four kT = trace(P) / (3.0 * n), agitation = lin::NOISE * roots_of(kT);
    Four33 F;
    int drawn = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < i; ++j)
            F(i, j) = agitation * load_four(stress_[drawn++].data()) - lin::BETA * L(i, j);
        const Four k = n - static_cast<double>(i), variance = 2.0 / (9.0 * k),
                   mean = 1.0 - variance;
        const Four z = cbrt(L(i, i) * L(i, i) / (k * kT)) - mean;
        const Four turned = mean - lin::BETA * z +
                            lin::NOISE * roots_of(variance) * load_four(stress_[drawn++].data());
        const Four kept = turned > lin::LEAST_TURNED ? turned : all_four(lin::LEAST_TURNED);
        F(i, i) = roots_of(k * kT * kept * kept * kept);
    }
    Four33 back;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            back(i, j) = in_order(F(i, j), F((i + 2) % 3, j), F((i + 1) % 3, j), axis);
    return back;
}

LinLanes::Maps LinLanes::find_maps() const {
    const Four n = load_four(n_.data()), m = load_four(m_.data());
    Four33 S, Q, C;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Four mean_x = load_four(x_[j].data()) / n, mean_v = load_four(v_[j].data()) / n;
            S(i, j) = load_four(xx_[i][j].data()) - load_four(x_[i].data()) * mean_x;
            Q(i, j) = load_four(vx_[i][j].data()) - load_four(v_[i].data()) * mean_x;
            C(i, j) = load_four(vv_[i][j].data()) - load_four(v_[i].data()) * mean_v;
        }
    const auto [L_S, is_solid] = lower_factor(S, lin::FLATTEST * trace(S));
    const Four33 inverse_S = inverse_of(L_S);
    const Four33 Y = product_transposed(Q, inverse_S), G = product(Y, inverse_S),
                 gradient = product_transposed(Y, Y);
    Four33 P;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) P(i, j) = m * (C(i, j) - gradient(i, j));
    const Four motion = 0.5 * m * trace(C), thermal = 0.5 * trace(P);
    Four U2{};
    for (int k = 0; k < 3; ++k) {
        const Four U = load_four(first_v_[k].data()) + load_four(v_[k].data()) / n;
        U2 += U * U;
    }
    const Energy energy = share(motion, thermal);
    Maps maps;
    maps.is_good = is_solid & energy.is_good & (thermal > RIGID * 0.5 * m * n * U2);
    maps.thermal = motion + load_four(e_.data());
    maps.lowest = energy.lowest;
    maps.kept = energy.kept;

    const auto [L, is_gas] = lower_factor(P, lin::FLATTEST * trace(P));
    maps.is_good &= is_gas;
    const Four33 F = turned_factor(P, n - lin::FITTED, maps.is_good);
    Four33& A = maps.A;
    A = product(product(F, random_rotation()), inverse_of(L));
    const Four after = trace(product_transposed(product(A, P), A));
    const Four exact = roots_of(2.0 * energy.translational / after);
    for (auto& row : A.at)
        for (Four& a : row) a *= exact;
    const Four33 AG = product(A, G);
    for (int i = 0; i < 3; ++i) {
        maps.b[i] = load_four(v_[i].data()) / n;
        for (int j = 0; j < 3; ++j) {
            maps.H(i, j) = G(i, j) - AG(i, j);
            maps.b[i] -=
                (A(i, j) * load_four(v_[j].data()) + maps.H(i, j) * load_four(x_[j].data())) / n;
        }
    }
    return maps;
}

void LinLanes::apply(std::size_t lane, const Maps& maps, Particles& particles) const {
    const auto l = static_cast<int>(lane);
    const auto column = [&](const Four33& a, int j) {
        return Four{a(0, j)[l], a(1, j)[l], a(2, j)[l], 0.0};
    };
    const std::array<Four, 3> A{column(maps.A, 0), column(maps.A, 1), column(maps.A, 2)};
    const std::array<Four, 3> H{column(maps.H, 0), column(maps.H, 1), column(maps.H, 2)};
    const Index first = rows_[lane][0];
    const Vec3 x_0 = particles.x[first], v_0 = particles.v[first];
    const Four b =
        Four{v_0[0], v_0[1], v_0[2], 0.0} + Four{maps.b[0][l], maps.b[1][l], maps.b[2][l], 0.0};
    const double lowest = maps.lowest[l], kept = maps.kept[l], least = least_[lane];
    for (const Index row : rows_[lane]) {
        const Vec3 x = particles.x[row] - x_0;
        Vec3& v = particles.v[row];
        const Vec3 c = v - v_0;
        const Four mapped = b + (A[0] * c[0] + A[1] * c[1] + A[2] * c[2]) +
                            (H[0] * x[0] + H[1] * x[1] + H[2] * x[2]);
        v = Vec3(mapped[0], mapped[1], mapped[2]);
        particles.e[row] = lowest + kept * (particles.e[row] - least);
    }
}

}  // namespace corpuscle::gas
