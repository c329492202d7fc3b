// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/charts.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "contact/culling/chart_layout.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr double GREATEST = 0.5;  ///< value of mu above which a chart is of no use
constexpr std::size_t MOST_SHEETS = 64, MOST_CROSSED = 16;  ///< of a chart; by a pair's ways

void tidy(std::vector<Index>& some) {
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
}

/// By patch: those that have a node in common with it, and those that have one with these; each is
/// among its own.
struct Surroundings {
    std::vector<std::vector<Index>> beside, around;
};
Surroundings surroundings(const Cloth& cloth) {
    std::vector<std::vector<Index>> at_node(cloth.inverse_mass.size());
    for (std::size_t p = 0; p < cloth.patches.size(); ++p)
        for (const Index t : cloth.patches[p])
            for (const Index n : cloth.triangles[t]) at_node[n].push_back(static_cast<Index>(p));
    Surroundings out{std::vector<std::vector<Index>>(cloth.patches.size()), {}};
    auto& [beside, around] = out;
    around.resize(beside.size());
    for (auto& some : at_node) {
        tidy(some);
        for (const Index p : some) beside[p].insert(beside[p].end(), some.begin(), some.end());
    }
    for (auto& some : beside) tidy(some);
    for (std::size_t p = 0; p < around.size(); ++p) {
        for (const Index q : beside[p])
            around[p].insert(around[p].end(), beside[q].begin(), beside[q].end());
        tidy(around[p]);
    }
    return out;
}

/// Patches none of which lie beside each other, and beside one of which every other lies.
std::vector<std::uint8_t> centres(const Surroundings& near) {
    std::vector<std::uint8_t> is_centre(near.beside.size(), 0);
    for (std::size_t p = 0; p < is_centre.size(); ++p)
        is_centre[p] = std::none_of(near.beside[p].begin(), near.beside[p].end(),
                                    [&](Index q) { return is_centre[q] != 0; });
    return is_centre;
}

}  // namespace

/// What charts are drawn from.
struct Charts::Drawing {
    struct Home {  ///< of a triangle
        Index patch, row;
    };
    const Cloth& cloth;
    EdgeSides sides;
    std::vector<Home> home;
    std::vector<double> margin;  ///< by patch                                             [m]

    Drawing(const Cloth& of, std::span<const double> margins)
        : cloth(of),
          sides(sides_of_edges(of)),
          home(of.triangles.size()),
          margin(of.patches.size(), 0.0) {
        for (std::size_t p = 0; p < margin.size(); ++p)
            for (std::size_t i = 0; i < of.patches[p].size(); ++i) {
                const Index t = of.patches[p][i];
                margin[p] = std::max(margin[p], margins[t]);
                home[t] = {static_cast<Index>(p), static_cast<Index>(i)};
            }
    }
};

/// Patches that lie beside a centre share its chart, so that there are few; where there is none
/// that holds both, they have that of the first.
Charts::Charts(const Cloth& cloth, std::span<const double> margin)
    : charts_(cloth.patches.size()),
      height_(charts_.size(), INF),
      reach_(charts_.size(), 0.0),
      blocks_(charts_.size()),
      places_(charts_.size()),
      links_(charts_.size()) {
    set_blocks(cloth);
    const Drawing from(cloth, margin);
    const Surroundings near = surroundings(cloth);
    const auto is_centre = centres(near);
    std::vector<std::vector<Pair>> pairs(charts_.size());  // by chart
    const auto draw_all = [&] {
        std::vector<std::vector<Linked>> found(charts_.size());
        const auto one = [&](std::size_t c) {
            found[c] = draw(static_cast<Index>(c), pairs[c], from);
        };
        parallel::for_each(charts_.size(), one, 4);
        for (const auto& some : found)
            for (const Linked& l : some) links_[l.pair.first].emplace_back(l.pair.second, l.link);
        for (auto& some : links_)
            std::sort(some.begin(), some.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    };
    for (std::size_t i = 0; i < charts_.size(); ++i)
        for (const Index q : near.around[i]) {
            const auto p = static_cast<Index>(i);
            if (q < p) continue;
            const auto holds_both = [&](Index c) {
                return is_centre[c] &&
                       std::binary_search(near.beside[q].begin(), near.beside[q].end(), c);
            };
            const auto c = std::find_if(near.beside[p].begin(), near.beside[p].end(), holds_both);
            pairs[c == near.beside[p].end() ? p : *c].emplace_back(p, q);
        }
    draw_all();
    // second try, in the first one's chart
    for (std::size_t c = 0; c < charts_.size(); ++c) {
        const std::vector<Pair> tried = std::exchange(pairs[c], {});
        for (const auto& [p, q] : tried)
            if (link(p, q).chart < 0 && static_cast<std::size_t>(p) != c)
                pairs[p].emplace_back(p, q);
    }
    draw_all();
    number_sheets();
}

/// Those of a patch one after the other: they are looked at together.
void Charts::number_sheets() {
    for (std::size_t c = 0; c < charts_.size(); ++c)
        for (std::size_t s = 0; s < charts_[c].sheets.size(); ++s) {
            const Sheet& sheet = charts_[c].sheets[s];
            places_[sheet.patch].push_back(
                {static_cast<Index>(c), static_cast<Index>(s), 0, sheet.crossed});
        }
    for (auto& places : places_)
        for (Place& at : places)
            at.row = charts_[at.chart].sheets[at.sheet].row = static_cast<Index>(sheets_++);
}

void Charts::set_blocks(const Cloth& cloth) {
    const Points& x = cloth.reference_x;
    for (std::size_t p = 0; p < blocks_.size(); ++p) {
        const auto triangles = cloth.patches[p];
        blocks_[p].resize((triangles.size() + EIGHT - 1) / EIGHT);
        for (std::size_t i = 0; i < EIGHT * blocks_[p].size(); ++i) {
            Block& block = blocks_[p][i / EIGHT];
            const int lane = static_cast<int>(i % EIGHT);
            const Triangle& t = cloth.triangles[triangles[std::min(i, triangles.size() - 1)]];
            for (std::size_t k = 0; k < 3; ++k) block.corner[k][lane] = t[k];
            for (std::size_t k = 0; k < 2; ++k) {
                const Vec3 edge = x[t[k + 1]] - x[t[0]];
                for (int j = 0; j < 3; ++j) block.edge[k][j][lane] = static_cast<float>(edge[j]);
            }
        }
    }
}

/// Adds pairs of patches, as far as straight ways lead from one to the other, and what these cross.
std::vector<Charts::Linked> Charts::draw(Index c, std::span<const Pair> pairs,
                                         const Drawing& from) {
    std::vector<Linked> out;
    const auto is_large = [&](Index patch) {
        return from.cloth.patches[patch].size() > EIGHT * MOST_BLOCKS;
    };
    if (pairs.empty() || is_large(c)) return out;
    ChartLayout layout(from.cloth, from.sides, c);
    Chart& chart = charts_[c];
    const auto sheet_of = [&](Index patch) {
        const auto is_it = [&](const Sheet& sheet) { return sheet.patch == patch; };
        const auto found = std::find_if(chart.sheets.begin(), chart.sheets.end(), is_it);
        if (found == chart.sheets.end()) chart.sheets.push_back({patch});
        return static_cast<std::size_t>(
            std::find_if(chart.sheets.begin(), chart.sheets.end(), is_it) - chart.sheets.begin());
    };
    for (const auto& [p, q] : pairs) {
        if (chart.sheets.size() + MOST_CROSSED > MOST_SHEETS || !layout.are_near(p, q)) continue;
        const auto way = layout.between(p, q);
        if (!way) continue;
        std::set<Index> crossed;
        for (const Index t : *way) crossed.insert(from.home[t].patch);
        if (crossed.size() > MOST_CROSSED || std::any_of(crossed.begin(), crossed.end(), is_large))
            continue;
        std::uint64_t cover = 0;
        for (const Index t : *way) {
            const std::size_t s = sheet_of(from.home[t].patch);
            chart.sheets[s].crossed |= std::uint64_t{1} << from.home[t].row;
            cover |= std::uint64_t{1} << s;
            height_[c] = std::min(height_[c], layout.least_height(t));
        }
        reach_[c] = std::max(reach_[c], from.margin[p] + from.margin[q]);
        out.push_back({{p, q}, {c, cover}});
    }
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i) chart.axis[k][i] = static_cast<float>(layout.axis(k)[i]);
    chart.least = reach_[c] / height_[c];
    return out;
}

Charts::Link Charts::link(Index p, Index q) const {
    const auto by_patch = [](const auto& entry, Index patch) { return entry.first < patch; };
    const auto at = std::lower_bound(links_[p].begin(), links_[p].end(), q, by_patch);
    if (at == links_[p].end() || at->first != q) return {};
    return charts_[at->second.chart].least <= GREATEST ? at->second : Link{};
}

}  // namespace corpuscle::contact
