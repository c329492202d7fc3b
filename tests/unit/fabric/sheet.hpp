// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "fabric/membranes.hpp"

namespace corpuscle::fabric::test {

/// A mesh with one part a material, for tests: whatever is needed to build Membranes.
struct Sheet {
    Points x;  ///< node places, stress-free
    std::vector<Shell> shells;
    std::vector<Part> parts;
    std::vector<Material> materials;
    std::vector<std::array<Vec3, 4>> reference;  ///< empty: x
    std::vector<Curve> curves;

    [[nodiscard]] MembraneSetup setup() {
        if (reference.empty())
            for (const Shell& s : shells) {
                auto& corners = reference.emplace_back();
                for (std::size_t i = 0; i < 4; ++i)
                    corners[i] = x[static_cast<std::size_t>(s.nodes[i])];
            }
        active.assign(shells.size(), 1);
        return {shells, parts, materials, reference, active, x.size(), curves};
    }
    [[nodiscard]] Membranes membranes() { return Membranes(setup()); }

    std::vector<std::uint8_t> active;
};

enum class Mesh { TRIANGLES, ONE_POINT, FOUR_POINT, MIXED };
inline const Mesh MESHES[] = {Mesh::TRIANGLES, Mesh::ONE_POINT, Mesh::FOUR_POINT, Mesh::MIXED};
/// Of one kind of element.
inline const Mesh PURE_MESHES[] = {Mesh::TRIANGLES, Mesh::ONE_POINT, Mesh::FOUR_POINT};

inline const char* name(Mesh mesh) {
    return mesh == Mesh::TRIANGLES    ? "triangles"
           : mesh == Mesh::ONE_POINT  ? "1-point quads"
           : mesh == Mesh::FOUR_POINT ? "2x2 quads"
                                      : "triangles and quads";
}

inline FabricCard fabric_card() {
    FabricCard card;
    card.density = 700.0;
    card.E_warp = 300e6;
    card.E_weft = 250e6;
    card.nu_ba = 0.1;
    card.G = 3e6;
    return card;
}

inline void add_part(Sheet& sheet, const MaterialCard& card, Mesh mesh, double thickness = 0.3e-3) {
    const int n = static_cast<int>(sheet.parts.size());
    sheet.materials.push_back({10 + n, "cloth", card});
    sheet.parts.push_back({1 + n, "sheet", n, thickness, NaN, mesh == Mesh::FOUR_POINT ? 9 : 5});
}

/// n × m cells on [0, length] × [0, width] in the plane z = 0; triangles alternate their diagonal.
inline Sheet rectangle(const MaterialCard& card, Mesh mesh, int n, int m, double length,
                       double width) {
    Sheet sheet;
    add_part(sheet, card, mesh);
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) sheet.x.push_back({length * i / n, width * j / m, 0.0});
    const auto add = [&](Index a, Index b, Index c, Index d) {
        sheet.shells.push_back({100 + static_cast<int>(sheet.shells.size()), 0, {a, b, c, d}});
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            const bool split = mesh == Mesh::TRIANGLES || (mesh == Mesh::MIXED && (i + j) % 3 == 0);
            if (!split) {
                add(a, b, c, d);
            } else if ((i + j) % 2 == 0) {
                add(a, b, c, c);
                add(a, c, d, d);
            } else {
                add(a, b, d, d);
                add(b, c, d, d);
            }
        }
    return sheet;
}

/// Moves inner nodes in the plane so that no element is regular.
inline void jitter(Sheet& sheet, double amount, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amount, amount);
    for (Vec3& x : sheet.x) x += Vec3(shift(random), shift(random), 0.0);
}

inline Points noise(std::size_t n, double amount, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amount, amount);
    Points out(n);
    for (Vec3& x : out) x = {shift(random), shift(random), shift(random)};
    return out;
}

inline Points moved(const Points& x, const std::function<Vec3(const Vec3&)>& map) {
    Points out;
    for (const Vec3& at : x) out.push_back(map(at));
    return out;
}
inline Points plus(Points x, const Points& shift) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += shift[i];
    return x;
}
inline Points zeros(std::size_t n) {
    return Points(n, Vec3::Zero());
}

inline Points force(Membranes& membranes, const Points& x, const Points& v) {
    Points f = zeros(x.size());
    static_cast<void>(membranes.add_force(x, v, f));
    return f;
}
inline Points force(Membranes& membranes, const Points& x) {
    return force(membranes, x, zeros(x.size()));
}
inline double greatest(const Points& f) {
    double most = 0.0;
    for (const Vec3& at : f) most = std::max(most, at.norm());
    return most;
}

}  // namespace corpuscle::fabric::test
