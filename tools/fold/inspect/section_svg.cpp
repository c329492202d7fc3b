// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "tools/fold/bag_deck.hpp"

namespace corpuscle::fold {
namespace {

constexpr double WIDTH = 900.0;  ///< of a section, in the drawing's points
constexpr double MARGIN = 30.0;

struct View {
    int along, across;  ///< axes: drawn to the right; that the cut is square to
    double at;          ///< of the cut                                               [m]
    double scale;       ///< points per length
    double left, top;   ///< of the section                                           [points]
};

/// Line through a triangle where it is cut, or nothing.
std::string cut(const Triangle& t, const Points& x, const View& v, const Inspection& found,
                const char* colour) {
    std::vector<Vec3> ends;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = x[t[k]], &b = x[t[(k + 1) % 3]];
        const double before = a[v.across] - v.at, after = b[v.across] - v.at;
        if (before * after < 0.0) ends.push_back(a + before / (before - after) * (b - a));
    }
    if (ends.size() != 2) return "";
    const auto right = [&](const Vec3& p) {
        return v.left + v.scale * (p[v.along] - found.low[v.along]);
    };
    const auto down = [&](const Vec3& p) { return v.top + v.scale * (found.high.z() - p.z()); };
    return fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\"/>\n",
        right(ends[0]), down(ends[0]), right(ends[1]), down(ends[1]), colour);
}

}  // namespace

std::string section_svg(const Bag& bag, const Inspection& found) {
    constexpr std::array COLOURS{"#1f77b4", "#d62728", "#555555", "#9467bd", "#2ca02c", "#ff7f0e"};
    const Vec3 size = found.high - found.low;
    const double scale = WIDTH / std::max(size.x(), size.y());
    const double height = scale * size.z() + 2.0 * MARGIN;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "font-family=\"sans-serif\" font-size=\"13\" stroke-linecap=\"round\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
        WIDTH + 2.0 * MARGIN, 2.0 * height + MARGIN);
    for (const int across : {1, 0}) {
        // a little off the middle, where lines of the mesh would lie in the cut
        const double at = found.low[across] + 0.513 * size[across];
        const View view{1 - across, across, at,
                        scale,      MARGIN, MARGIN + (across == 1 ? 0.0 : height)};
        svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\">cut at {} = {:.4g}</text>\n", MARGIN,
                           view.top - 8.0, across == 1 ? "y" : "x", at);
        for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
            const auto colour = static_cast<std::size_t>(bag.sheet.part[e]) % COLOURS.size();
            for (const Triangle& t : triangles({bag.sheet.cells[e]}))
                svg += cut(t, bag.sheet.x, view, found, COLOURS[colour]);
        }
    }
    return svg + "</svg>\n";
}

}  // namespace corpuscle::fold
