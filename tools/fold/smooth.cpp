// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tools/fold/imprint.hpp"

namespace corpuscle::fold {
namespace {

struct Neighbours {
    std::vector<std::vector<Index>> nodes, cells;  ///< by node
};

Neighbours neighbours(const Sheet& sheet) {
    Neighbours all{std::vector<std::vector<Index>>(sheet.X.size()),
                   std::vector<std::vector<Index>>(sheet.X.size())};
    for (const auto& [a, b] : edges(sheet.cells)) {
        all.nodes[a].push_back(b);
        all.nodes[b].push_back(a);
    }
    for (std::size_t e = 0; e < sheet.cells.size(); ++e)
        for (int k = 0; k < corner_count(sheet.cells[e]); ++k)
            all.cells[sheet.cells[e][k]].push_back(static_cast<Index>(e));
    return all;
}

double worst(const std::vector<Index>& cells, const Sheet& sheet) {
    double least = 1.0;
    for (const Index e : cells) least = std::min(least, quality(sheet.cells[e], sheet.X));
    return least;
}

}  // namespace

void smooth(Sheet& sheet, double wanted, int rounds) {
    const Neighbours near = neighbours(sheet);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t n = 0; n < sheet.X.size(); ++n) {
            const double before = worst(near.cells[n], sheet);
            if (before >= wanted) continue;
            const auto& on = sheet.on[n];
            if (!on.empty() && on.front() < 0)
                continue;                // a curve: along its chords it would shrink
            Vec3 middle = Vec3::Zero();  // of the neighbours that it may move towards
            int count = 0;
            for (const Index m : near.nodes[n])
                if (is_within(on, sheet.on[m])) {
                    middle += sheet.X[m];
                    ++count;
                }
            if (count < 2) continue;
            const Vec3 old = sheet.X[n];
            for (const double share : {1.0, 0.5, 0.25}) {
                sheet.X[n] = old + share * (middle / count - old);
                if (worst(near.cells[n], sheet) > before) break;
                sheet.X[n] = old;
            }
            sheet.x[n] = sheet.X[n];
        }
}

}  // namespace corpuscle::fold
