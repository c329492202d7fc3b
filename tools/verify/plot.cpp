// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corpuscle::verify {
namespace {

constexpr double WIDTH = 480.0, HEIGHT = 300.0;  ///< of the plot                        [px]
constexpr double LEFT = 56.0, TOP = 12.0, BELOW = 42.0, LEGEND = 300.0;
constexpr std::array<const char*, 10> COLOURS{"#1b6ca8", "#c1440e", "#2e7d32", "#7b3fa0",
                                              "#b8860b", "#00838f", "#ad1457", "#5d4037",
                                              "#455a64", "#9e9d24"};

struct Mark {
    double x, y, low, high;  ///< CPU seconds; |error| over budget, ends of its interval
};

struct Line {
    std::string name;
    std::vector<Mark> marks;
};

Line line_of(const Row& row) {
    Line line{row.name(), {}};
    for (const Point& p : row.points) {
        const double y = std::abs(p.error.value) / row.budget;
        if (!(y > 0.0) || !(p.cpu_seconds > 0.0) || !std::isfinite(y)) continue;
        const double half = std::isnan(p.error.half_width) ? 0.0 : p.error.half_width / row.budget;
        line.marks.push_back({p.cpu_seconds, y, std::max(y - half, 0.0), y + half});
    }
    return line;
}

/// A logarithmic axis over whole decades.
struct Axis {
    double low, high;  ///< decades
    double from, to;   ///< where they lie                                              [px]

    [[nodiscard]] double at(double value) const {
        const double decade = std::clamp(std::log10(value), low, high);
        return from + (decade - low) / (high - low) * (to - from);
    }
};

Axis axis(double least, double most, double from, double to) {
    const double low = std::floor(std::log10(least)), high = std::ceil(std::log10(most));
    return {low, std::max(high, low + 1.0), from, to};
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg;
    for (double d = x.low; d <= x.high; d += 1.0) {
        const double at = x.at(std::pow(10.0, d));
        svg += fmt::format(
            "<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}'/>"
            "<text x='{0:.1f}' y='{3:.1f}' text-anchor='middle'>{4:g}</text>",
            at, y.from, y.to, y.from + 16.0, std::pow(10.0, d));
    }
    for (double d = y.low; d <= y.high; d += 1.0) {
        const double at = y.at(std::pow(10.0, d));
        svg += fmt::format(
            "<line class='grid' x1='{1:.1f}' x2='{2:.1f}' y1='{0:.1f}' y2='{0:.1f}'/>"
            "<text x='{3:.1f}' y='{4:.1f}' text-anchor='end'>{5:g}</text>",
            at, x.from, x.to, x.from - 6.0, at + 4.0, std::pow(10.0, d));
    }
    return svg + fmt::format(
                     "<line class='budget' x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}'/>"
                     "<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>CPU seconds of a run</text>"
                     "<text transform='translate(12 {:.1f}) rotate(-90)' text-anchor='middle'>"
                     "|error| / budget</text>",
                     x.from, x.to, y.at(1.0), y.at(1.0), 0.5 * (x.from + x.to), y.from + 34.0,
                     0.5 * (y.from + y.to));
}

std::string drawn(const Line& line, const char* colour, const Axis& x, const Axis& y) {
    std::string svg = fmt::format("<polyline fill='none' stroke='{}' points='", colour);
    for (const Mark& m : line.marks) svg += fmt::format("{:.1f},{:.1f} ", x.at(m.x), y.at(m.y));
    svg += "'/>";
    for (const Mark& m : line.marks) {
        const double low = m.low > 0.0 ? y.at(m.low) : y.from;
        svg += fmt::format(
            "<line stroke='{0}' x1='{1:.1f}' x2='{1:.1f}' y1='{2:.1f}' y2='{3:.1f}'/>"
            "<circle fill='{0}' cx='{1:.1f}' cy='{4:.1f}' r='3.5'>"
            "<title>{5}: {6:.3g} of the budget, {7:.3g} s</title></circle>",
            colour, x.at(m.x), low, y.at(m.high), y.at(m.y), line.name, m.y, m.x);
    }
    return svg;
}

}  // namespace

std::string error_plot(const std::vector<Row>& rows) {
    std::vector<Line> lines;
    double x0 = INF, x1 = 0.0, y0 = 1.0, y1 = 1.0;
    for (const Row& row : rows) {
        Line line = line_of(row);
        for (const Mark& m : line.marks) {
            x0 = std::min(x0, m.x);
            x1 = std::max(x1, m.x);
            y0 = std::min(y0, m.y);
            y1 = std::max(y1, m.y);
        }
        if (!line.marks.empty()) lines.push_back(std::move(line));
    }
    if (lines.empty()) return "";
    const double low = std::max(y0, 1e-6);  // errors of rounding lie on the lower edge
    const double height = std::max(HEIGHT, TOP + BELOW + 16.0 * static_cast<double>(lines.size()));
    const Axis x = axis(0.99 * x0, 1.01 * x1, LEFT, WIDTH);
    const Axis y = axis(0.99 * low, 2.0 * y1, height - BELOW, TOP);
    std::string svg = fmt::format("<svg viewBox='0 0 {0} {1}' width='{0}' height='{1}'>",
                                  WIDTH + LEGEND, height) +
                      grid(x, y);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const char* const colour = COLOURS[k % COLOURS.size()];
        svg += drawn(lines[k], colour, x, y);
        const double at = TOP + 8.0 + 16.0 * static_cast<double>(k);
        svg += fmt::format("<circle fill='{}' cx='{}' cy='{}' r='4'/><text x='{}' y='{}'>{}</text>",
                           colour, WIDTH + 20.0, at, WIDTH + 30.0, at + 4.0, lines[k].name);
    }
    return svg + "</svg>\n";
}

}  // namespace corpuscle::verify
