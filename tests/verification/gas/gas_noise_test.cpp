// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How noisy the pressure of a real gas at rest is on the facets of its box, and how late it tells
// of a change: what the fabric gets, and exponential smoothing of hits, as eq. 27 predicts it.

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "gas/collisions/collide.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/wall_load/wall_load.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double SIDE = 0.1, TEMPERATURE = 300.0, SMOOTHING = 50e-6, STEP = 5e-6;
constexpr std::size_t PARTICLES = 1500;
constexpr int QUADS = 8;  ///< along an edge: 768 facets

/// Means over facets of their pressure and of its square.
struct Facets {
    double mean = 0.0, square = 0.0;
    void add(double p, std::size_t count) {
        mean += p / static_cast<double>(count);
        square += p * p / static_cast<double>(count);
    }
};

/// A box of gas whose hits go three ways: to a facet's own exponential mean, to nodes that release
/// them exponentially, and to nodes of quiet pressure.
class NoisyBox {
public:
    explicit NoisyBox(std::uint64_t seed)
        : collider_{mixture_.species(), mixture_.moles_each(), seed} {
        bag_.node_areas(shape_.x, area_);
        lists_.build(Grid::over(Vec3::Constant(-0.01), Vec3::Constant(SIDE + 0.01), 0.02, 100000),
                     shape_.x, shape_.x, 0.0, 0.02);
    }
    struct Now {
        Facets raw, plain, quiet;
    };
    Now step() {
        collider_.find_groups(grid_, {}, gas_);
        collider_.collide(count_++, STEP, 1.0, gas_);
        fly(lists_, shape_.x, shape_.x, STEP, mass_, {}, gas_, flight_);
        const double kept = std::exp(-STEP / SMOOTHING);
        for (double& p : raw_) p *= kept;
        for (const auto& hits : flight_.hits)
            for (const Hit& hit : hits)
                raw_[hit.facet] += (1.0 - kept) * hit.impulse.norm() / (STEP * facet_area());
        Now now;
        for (const double p : raw_) now.raw.add(p, raw_.size());
        now.plain = release_plain();
        now.quiet = release_quiet();
        return now;
    }
    /// Multiplies the pressure.
    void heat(double factor) {
        for (Vec3& v : gas_.v) v *= std::sqrt(factor);
        for (double& e : gas_.e) e *= factor;
    }
    [[nodiscard]] double pressure() const {
        return 2.0 * static_cast<double>(PARTICLES) * mixture_.half_heat() * TEMPERATURE /
               std::pow(SIDE, 3);
    }
    /// Hits a facet and second, eq. 27.
    [[nodiscard]] double frequency() const {
        const double v_rms =
            std::sqrt(6.0 * mixture_.half_heat() * TEMPERATURE / mixture_.particle_mass(0));
        return static_cast<double>(PARTICLES) * facet_area() * v_rms /
               (std::sqrt(6.0 * std::numbers::pi) * std::pow(SIDE, 3));
    }

private:
    [[nodiscard]] double facet_area() const {
        return 6.0 * SIDE * SIDE / static_cast<double>(shape_.triangles.size());
    }
    [[nodiscard]] Facets release_plain() {
        for (const auto& hits : flight_.hits)
            for (const Hit& hit : hits)
                for (int c = 0; c < 3; ++c)
                    owed_[lists_.triangles()[hit.facet][c]] += hit.at[c] * hit.impulse;
        Points f(shape_.x.size(), Vec3::Zero());
        for (std::size_t n = 0; n < f.size(); ++n) {
            const Vec3 given = -std::expm1(-STEP / SMOOTHING) * owed_[n];
            owed_[n] -= given;
            f[n] = given / STEP;
        }
        return on_facets(f);
    }
    [[nodiscard]] Facets release_quiet() {
        load_.find_sides(flight_, shape_.x, shape_.x);
        load_.receive(flight_, mass_, gas_);
        Points f(shape_.x.size(), Vec3::Zero());
        load_.release(STEP, shape_.x, still_, heavy_, f);
        return on_facets(f);
    }
    [[nodiscard]] Facets on_facets(const Points& f) const {
        Facets out;
        for (const Triangle& t : lists_.triangles()) {
            double on = 0.0;
            for (const Index n : t) on += f[n].dot(area_[n]) / area_[n].squaredNorm() / 3.0;
            out.add(on, lists_.triangles().size());
        }
        return out;
    }
    static std::vector<int> numbered(std::size_t n) {
        std::vector<int> ids(n);
        std::iota(ids.begin(), ids.end(), 1);
        return ids;
    }

    shapes::Shape shape_ = shapes::box(Vec3::Constant(SIDE), QUADS);
    std::vector<int> ids_ = numbered(shape_.x.size());
    Enclosure bag_{shape_.triangles, shape_.x, ids_, "box"};
    Mixture mixture_ = mixture_of({AIR});
    Particles gas_ = random_gas(PARTICLES, Vec3::Constant(SIDE), mixture_, {TEMPERATURE});
    std::vector<double> mass_{mixture_.particle_mass(0)};
    Collider collider_;
    Grid grid_ = Grid::over(Vec3::Zero(), Vec3::Constant(SIDE - 1e-12),
                            cell_edge(std::pow(SIDE, 3), PARTICLES, 20.0), 1000);
    FacetLists lists_{bag_.triangles(), shape_.x, FacetLists::Of::EIGHTS};
    std::vector<std::uint8_t> held_ = std::vector<std::uint8_t>(shape_.x.size(), 0);
    WallLoad load_{
        std::make_shared<WettedSurface>(bag_.triangles(), bag_.triangles().size(), shape_.x),
        held_,
        {},
        {SMOOTHING, SMOOTHING},
        0.0};
    Points owed_ = Points(shape_.x.size(), Vec3::Zero()), still_ = owed_;
    std::vector<double> heavy_ = std::vector<double>(shape_.x.size(), 1e9);
    Points area_ = Points(shape_.x.size(), Vec3::Zero());
    std::vector<double> raw_ = std::vector<double>(shape_.triangles.size(), 0.0);
    FlightResult flight_;
    std::uint64_t count_ = 0;
};

/// Relative root mean square deviation from the mean.
double noise(const Facets& sum) {
    return std::sqrt(sum.square / (sum.mean * sum.mean) - 1.0);
}

void add(const Facets& now, int of, Facets& sum) {
    sum.mean += now.mean / of;
    sum.square += now.square / of;
}

/// Time until a rise has come through by 1 - 1/e.
double delay(const std::vector<double>& mean) {
    const double from = mean.front(), to = mean.back();
    std::size_t i = 0;
    while (mean[i] < to - (to - from) * std::exp(-1.0)) ++i;
    return static_cast<double>(i) * STEP;
}

}  // namespace

TEST_CASE(
    "quiet pressure of a gas at rest has a third of the noise that smoothed hits have, and no "
    "more delay",
    "[gas][noise]") {
    constexpr int SETTLE = 1500, LOOK = 3000, PULSES = 10, AFTER = 1000;
    constexpr int DRAWS = 6;  // the ratio of one scatters by 3 %
    NoisyBox::Now sum;
    const auto look_at = [&](NoisyBox& drawn) {
        for (int i = 0; i < SETTLE; ++i) drawn.step();
        for (int i = 0; i < LOOK; ++i) {
            const NoisyBox::Now now = drawn.step();
            add(now.raw, DRAWS * LOOK, sum.raw);
            add(now.plain, DRAWS * LOOK, sum.plain);
            add(now.quiet, DRAWS * LOOK, sum.quiet);
        }
    };
    for (std::uint64_t seed = 1; seed < DRAWS; ++seed) {
        NoisyBox drawn(seed);
        look_at(drawn);
    }
    NoisyBox box(DRAWS);
    look_at(box);
    // Hits bring 2 m v_n, a hit's v_n has <v²>/<v>² = 4/pi, and exponential smoothing over tau
    // keeps 2 f tau of them.
    const double predicted =
        std::sqrt(4.0 / std::numbers::pi / (2.0 * box.frequency() * SMOOTHING));

    // Mean of many rises by half, each long enough apart for quiet pressure to forget (2 ms).
    constexpr int RISE = 100;
    std::vector<double> plain(RISE, 0.0), quiet(RISE, 0.0);
    for (int pulse = 0; pulse < PULSES; ++pulse) {
        box.heat(1.5);
        for (int i = 0; i < AFTER; ++i) {
            const NoisyBox::Now now = box.step();
            if (i >= RISE) continue;
            plain[i] += now.plain.mean / PULSES;
            quiet[i] += now.quiet.mean / PULSES;
        }
        box.heat(1.0 / 1.5);
        for (int i = 0; i < AFTER; ++i) box.step();
    }
    const double late_plain = delay(plain), late_quiet = delay(quiet);
    WARN("facet pressure of " << box.frequency() * SMOOTHING << " hits a facet in 50 us: eq. 27 "
                              << 100 * predicted << " %, facets' own " << 100 * noise(sum.raw)
                              << " %, plain smoothing " << 100 * noise(sum.plain) << " %, quiet "
                              << 100 * noise(sum.quiet) << " %; delay " << 1e6 * late_plain
                              << " and " << 1e6 * late_quiet << " us");
    // Eq. 27 takes hits to be independent: sound in the gas adds some 5 %.
    CHECK(noise(sum.raw) == Approx(predicted).epsilon(0.1));
    CHECK(noise(sum.quiet) < noise(sum.plain) / 3.0);
    CHECK(late_quiet <= late_plain + STEP);
    CHECK(late_plain == Approx(SMOOTHING).epsilon(0.2));
    CHECK(sum.quiet.mean == Approx(box.pressure()).epsilon(0.005));
}
