// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What hits bring reaches the fabric: all of it, promptly, and quietly.

#include "gas/wall_load/impulse_store.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

#include "solver/base/random.hpp"
#include "tests/support/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double TIME = 50e-6, STEP = 5e-6;

/// A box whose walls are hit at random, each facet equally often, with an impulse that is
/// exponential in size (as m v_n² is): one hit a facet and `TIME` at `pressure` 1.
class HitBox {
public:
    explicit HitBox(bool is_quiet)
        : ids_(numbered(shape_.x.size())),
          bag_(shape_.triangles, shape_.x, ids_, "bag 1"),
          held_(shape_.x.size(), 0),
          store_(shape_.x.size(), bag_.nodes(), bag_, held_, TIME, is_quiet),
          area_(shape_.x.size(), Vec3::Zero()) {
        bag_.node_areas(shape_.x, area_);
        flight_.hits.resize(1);
    }

    /// Mean and root mean square deviation of the facets' pressure, of those whose mean is
    /// `pressure`.
    struct Facets {
        double mean = 0.0, scatter = 0.0;
    };

    Facets step(double pressure) {
        flight_.hits[0].clear();
        for (std::size_t f = 0; f < bag_.triangles().size(); ++f) {
            Random draw(9, Stream::WALL, step_, f);
            for (double t = -std::log(draw.uniform()); t < pressure * STEP / TIME;
                 t -= std::log(draw.uniform())) {
                const double u = draw.uniform(), v = draw.uniform(), root = std::sqrt(u);
                const Vec3 impulse = -std::log(draw.uniform()) * TIME * normal(f);
                flight_.hits[0].push_back(
                    {static_cast<Index>(f), {1 - root, root * (1 - v), root * v}, impulse, 0.0});
                brought_ += impulse.norm();
            }
        }
        ++step_;
        store_.receive(flight_, bag_.triangles());
        Points f(shape_.x.size(), Vec3::Zero());
        store_.release(STEP, area_, f);
        Facets out;
        for (std::size_t t = 0; t < bag_.triangles().size(); ++t) {
            double on = 0.0;
            for (const Index n : bag_.triangles()[t])
                on += f[n].dot(area_[n]) / area_[n].squaredNorm() / 3.0;
            out.mean += on / static_cast<double>(bag_.triangles().size());
            out.scatter +=
                (on - pressure) * (on - pressure) / static_cast<double>(bag_.triangles().size());
        }
        for (std::size_t n = 0; n < f.size(); ++n) given_ += STEP * f[n].dot(area_[n].normalized());
        out.scatter = std::sqrt(out.scatter);
        return out;
    }
    [[nodiscard]] double brought() const { return brought_; }
    [[nodiscard]] double given() const { return given_; }

private:
    static std::vector<int> numbered(std::size_t n) {
        std::vector<int> ids(n);
        std::iota(ids.begin(), ids.end(), 1);
        return ids;
    }
    [[nodiscard]] Vec3 normal(std::size_t f) const {
        const auto& [a, b, c] = bag_.triangles()[f];
        return vector_area(shape_.x[a], shape_.x[b], shape_.x[c]);
    }

    shapes::Shape shape_ = shapes::sphere(1.0, 4);
    std::vector<int> ids_;
    Enclosure bag_;
    std::vector<std::uint8_t> held_;
    ImpulseStore store_;
    Points area_;
    FlightResult flight_;
    std::uint64_t step_ = 0;
    double brought_ = 0.0, given_ = 0.0;
};

struct Measured {
    double scatter = 0.0, delay = 0.0, share_given = 0.0;
};

/// Scatter at rest; time until a step of the pressure from 1 to 2 has come through by 1 - 1/e; and
/// the share of all impulse that the fabric has had at the end.
Measured measure(bool is_quiet) {
    HitBox box(is_quiet);
    Measured out;
    constexpr int STEPS = 2000;
    for (int s = 0; s < STEPS; ++s) {
        const double scatter = box.step(1.0).scatter;
        if (s >= STEPS / 2) out.scatter += scatter / (STEPS / 2);
    }
    while (box.step(2.0).mean < 2.0 - std::exp(-1.0)) out.delay += STEP;
    for (int s = 0; s < STEPS; ++s) box.step(0.0);
    out.share_given = box.given() / box.brought();
    return out;
}

}  // namespace

TEST_CASE("the expected pressure is a third as noisy as plain smoothing, at the same delay",
          "[gas]") {
    const Measured quiet = measure(true), plain = measure(false);
    WARN("facet pressure scatters by " << 100 * quiet.scatter << " % against "
                                       << 100 * plain.scatter << " %, delay " << 1e6 * quiet.delay
                                       << " against " << 1e6 * plain.delay << " us");
    CHECK(quiet.scatter < plain.scatter / 3.0);
    CHECK(quiet.delay <= plain.delay + STEP);
    // Nothing is lost: after 10 ms without hits all has been given.
    CHECK(plain.share_given == Approx(1.0).epsilon(5e-3));
    CHECK(quiet.share_given == Approx(1.0).epsilon(5e-3));
}

TEST_CASE(
    "fabric that flutters is pushed back by the sound that it makes, that moves as one is not",
    "[gas]") {
    const shapes::Shape shape = shapes::sphere(1.0, 3);
    std::vector<int> ids(shape.x.size());
    std::iota(ids.begin(), ids.end(), 1);
    const Enclosure bag(shape.triangles, shape.x, ids, "bag 1");
    Points area(shape.x.size(), Vec3::Zero());
    bag.node_areas(shape.x, area);
    constexpr double PRESSURE = 2.0, SPEED = 3.0, PER_SPEED = 0.1;
    const auto pressures = [&](auto&& velocity) {
        ExpectedPressure expected(shape.x.size(), bag, TIME);
        Points x_1 = shape.x, hits(shape.x.size());
        for (std::size_t n = 0; n < x_1.size(); ++n) {
            x_1[n] += STEP * velocity(n) * shape.x[n];
            hits[n] = STEP * PRESSURE * area[n];
        }
        expected.begin_with(PRESSURE, area);
        expected.feel_motion(shape.x, x_1, STEP, area, PER_SPEED);
        expected.update(STEP, hits, area);
        std::vector<double> found;
        for (std::size_t i = 0; i < bag.nodes().size(); ++i) found.push_back(expected[i]);
        return found;
    };
    for (const double p : pressures([](std::size_t) { return SPEED; }))
        CHECK(p == Approx(PRESSURE).epsilon(1e-3));
    // Every other node goes the other way: neighbours' mean is near 0.
    const auto swing = [](std::size_t n) { return n % 2 == 0 ? SPEED : -SPEED; };
    const auto found = pressures(swing);
    double off = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double wanted = PRESSURE * (1.0 - PER_SPEED * swing(bag.nodes()[i]));
        off += std::abs(found[i] - wanted) / PRESSURE / static_cast<double>(found.size());
    }
    CHECK(off < 0.3 * PER_SPEED * SPEED);
}
