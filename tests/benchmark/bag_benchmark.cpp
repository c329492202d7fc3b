// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The gas of a whole bag, all in: facet lists, collisions, flight against 10 000 moving facets,
// impulses.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "gas/bag_gas.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"
#include "tests/support/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double STEP = 8e-6;  ///< of the fabric of such a bag             [s]

/// A bag whose fabric moves as told and that has taken in all its gas.
class Bag {
public:
    Bag(const shapes::Shape& shape, Points orifices, std::size_t particles)
        : rest_(shape.x), x_0_(shape.x), x_1_(shape.x) {
        BagCard card;
        card.id = 1;
        card.particles = particles;
        card.p_atm = 0.0;
        for (const Vec3& at : orifices) {
            OrificeCard orifice;
            orifice.node = static_cast<Index>(rest_.size());
            card.orifices.push_back(orifice);
            rest_.push_back(at);
        }
        x_0_ = x_1_ = rest_;
        InflowCard inflow;
        inflow.species = {0.028, 28.0, 0.0, 0.0};
        inflow.mass_rate = 0;
        inflow.temperature = 1;
        card.inflow = {inflow};
        const std::vector<Curve> curves = {{1, {0.0, STEP}, {0.05 / STEP, 0.05 / STEP}},
                                           {2, {0.0, 1.0}, {300.0, 300.0}}};
        BagWalls walls;
        walls.triangles = shape.triangles;
        walls.closing = walls.triangles.size();
        walls.shell.resize(walls.closing);
        walls.part.assign(walls.closing, 0);
        for (std::size_t t = 0; t < walls.closing; ++t) walls.shell[t] = static_cast<Index>(t);
        walls.part_ids = {1};
        std::vector<int> ids(rest_.size(), 1);
        std::vector<std::uint8_t> held(rest_.size(), 0);
        gas_ = std::make_unique<BagGas>(card, walls, curves, ids, held, rest_, 1);
        force_.resize(rest_.size());
        for (int s = 0; s < 150; ++s) step();
    }

    void step() {
        gas_->add_load(x_0_, STEP, force_);
        move();
        gas_->prepare(STEP, x_0_, x_1_);
        gas_->collide(STEP, x_0_);
        gas_->inject(t_, STEP, x_0_, x_1_);
        gas_->fly(t_, STEP, x_0_, x_1_);
        x_0_.swap(x_1_);
        t_ += STEP;
    }

    [[nodiscard]] const BagGas& gas() const { return *gas_; }

private:
    /// Waves of 5 mm that run round the bag at 500 Hz: 16 m/s at most.
    void move() {
        for (std::size_t n = 0; n < rest_.size(); ++n) {
            const double phase =
                2.0 * M_PI * (500.0 * (t_ + STEP) + 4.0 * (rest_[n].x() + 0.5 * rest_[n].y()));
            x_1_[n] = rest_[n] * (1.0 + 0.016 * std::sin(phase));
        }
    }

    Points rest_, x_0_, x_1_, force_;
    std::unique_ptr<BagGas> gas_;
    double t_ = 0.0;
};

/// Ellipsoid of 56 l, 10 092 triangles.
Bag inflated_bag(std::size_t particles) {
    shapes::Shape shape = shapes::box(Vec3(2, 2, 2), 29);
    for (Vec3& x : shape.x) x = (x - Vec3::Ones()).normalized().cwiseProduct(Vec3(0.3, 0.3, 0.15));
    Points orifices;
    for (std::uint64_t i = 0; orifices.size() < 500; ++i) {
        Random draw(1, Stream::INITIAL, 0, i);
        const Vec3 at = 2.0 * Vec3(draw.uniform(), draw.uniform(), draw.uniform()) - Vec3::Ones();
        if (at.norm() < 0.9) orifices.push_back(at.cwiseProduct(Vec3(0.3, 0.3, 0.15)));
    }
    return {shape, orifices, particles};
}

void inflated(benchmark::State& state) {
    parallel::set_threads(1);
    Bag bag = inflated_bag(static_cast<std::size_t>(state.range(0)));
    const auto n = static_cast<double>(bag.gas().particles().size());
    const std::size_t hits = bag.gas().hits(), builds = bag.gas().list_builds();
    const std::uint64_t collisions = bag.gas().collision_steps();
    for (auto _ : state) bag.step();
    const auto steps = static_cast<double>(state.iterations());
    state.counters["particle_steps"] =
        benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["hits"] = static_cast<double>(bag.gas().hits() - hits) / steps / n;
    state.counters["builds"] = static_cast<double>(bag.gas().list_builds() - builds) / steps;
    state.counters["collisions"] =
        static_cast<double>(bag.gas().collision_steps() - collisions) / steps;
}

/// The limit: positions and velocities once through the processor, mirror walls, nothing else.
void streaming(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<double> x(3 * n, 0.0), v(3 * n);
    for (std::size_t i = 0; i < v.size(); ++i)
        v[i] = 500.0 * Random(1, Stream::INITIAL, 1, i).uniform() - 250.0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double to = x[i] + STEP * v[i];
            v[i] = std::abs(to) > 0.3 ? -v[i] : v[i];
            x[i] = to;
        }
        benchmark::ClobberMemory();
    }
    state.counters["particle_steps"] =
        benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(streaming)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(inflated)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
