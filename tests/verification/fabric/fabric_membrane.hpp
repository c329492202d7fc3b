// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/geometry/quarter_disc.hpp"
#include "tests/support/scenes/relax.hpp"

namespace corpuscle::test {

enum class Kind { TRIANGLES, ONE_POINT, FOUR_POINT };
inline const char* name(Kind kind) {
    return kind == Kind::TRIANGLES   ? "triangles"
           : kind == Kind::ONE_POINT ? "1-point quads"
                                     : "2x2 quads";
}

/// One part of one material on a flat mesh, quarter of a symmetric whole: x = 0 and y = 0 are
/// mirrors.
struct Quarter {
    FlatMesh mesh;
    Relaxation at;
    fabric::Membranes membranes;

    Quarter(FlatMesh flat, const fabric::MaterialCard& card, double thickness, Kind kind,
            double pressure)
        : mesh(std::move(flat)), membranes(build(card, thickness, kind)) {
        at.pressure = pressure;
        for (const Shell& s : mesh.shells) at.facets.push_back(s.nodes);
        at.free.assign(mesh.x.size(), Vec3::Ones());
        constexpr double ON = 1e-9;
        for (std::size_t n = 0; n < mesh.x.size(); ++n) {
            if (mesh.x[n].x() < ON) at.free[n].x() = 0.0;
            if (mesh.x[n].y() < ON) at.free[n].y() = 0.0;
        }
    }
    template <class Where>
    void hold(const Where& where, const Vec3& free) {
        for (std::size_t n = 0; n < mesh.x.size(); ++n)
            if (where(mesh.x[n])) at.free[n] = at.free[n].cwiseProduct(free);
    }

private:
    fabric::Membranes build(const fabric::MaterialCard& card, double thickness, Kind kind) {
        const std::vector<Part> parts{
            {1, "sheet", 0, thickness, NaN, kind == Kind::FOUR_POINT ? 9 : 5}};
        const std::vector<fabric::Material> materials{{1, "film", card}};
        std::vector<std::array<Vec3, 4>> reference;
        for (const Shell& s : mesh.shells) {
            auto& corners = reference.emplace_back();
            for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.x[s.nodes[i]];
        }
        const std::vector<std::uint8_t> active(mesh.shells.size(), 1);
        const fabric::MembraneSetup setup{mesh.shells, parts,  materials,
                                          reference,   active, mesh.x.size()};
        at.mass = fabric::lumped_mass(setup);
        return fabric::Membranes(setup);
    }
};

}  // namespace corpuscle::test
