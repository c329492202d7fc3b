// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/cell_sample.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solver/base/simd.hpp"

namespace corpuscle::gas {

namespace {

constexpr double PAIRED = -1.0;  ///< of no kind any more

Four load(const std::vector<double>& from, std::size_t i) {
    return load_four(from.data() + i);
}

double total(const Four& a) {
    return (a[0] + a[1]) + (a[2] + a[3]);
}

}  // namespace

void CellSample::gather(std::span<const Index> rows, const Mixture& mixture,
                        const Particles& particles) {
    n_ = rows.size();
    padded_ = (n_ + 3) / 4 * 4;
    c.resize(padded_);
    m_.resize(padded_);
    e.resize(padded_);
    species_.resize(n_);

    const std::int32_t first = mixture.kind(particles.species[rows[0]]);
    is_mixed_ = false;
    for (std::size_t i = 0; i < n_; ++i) {
        const Index row = rows[i];
        species_[i] = mixture.kind(particles.species[row]);
        is_mixed_ |= species_[i] != first;
        c.set(i, particles.v[row]);
        e[i] = particles.e[row];
        m_[i] = mixture.particle_mass(species_[i]);
    }
    for (std::size_t i = n_; i < padded_; ++i) {
        c.set(i, Vec3::Zero());
        e[i] = m_[i] = 0.0;
    }
    internal_at_ = {};
    if (is_mixed_) {
        kinds_.assign(mixture.species().size(), {});
        for (const std::int32_t s : species_) {
            internal_at_ += mixture.particle_internal(s);
            kinds_[s].count += 1.0;
        }
    } else {
        internal_at_ = static_cast<double>(n_) * mixture.particle_internal(first);
    }

    mass = std::accumulate(m_.begin(), m_.begin() + static_cast<std::ptrdiff_t>(n_), 0.0);
    // Twice: what rounding left in the first mean would weigh in a jet much faster than it is hot.
    Vec3 rest;
    centre(c, U);
    centre(c, rest);
    U += rest;
}

void CellSample::gather_places(std::span<const Index> rows, const Particles& particles) {
    dx.resize(padded_);
    const Vec3 near = particles.x[rows[0]];
    for (std::size_t i = 0; i < n_; ++i) dx.set(i, particles.x[rows[i]] - near);
    for (std::size_t i = n_; i < padded_; ++i) dx.set(i, Vec3::Zero());
    Vec3 mean;
    centre(dx, mean);
}

/// Subtracts the mean by mass. The padding takes part in the subtraction but weighs nothing.
void CellSample::centre(Columns& a, Vec3& mean) const {
    for (int k = 0; k < 3; ++k) {
        std::vector<double>& column = a.along[k];
        Four sum{};
        for (std::size_t i = 0; i < padded_; i += 4) sum += load(m_, i) * load(column, i);
        mean[k] = total(sum) / mass;
        for (std::size_t i = 0; i < padded_; ++i) column[i] -= mean[k];
    }
}

void CellSample::scatter(std::span<const Index> rows, Particles& particles) const {
    for (std::size_t i = 0; i < n_; ++i) {
        particles.v[rows[i]] = U + c[i];
        particles.e[rows[i]] = e[i];
    }
}

double CellSample::translational() const {
    Four sum{};
    for (std::size_t i = 0; i < padded_; i += 4) {
        const Four x = load(c.along[0], i), y = load(c.along[1], i), z = load(c.along[2], i);
        sum += load(m_, i) * (x * x + y * y + z * z);
    }
    return 0.5 * total(sum);
}

double CellSample::least_mass() const {
    return *std::min_element(m_.begin(), m_.begin() + static_cast<std::ptrdiff_t>(n_));
}

double CellSample::internal() const {
    return std::accumulate(e.begin(), e.begin() + static_cast<std::ptrdiff_t>(n_), 0.0);
}

Mat3 CellSample::moment(const Columns& a, const Columns& b) const {
    std::array<std::array<Four, 3>, 3> sum{};
    for (std::size_t i = 0; i < padded_; i += 4) {
        const Four m = load(m_, i);
        const std::array<Four, 3> right = {load(b.along[0], i), load(b.along[1], i),
                                           load(b.along[2], i)};
        for (int j = 0; j < 3; ++j) {
            const Four left = m * load(a.along[j], i);
            for (int k = 0; k < 3; ++k) sum[j][k] += left * right[k];
        }
    }
    Mat3 out;
    for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) out(j, k) = total(sum[j][k]);
    return out;
}

double CellSample::can_give(double T, const Mixture& mixture) const {
    if (!is_mixed_) return internal_at_(T);
    double fall = INF;  // of temperature
    for (std::size_t s = 0; s < kinds_.size(); ++s) {
        if (kinds_[s].count == 0.0) continue;
        const EnergyPolynomial& internal = mixture.particle_internal(static_cast<std::int32_t>(s));
        if (internal.slope(T) > 0.0) fall = std::min(fall, internal(T) / internal.slope(T));
    }
    return std::min(internal_at_(T), fall * internal_at_.slope(T));
}

void CellSample::set_internal(double T, double more, double memory, const Mixture& mixture) {
    const double rise = more == 0.0 ? 0.0 : more / internal_at_.slope(T);
    const auto mean_of = [&](std::int32_t s) {
        const EnergyPolynomial& internal = mixture.particle_internal(s);
        return internal(T) + rise * internal.slope(T);
    };
    if (!is_mixed_) {
        const auto end = e.begin() + static_cast<std::ptrdiff_t>(n_);
        const double least = *std::min_element(e.begin(), end);
        const auto [lowest, kept] = Deviation<double>::of(
            mean_of(species_[0]), internal() / static_cast<double>(n_), least, memory);
        for (std::size_t i = 0; i < n_; ++i) e[i] = lowest + kept * (e[i] - least);
        return;
    }
    for (Kind& kind : kinds_) kind.internal = 0.0, kind.least = INF;
    for (std::size_t i = 0; i < n_; ++i) {
        Kind& kind = kinds_[species_[i]];
        kind.internal += e[i];
        kind.least = std::min(kind.least, e[i]);
    }
    for (std::size_t s = 0; s < kinds_.size(); ++s) {
        Kind& kind = kinds_[s];
        if (kind.count > 0.0)
            kind.deviation = Deviation<double>::of(mean_of(static_cast<std::int32_t>(s)),
                                                   kind.internal / kind.count, kind.least, memory);
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const Kind& kind = kinds_[species_[i]];
        e[i] = kind.deviation.lowest + kind.deviation.kept * (e[i] - kind.least);
    }
}

void CellSample::scale(double factor) {
    for (auto& column : c.along)
        for (double& ci : column) ci *= factor;
}

void CellSample::add_internal(double energy) {
    for (std::size_t i = 0; i < n_; ++i) e[i] += energy * (m_[i] / mass);
}

void CellSample::heat_internal() {
    if (heat >= 0.0) return add_internal(heat);
    const double holds = internal();
    if (!(holds + heat >= 0.0)) {
        refused = -heat;
        return;
    }
    for (double& ei : e) ei *= 1.0 + heat / holds;
}

void CellSample::transform(const Mat3& A) {
    double* const x = c.along[0].data();
    double* const y = c.along[1].data();
    double* const z = c.along[2].data();
    for (std::size_t i = 0; i < padded_; ++i) {
        const double u = x[i], v = y[i], w = z[i];
        x[i] = A(0, 0) * u + A(0, 1) * v + A(0, 2) * w;
        y[i] = A(1, 0) * u + A(1, 1) * v + A(1, 2) * w;
        z[i] = A(2, 0) * u + A(2, 1) * v + A(2, 2) * w;
    }
}

void CellSample::add_gradient(const Mat3& G) {
    for (int k = 0; k < 3; ++k) {
        double* const to = c.along[k].data();
        const double *x = dx.along[0].data(), *y = dx.along[1].data(), *z = dx.along[2].data();
        for (std::size_t i = 0; i < padded_; ++i)
            to[i] += G(k, 0) * x[i] + G(k, 1) * y[i] + G(k, 2) * z[i];
    }
}

void CellSample::collide_pairs(Random& draw) {
    const auto n = static_cast<std::uint32_t>(n_);
    shuffled_.resize(n);
    std::iota(shuffled_.begin(), shuffled_.end(), 0);
    for (std::uint32_t i = 0; i + 1 < n; i += 2) {
        std::swap(shuffled_[i], shuffled_[i + draw.below(n - i)]);
        std::swap(shuffled_[i + 1], shuffled_[i + 1 + draw.below(n - i - 1)]);
        const auto p = static_cast<std::size_t>(shuffled_[i]);
        const auto q = static_cast<std::size_t>(shuffled_[i + 1]);
        collide_pair(p, q, draw);
    }
}

void CellSample::collide_unlike(Random& draw) {
    const auto n = static_cast<std::uint32_t>(n_);
    shuffled_.resize(n);
    std::iota(shuffled_.begin(), shuffled_.end(), 0);
    unpaired_.assign(padded_, PAIRED);
    std::copy(species_.begin(), species_.end(), unpaired_.begin());
    for (std::uint32_t i = 0; i < n; ++i) {
        std::swap(shuffled_[i], shuffled_[i + draw.below(n - i)]);
        const auto p = static_cast<std::size_t>(shuffled_[i]);
        if (unpaired_[p] == PAIRED) continue;
        const std::size_t q = nearest_unlike(p);
        if (q == n_) continue;
        unpaired_[p] = unpaired_[q] = PAIRED;
        collide_pair(p, q, draw);
    }
}

/// Of unlike ones that are not paired, the first of the nearest; n_: there is none.
std::size_t CellSample::nearest_unlike(std::size_t p) const {
    const auto none = static_cast<double>(n_);
    const Four x = all_four(dx.along[0][p]), y = all_four(dx.along[1][p]),
               z = all_four(dx.along[2][p]), kind = all_four(unpaired_[p]);
    Four least = all_four(INF), nearest = all_four(none), row = {0.0, 1.0, 2.0, 3.0};
    for (std::size_t q = 0; q < padded_; q += FOUR, row += static_cast<double>(FOUR)) {
        const Four along = load(dx.along[0], q) - x, across = load(dx.along[1], q) - y,
                   up = load(dx.along[2], q) - z, other = load(unpaired_, q);
        const Four distance = along * along + across * across + up * up;
        const FourBits is_nearer = (other != PAIRED) & (other != kind) & (distance < least);
        least = is_nearer ? distance : least;
        nearest = is_nearer ? row : nearest;
    }
    std::pair best{INF, none};
    for (int l = 0; l < FOUR; ++l) {
        const double distance = least[l], q = nearest[l];
        best = std::min(best, std::pair{distance, q});
    }
    return static_cast<std::size_t>(best.second);
}

void CellSample::collide_pair(std::size_t p, std::size_t q, Random& draw) {
    const double share = m_[q] / (m_[p] + m_[q]);
    const Vec3 apart = c[p] - c[q];
    const Vec3 centre = c[q] + (1.0 - share) * apart;
    const Vec3 turned = apart.norm() * draw.direction();
    c.set(p, centre + share * turned);
    c.set(q, centre - (1.0 - share) * turned);
}

void CellSample::bounce(std::size_t p, std::size_t q, const Vec3& n) {
    const double share = m_[q] / (m_[p] + m_[q]);
    const Vec3 change = 2.0 * (c[q] - c[p]).dot(n) * n;
    c.set(p, c[p] + share * change);
    c.set(q, c[q] - (1.0 - share) * change);
}

}  // namespace corpuscle::gas
