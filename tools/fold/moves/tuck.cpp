// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/moves/tuck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "tools/fold/moves/accordion.hpp"

namespace corpuscle::fold {
namespace {

constexpr double STEEPEST = 0.25;       ///< slope of the ramp
constexpr double LEAST_PER_GAP = 1.05;  ///< band: below 0.5 the panels would not reach round
constexpr double NARROWER = 0.5;        ///< in gaps: what was pushed in, at its end, at each rim
constexpr double MORE_THAN_TWO = 1.01;  ///< layers: heights, in halves of the gap

Mat3 frame(const Tuck& f) {
    return fold_frame(f.angle, f.is_left, /*is_down=*/false);
}

double ramp_start(const Tuck& f) {
    return f.top - f.ramp;
}

/// D: what the ramp draws in while the panels climb a gap. [m]
double drawn_in(const Tuck& f, double gap) {
    return f.ramp - std::sqrt(f.ramp * f.ramp - gap * gap);
}

double opening(const Tuck& f, double s) {
    if (s <= ramp_start(f)) return 1.0;
    if (s < f.top) return 1.0 + 2.0 * (s - ramp_start(f)) / f.ramp;
    if (s <= f.line - f.band) return 3.0;
    return std::max(1.0, 2.0 - (s - f.line) / f.band);
}

double place(const Tuck& f, double gap, double s) {
    const double start = ramp_start(f), drawn = drawn_in(f, gap);
    if (s <= start) return s;
    if (s < f.top) return s - drawn * (s - start) / f.ramp;
    const double off = std::abs(s - f.line);
    if (off >= f.band) return (s < f.line ? s : 2.0 * f.line - s) - drawn;
    const double w = 1.0 - off / f.band;
    const double d = f.band - std::sqrt(f.band * f.band - 0.25 * gap * gap);
    return f.line - drawn - ((1.0 - w) * f.band + w * d);
}

struct Reach {
    double low = INF, high = -INF;
    void include(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};

void check_two_layers(const Tuck& f, const Points& local, double gap) {
    double most = 0.0;
    for (const Vec3& p : local)
        if (p.x() > ramp_start(f)) most = std::max(most, std::abs(p.z()));
    if (most > MORE_THAN_TWO * 0.5 * gap)
        throw InputError(fmt::format(
            "{}: from {:.4g} on cloth lies up to {:.4g} away from the seam's height, expected the "
            "two panels {:.4g} away: a tuck goes before other folds there, and clear of tethers "
            "and other tucks",
            f.name, ramp_start(f), most, 0.5 * gap));
}

/// What is pushed in must find the bag as wide there as it is itself.
void check_width(const Tuck& f, const Points& local, double gap, double size) {
    double over = 0.0;
    for (const Vec3& p : local) {
        if (p.x() <= f.line) continue;
        Reach t;  // of the bag within two elements, a long edge, of where p comes to lie
        for (const Vec3& q : local)
            if (q.x() <= f.line && std::abs(q.x() - (2.0 * f.line - p.x())) < 2.0 * size)
                t.include(q.y());
        over = std::max({over, p.y() - t.high, t.low - p.y()});
    }
    if (over > gap)
        throw InputError(fmt::format(
            "{}: what it pushes in stands out by {:.4g} where it comes to lie, expected a bag that "
            "gets no wider towards its side",
            f.name, over));
}

Points to_local(const Tuck& f, const Points& x) {
    const Mat3 to = frame(f);
    Points local(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) local[n] = to * x[n];
    return local;
}

}  // namespace

void choose_bands(Tuck& f, const Points& x, double gap, double size) {
    const Points local = to_local(f, x);
    Reach s;
    for (const Vec3& p : local) s.include(p.x());
    if (f.line <= s.low || f.line >= s.high)
        throw InputError(fmt::format(
            "{}: its line is at {:.4g}, expected between {:.4g} and {:.4g}, where there "
            "is cloth on both sides (measured towards the side that is tucked)",
            f.name, f.line, s.low, s.high));
    f.band = std::max(size, LEAST_PER_GAP * gap);
    f.ramp = std::max(size, gap / STEEPEST);
    f.top = 2.0 * f.line - s.high - size;
    const double depth = s.high - f.line;
    if (depth < 2.0 * f.band)
        throw InputError(
            fmt::format("{}: it is {:.4g} deep, expected at least {:.4g}, two elements", f.name,
                        depth, 2.0 * f.band));
    const double room = std::max(s.low, f.room);
    if (ramp_start(f) < room)
        throw InputError(fmt::format(
            "{}: it is {:.4g} deep and needs room down to {:.4g}, expected at least {:.4g}: make "
            "it less deep",
            f.name, depth, ramp_start(f), room));
    check_two_layers(f, local, gap);
    check_width(f, local, gap, size);
}

void apply(const Tuck& f, double gap, Points& x) {
    const Points local = to_local(f, x);
    check_two_layers(f, local, gap);
    Reach s, t;  // of what is pushed in
    for (const Vec3& p : local)
        if (p.x() > f.line) {
            s.include(p.x());
            t.include(p.y());
        }
    const double middle = 0.5 * (t.low + t.high);
    const double slope = NARROWER * gap / (0.5 * (t.high - t.low) * (s.high - f.line));
    const Mat3 back = frame(f).transpose();
    for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3& p = local[n];
        const double in = slope * std::max(0.0, p.x() - f.line) * (p.y() - middle);
        x[n] = back * Vec3(place(f, gap, p.x()), p.y() - in, opening(f, p.x()) * p.z());
    }
}

std::vector<double> distance(const Tuck& f, double at, const Points& x) {
    const Mat3 to = frame(f);
    std::vector<double> all(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) all[n] = to.row(0).dot(x[n]) - at;
    return all;
}

std::vector<double> borders(const Tuck& f, int parts) {
    std::vector<double> all{ramp_start(f), f.top};
    for (int k = -parts; k <= parts; ++k) all.push_back(f.line + f.band * k / parts);
    return all;
}

bool is_turned(const Tuck& f, const Vec3& x) {
    return frame(f).row(0).dot(x) > f.line;
}

std::vector<double> before(const Tuck& f, double gap, double after) {
    const double drawn = drawn_in(f, gap), tiny = 1e-9 * f.band;
    std::vector<double> all;
    if (after <= ramp_start(f) + tiny) all.push_back(after);
    if (const double s = after + drawn; s >= f.top - tiny && s <= f.line - f.band + tiny)
        all.push_back(s);
    if (const double s = 2.0 * f.line - drawn - after; s >= f.line + f.band - tiny)
        all.push_back(s);
    return all;
}

}  // namespace corpuscle::fold
