// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/unit/fabric/sheet.hpp"

/// Small random meshes of cloth and film: distorted, folded, crumpled.
namespace corpuscle::fabric::test {

inline const std::vector<Curve> CURVES = {{1, {0, 0.02, 0.1, 0.3}, {0, 2e6, 20e6, 90e6}},
                                          {2, {0, 0.1, 0.25, 0.3}, {0, 2e6, 50e6, 90e6}}};

/// In turn: cloth without compression and with a liner, linear, by FORM 14, by FORM 4 with loops of
/// unloading; and a film that takes compression.
inline MaterialCard cloth(unsigned which) {
    if (which % 4 == 3) return ElasticCard{900, 200e6, 0.3};
    FabricCard c = fabric_card();
    c.no_compression = true;
    c.liner_E = 20e6;
    c.liner_ratio = 0.1;
    if (which % 4 == 0) return c;
    c.form = which % 4 == 1 ? 14 : 4;
    c.curves.load = {0, 0, -1};
    if (c.form == 4) c.curves.unload = {1, 1, -1};
    return c;
}

/// A distorted reference, folded over itself along rows of nodes and crumpled.
struct Folded {
    Sheet sheet;
    Points x, v;

    explicit Folded(unsigned seed)
        : sheet(rectangle(cloth(seed), static_cast<Mesh>(seed / 4 % 4), 4, 3, 0.4, 0.3)) {
        sheet.curves = CURVES;
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> fold(1, 2);
        const double a = 0.1 * fold(random), b = 0.1 * fold(random);
        const Points regular = sheet.x;
        jitter(sheet, 0.015, seed);
        // Nodes on a fold stay on it: folding stretches nothing
        for (std::size_t n = 0; n < regular.size(); ++n) {
            if (std::abs(regular[n].x() - a) < 1e-9) sheet.x[n].x() = a;
            if (std::abs(regular[n].y() - b) < 1e-9) sheet.x[n].y() = b;
        }
        x = moved(sheet.x, [&](const Vec3& p) {
            return Vec3(std::abs(p.x() - a), std::abs(p.y() - b), 0.0);
        });
        x = plus(x, noise(x.size(), 0.002, seed + 1));
        v = noise(x.size(), 10.0, seed + 2);
    }
};

}  // namespace corpuscle::fabric::test
