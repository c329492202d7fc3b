// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/moves/accordion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle::fold {
namespace {

constexpr double WIDTH_PER_CLIMB = 2.0;   ///< of a band; flatter bands shorten less
constexpr double LEAST_PER_CLIMB = 1.05;  ///< below this the outermost layer would not reach
constexpr double LEAST_FLAT = 0.6;  ///< flat part between two bands, in element sizes, or none
constexpr double CLOSED = 0.5;      ///< of a band, that the turned pack may fill at its line
constexpr double SPREAD = 2.0;      ///< layers are that much farther apart at a line, at most

double sign(std::size_t strip) {
    return strip % 2 == 0 ? 1.0 : -1.0;
}

Mat3 frame(const Accordion& f) {
    return fold_frame(f.angle, f.is_left, f.is_down);
}

std::size_t strip_of(const Accordion& f, double s) {
    return static_cast<std::size_t>(std::upper_bound(f.lines.begin(), f.lines.end(), s) -
                                    f.lines.begin());
}

struct Range {
    double low = INF, high = -INF;
    void include(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};

double slack(const Accordion& f) {  // that a node on a line may be off it
    return 1e-6 * (f.bands.empty() ? 1.0 : f.bands.front());
}

double band(const Accordion& f, std::size_t i) {
    return f.bands.empty() ? 0.0 : f.bands[i];
}

/// Heights u of all nodes of a strip; those on its lines belong to both sides.
std::vector<Range> strip_ranges(const Accordion& f, const Points& local) {
    std::vector<Range> all(f.lines.size() + 1);
    for (const Vec3& p : local)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool is_right = i == 0 || p.x() >= f.lines[i - 1] - slack(f);
            const bool is_left = i == f.lines.size() || p.x() <= f.lines[i] + slack(f);
            if (is_left && is_right) all[i].include(p.z());
        }
    return all;
}

/// s' that a strip covers.
Range reach(const Accordion& f, std::size_t i, double first, double last) {
    Range r;
    r.include(mirrored(f, i, i == 0 ? first : f.lines[i - 1]));
    r.include(mirrored(f, i, i == f.lines.size() ? last : f.lines[i]));
    return r;
}

Points to_local(const Accordion& f, const Points& x) {
    const Mat3 to = frame(f);
    Points local(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) local[n] = to * x[n];
    return local;
}

Heights local_heights(const Accordion& f, const Points& x, double gap) {
    Range s;
    for (const Vec3& p : x) s.include(p.x());
    const std::vector<Range> z = strip_ranges(f, x);
    Heights h;
    h.offset.push_back(0.0);
    for (std::size_t i = 1; i <= f.lines.size() && f.lines[i - 1] < s.high; ++i) {
        const Range mine = reach(f, i, s.low, s.high);
        double top = -INF;  // of what it comes to lie on
        for (const Vec3& p : x)
            if (p.x() <= f.lines[0] && p.x() >= mine.low - gap && p.x() <= mine.high + gap)
                top = std::max(top, p.z());
        for (std::size_t j = 1; j < i; ++j) {
            const Range other = reach(f, j, s.low, s.high);
            if (other.low <= mine.high + gap && mine.low <= other.high + gap)
                top = std::max(top, h.offset[j] + (sign(j) > 0 ? z[j].high : -z[j].low));
        }
        const double bottom = sign(i) > 0 ? z[i].low : -z[i].high;
        h.offset.push_back(top + gap - bottom);
    }
    for (std::size_t i = 0; i + 1 < h.offset.size(); ++i) {
        h.middle.push_back(0.5 * (h.offset[i] + h.offset[i + 1]));
        Range inside, beside;
        for (const Vec3& p : x) {
            const double u = sign(i) * p.z();
            const auto strip =
                static_cast<std::ptrdiff_t>(strip_of(f, p.x())) - static_cast<std::ptrdiff_t>(i);
            if (strip == 0 || strip == 1) beside.include(u);
            if (std::abs(p.x() - f.lines[i]) <= band(f, i) + slack(f)) inside.include(u);
        }
        if (inside.low > inside.high) inside = beside;
        h.low.push_back(inside.low);
        h.high.push_back(inside.high);
        h.least.push_back(beside.low);
        h.most.push_back(beside.high);
    }
    return h;
}

InputError too_thick(const Accordion& f, std::size_t i, double climb, double room) {
    return InputError(fmt::format(
        "{}: at line {} the pack turns over a height of {:.4g}, for which a strip needs a width of "
        "{:.4g} on each side, but there is {:.4g}: make the pleats wider or the gap smaller",
        f.name, i + 1, 2.0 * climb, LEAST_PER_CLIMB * climb, room));
}

/// Cloth must lie on both sides of every line that the recipe counts on.
void check_reach(const Accordion& f, const Points& x) {
    Range s;
    for (const double v : distance(f, 0.0, x)) s.include(v);
    const std::size_t n = std::min(f.needed, f.lines.size());
    for (std::size_t i = 0; i < n; ++i)
        if (f.lines[i] <= s.low || f.lines[i] >= s.high)
            throw InputError(
                fmt::format("{}: line {} is at {:.4g}, expected between {:.4g} and {:.4g}, where "
                            "there is cloth "
                            "on both sides (measured towards the side that is folded)",
                            f.name, i + 1, f.lines[i], s.low, s.high));
}

/// One node beside line i.
Vec3 turned(const Accordion& f, const Heights& h, std::size_t i, const Vec3& p) {
    const double width = f.bands[i], climb = h.middle[i] - h.offset[i] - h.low[i];
    const double thick = h.high[i] - h.low[i];
    const double d = width - std::sqrt(width * width - climb * climb);
    const double spread =
        thick > 0.0 ? std::min({CLOSED * (width - d) / thick, SPREAD, width / climb}) : 0.0;
    const double off = p.x() - f.lines[i], u = sign(i) * p.z();
    const double w = 1.0 - std::abs(off) / width;
    const double flat = off < 0.0 ? h.offset[i] + u : h.offset[i + 1] - u;
    const double inward = (1.0 - w) * width + w * (d + spread * (u - h.low[i]));
    return {mirrored(f, i, f.lines[i]) - sign(i) * inward, p.y(),
            (1.0 - w) * flat + w * h.middle[i]};
}

}  // namespace

Mat3 fold_frame(double angle, bool is_left, bool is_down) {
    const double side = is_left ? -1.0 : 1.0, up = is_down ? -1.0 : 1.0;
    // multiples of 90 degrees are exact: lines that the mesh was made for are met to the last bit
    const auto exact = [](double v) { return std::abs(v) < 1e-15 ? 0.0 : v; };
    const double c = exact(std::cos(angle)), s = exact(std::sin(angle));
    Mat3 to;
    to << side * c, side * s, 0.0, -s, c, 0.0, 0.0, 0.0, up;
    return to;
}

double mirrored(const Accordion& f, std::size_t strip, double s) {
    for (std::size_t i = strip; i-- > 0;) s = 2.0 * f.lines[i] - s;
    return s;
}

std::vector<double> before(const Accordion& f, double /*gap*/, double after) {
    if (f.lines.empty()) return {after};
    std::vector<double> all;
    for (std::size_t i = 0; i <= f.lines.size(); ++i) {
        const double s = (i % 2 ? -1.0 : 1.0) * (after - mirrored(f, i, 0.0));
        const double tiny = 1e-9 * f.bands.front();
        if (i > 0 && s < f.lines[i - 1] + f.bands[i - 1] - tiny) continue;
        if (i < f.lines.size() && s > f.lines[i] - f.bands[i] + tiny) continue;
        all.push_back(s);
    }
    return all;
}

bool is_turned(const Accordion& f, const Vec3& x) {
    return strip_of(f, direction(f).dot(x)) % 2 == 1;
}

Vec3 direction(const Accordion& f) {
    return frame(f).row(0).transpose();
}

std::vector<double> distance(const Accordion& f, double at, const Points& x) {
    const Mat3 to = frame(f);
    std::vector<double> all(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) all[n] = to.row(0).dot(x[n]) - at;
    return all;
}

std::vector<double> borders(const Accordion& f, int parts) {
    std::vector<double> all;
    for (std::size_t i = 0; i < f.lines.size(); ++i)
        for (int k = -parts; k <= parts; ++k) {
            const double at = f.lines[i] + f.bands[i] * k / parts;
            if (all.empty() || at > all.back() + 1e-6 * f.bands[i]) all.push_back(at);
        }
    return all;
}

Heights heights(const Accordion& f, const Points& x, double gap) {
    return local_heights(f, to_local(f, x), gap);
}

void choose_bands(Accordion& f, const Points& x, double gap, double size) {
    check_reach(f, x);
    const Heights h = heights(f, x, gap);
    f.lines.resize(h.middle.size());  // those that the cloth reaches
    f.bands.assign(f.lines.size(), 0.0);
    for (std::size_t i = 0; i < f.lines.size(); ++i)
        f.bands[i] = std::max(size, WIDTH_PER_CLIMB * h.climb(i));
    if (!f.bands.empty()) f.bands[0] = std::min(f.bands[0], f.room);
    for (std::size_t i = 0; i + 1 < f.lines.size(); ++i) {
        const double width = f.lines[i + 1] - f.lines[i];
        if (f.bands[i] + f.bands[i + 1] <= width - LEAST_FLAT * size) continue;
        f.bands[i] = std::min(f.bands[i], 0.5 * width);
        f.bands[i + 1] = 0.5 * width;
    }
    for (std::size_t i = 0; i < f.lines.size(); ++i)
        if (f.bands[i] < LEAST_PER_CLIMB * h.climb(i))
            throw too_thick(f, i, h.climb(i), f.bands[i]);
}

void apply(const Accordion& f, double gap, Points& x) {
    check_reach(f, x);
    Points local = to_local(f, x);
    const Heights h = local_heights(f, local, gap);
    const std::size_t lines = h.middle.size();  // that this cloth reaches
    for (std::size_t i = 0; i < lines; ++i)
        if (const double climb = h.middle[i] - h.offset[i] - h.low[i]; f.bands[i] < climb)
            throw too_thick(f, i, climb, f.bands[i]);
    const Mat3 back = frame(f).transpose();
    for (std::size_t n = 0; n < x.size(); ++n) {
        Vec3& p = local[n];
        const std::size_t strip = std::min(strip_of(f, p.x()), lines);
        if (strip < lines && f.lines[strip] - p.x() < f.bands[strip])
            p = turned(f, h, strip, p);
        else if (strip > 0 && p.x() - f.lines[strip - 1] < f.bands[strip - 1])
            p = turned(f, h, strip - 1, p);
        else if (strip > 0)
            p = {mirrored(f, strip, p.x()), p.y(), h.offset[strip] + sign(strip) * p.z()};
        x[n] = back * p;
    }
}

}  // namespace corpuscle::fold
