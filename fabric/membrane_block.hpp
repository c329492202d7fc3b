// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fabric/element_frequency.hpp"
#include "fabric/lanes.hpp"
#include "fabric/materials/law.hpp"
#include "fabric/reference_shape.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

enum class ElementKind { TRIANGLE, QUAD_ONE_POINT, QUAD_FOUR_POINT };

/// Elements of one part, one shape, one law. Elements lie in packs of LANES; the last pack is
/// filled up with copies of its last element that have no volume.
///
/// Corner forces of pack p are written to (p·CORNERS + corner)·3·LANES + component·LANES + lane.
class MembraneBlock {
public:
    virtual ~MembraneBlock() = default;

    struct Result {
        double energy = 0.0;
        double rate = 0.0;  ///< largest (2/dt)² met, above rest_rate             [1/s^2]
        Index shell = -1;   ///< whose it is; -1: none is above
        double lost = 0.0;  ///< by loops of loading since the last call          [J]
        double pull = 0.0;  ///< what the stress would do on the strain of the start: ΣV·S:E_0 [J]
    };
    /// Forces of packs begin..end; laws that remember move on. `damping` is written only by damped
    /// blocks.
    virtual Result force(std::size_t begin, std::size_t end, const Points& x, const Points& v,
                         double* elastic, double* damping) = 0;

    /// Lowest row of a shell whose energy or forces (as last written) are not finite, or -1.
    [[nodiscard]] virtual Index first_broken(const Points& x, const double* elastic,
                                             const double* damping) const = 0;

    /// Mean stress and strain of every element, at its shell's row.
    virtual void stress_strain(const Points& x, std::span<std::array<float, 3>> stress,
                               std::span<std::array<float, 3>> strain) const = 0;

    [[nodiscard]] virtual Index node(std::size_t element, int corner) const = 0;

    /// (2/dt)² of an element at its reference shape.                            [1/s^2]
    [[nodiscard]] virtual double rate(std::size_t element) const = 0;
    virtual void set_rate(std::size_t element, double rate) = 0;
    /// Takes what the corners weigh, once that is settled.
    virtual void take_masses() = 0;
    /// β = 2ζ/ω with the frequency of the element alone.                         [s]
    [[nodiscard]] virtual double damping_time(std::size_t element) const = 0;

    using PastVisitor = std::function<void(std::span<std::byte>)>;
    /// Shows all that depends on what the elements have been through.
    virtual void visit_past(const PastVisitor& visit) = 0;
    /// Takes over what the elements of the same block have been through, new shells aside.
    virtual void inherit(const MembraneBlock& from, const std::vector<std::uint8_t>& is_new) = 0;

    [[nodiscard]] std::size_t size() const { return shells.size(); }
    [[nodiscard]] std::size_t packs() const { return (size() + LANES - 1) / LANES; }
    [[nodiscard]] std::size_t doubles() const {
        return packs() * LANES * 3 * static_cast<std::size_t>(corners);
    }

    Index part = -1;
    int corners = 0;
    bool is_damped = false;
    double rest_rate = 0.0;     ///< (2/dt)² of all elements at their reference shapes [1/s^2]
    double strain_left = 0.0;   ///< r: what is left of the start's strain (TSRFAC)     [-]
    std::vector<Index> shells;  ///< rows, in order
    std::vector<double> mass;   ///< that each corner brings to its node, size × corners  [kg]
    std::vector<CornerMatrix> stiffness;  ///< at rest, given up once the step is known [N/m]
};

/// What a block is built from.
struct BlockInput {
    Index part = -1;
    ElementKind kind = ElementKind::TRIANGLE;
    double thickness = NaN;  ///< [m]
    PartLaw law;
    std::vector<Index> shells;                ///< rows
    std::vector<ReferenceShape> shapes;       ///< one a shell
    std::vector<std::array<Index, 4>> nodes;  ///< distinct corners' node rows, one a shell
    std::span<const Vec3> start;  ///< places at the start, or none                    [m]
};

std::unique_ptr<MembraneBlock> make_triangles(const BlockInput& in);
std::unique_ptr<MembraneBlock> make_one_point_quads(const BlockInput& in);
std::unique_ptr<MembraneBlock> make_four_point_quads(const BlockInput& in);

}  // namespace corpuscle::fabric
