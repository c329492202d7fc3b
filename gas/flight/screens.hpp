// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Facets that stand between the particles of one cell. All tests err on the side of "it does": what
/// touches, or is too close to tell, is in the way.
///
/// The line from p along d passes an edge from a to b on the side of
///
///     d · ((a - p) × (b - p)) = d · (a × b) + (b - a) · (p × d)
///
/// [Plücker coordinates], and through a facet where the three have one sign. Places count from the
/// first particle.
class Screens {
public:
    /// Forgets all, for particles at x.
    /// @param reach  no two of them, nor one and the box of a facet, are farther apart       [m]
    void begin(std::span<const Vec3> x, double reach);

    /// Takes a facet, unless all particles are strictly on one side of its plane.
    void add(const Vec3& a, const Vec3& b, const Vec3& c);

    [[nodiscard]] bool empty() const { return size_ == 0; }

    /// Is particle i on the plane of a facet, or too close to tell?
    [[nodiscard]] bool touches(std::size_t i) const;
    /// Are two on the same side of each facet's plane, or both on it?
    [[nodiscard]] bool are_alike(std::size_t i, std::size_t j) const;
    /// Is the line from one to the other free of facets?
    [[nodiscard]] bool is_free(std::size_t i, std::size_t j) const;

private:
    static constexpr double CLOSE = 1e-9;      ///< of the reach: nearer than this is touching
    static constexpr double ROUNDING = 8e-15;  ///< covers the rounding of the products above
    static constexpr std::size_t BITS = 64;    ///< facets a word

    /// Edges of four facets: b - a, a × b.                                             [m], [m²]
    struct Edges {
        std::array<FourPoints, 3> along, moment;
        Four slack;  ///< that is too close to tell, over |d|                                [m²]
    };
    struct Line;
    [[nodiscard]] bool has_both_sides(const Vec3& normal, double offset, double slack);
    void note_sides(double slack);
    void note_edges(const std::array<Vec3, 3>& corner, double slack);
    [[nodiscard]] static unsigned blocks(const Edges& edges, const Line& line);

    /// Bits of the facets in a word.
    [[nodiscard]] std::uint64_t all(std::size_t word) const {
        const std::size_t left = size_ - word * BITS;
        return left >= BITS ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1U;
    }

    double reach_ = 0.0;           ///< [m]
    Vec3 origin_ = Vec3::Zero();   ///< [m]
    std::size_t size_ = 0;         ///< facets
    std::vector<FourPoints> x_;    ///< of particles                                       [m]
    std::vector<Four> height_;     ///< over the plane of a facet, times twice its area   [m³]
    std::vector<FourBits> over_;   ///< words × particles: bit s, it is over the plane of facet s
    std::vector<FourBits> under_;  ///< likewise
    std::vector<Edges> edges_;
};

}  // namespace corpuscle::gas
