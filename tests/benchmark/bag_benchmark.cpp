// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The gas of a whole bag, inflated or tightly folded, all in: facet lists, collisions, flight
// against 10 000 moving facets, impulses; its memory, and the streaming limit of the same run.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <utility>

#include "gas/bag_gas.hpp"
#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// Steps over which the best speed is taken: all that recurs does so within. A machine with other
/// work shows its own speed in some of them.
constexpr int WINDOW = 24;

constexpr double STEP = 8e-6;  ///< of the fabric of such a bag             [s]

/// A bag whose fabric moves as told and that has taken in all its gas.
class Bag {
public:
    Bag(const shapes::Shape& shape, Points orifices, std::size_t particles, int first_steps)
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
        v_.assign(rest_.size(), Vec3::Zero());
        mass_.assign(rest_.size(), 1e-4);
        for (int s = 0; s < first_steps; ++s) step();
    }

    void step() {
        gas_->add_load(x_0_, v_, mass_, STEP, force_);
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
            v_[n] = (x_1_[n] - x_0_[n]) / STEP;
        }
    }

    Points rest_, x_0_, x_1_, v_, force_;
    std::vector<double> mass_;
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
    return {shape, orifices, particles, 150};
}

/// Thirty pleats 60 mm high of a bag whose gas lies in layers of 2 mm, 10 600 triangles.
Bag folded_bag(std::size_t particles) {
    const shapes::Pleats pleats{4e-3, 0.06, 0.03, 0.1, 30, 8, 10};
    Points orifices;
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random draw(1, Stream::INITIAL, 0, i);
        const double x = pleats.pitch * pleats.panels * (0.01 + 0.98 * draw.uniform());
        const double off = 0.8 * pleats.gap * (draw.uniform() - 0.5);
        orifices.emplace_back(x, pleats.width * (0.01 + 0.98 * draw.uniform()),
                              pleats.middle(x) + off);
    }
    return {shapes::pleated_bag(pleats), orifices, particles, 30};
}

/// What the program has allocated.                                                     [bytes]
double allocated() {
    const struct mallinfo2 now = mallinfo2();
    return static_cast<double>(now.uordblks + now.hblkhd);
}

/// The limit: positions and velocities once through the processor, mirror walls, nothing else.
class Stream3 {
public:
    explicit Stream3(std::size_t n) : x_(3 * n, 0.0), v_(3 * n) {
        for (std::size_t i = 0; i < v_.size(); ++i)
            v_[i] = 500.0 * Random(1, Stream::INITIAL, 1, i).uniform() - 250.0;
    }
    void step() {
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const double to = x_[i] + STEP * v_[i];
            v_[i] = std::abs(to) > 0.3 ? -v_[i] : v_[i];
            x_[i] = to;
        }
        benchmark::ClobberMemory();
    }

private:
    std::vector<double> x_, v_;
};

/// CPU time that streaming takes for a particle and step.                                   [s]
double streaming_limit(std::size_t n) {
    static std::map<std::size_t, double> known;
    if (known.contains(n)) return known[n];
    Stream3 gas(n);
    const auto steps = static_cast<int>(2e8 / static_cast<double>(n));
    gas.step();
    const std::clock_t began = std::clock();
    for (int i = 0; i < steps; ++i) gas.step();
    const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return known[n] = seconds / steps / static_cast<double>(n);
}

void run(benchmark::State& state, Bag (*make)(std::size_t)) {
    parallel::set_threads(1);
    const auto wanted = static_cast<std::size_t>(state.range(0));
    const double limit = streaming_limit(wanted);
    const double before = allocated();
    Bag bag = make(wanted);
    const double bytes = allocated() - before;
    const auto n = static_cast<double>(bag.gas().particles().size());
    const std::size_t hits = bag.gas().hits(), builds = bag.gas().list_builds();
    const std::uint64_t collisions = bag.gas().collision_steps();
    const std::clock_t began = std::clock();
    double best = INF;
    std::clock_t last = began;
    int steps_done = 0;
    for (auto _ : state) {
        bag.step();
        if (++steps_done % WINDOW != 0) continue;
        const std::clock_t now = std::clock();
        best = std::min(best, static_cast<double>(now - std::exchange(last, now)));
    }
    const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    const auto steps = static_cast<double>(state.iterations());
    state.counters["particle_steps"] =
        benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["best"] = WINDOW * n * CLOCKS_PER_SEC / best;  // particle-steps/s
    state.counters["times_limit"] = seconds / steps / n / limit;
    state.counters["bytes"] = bytes / n;  // with facets, lists and cells
    state.counters["hits"] = static_cast<double>(bag.gas().hits() - hits) / steps / n;
    state.counters["builds"] = static_cast<double>(bag.gas().list_builds() - builds) / steps;
    state.counters["collisions"] =
        static_cast<double>(bag.gas().collision_steps() - collisions) / steps;
    state.counters["lost"] = static_cast<double>(bag.gas().lost());
}

void inflated(benchmark::State& state) {
    run(state, inflated_bag);
}
void folded(benchmark::State& state) {
    run(state, folded_bag);
}

void streaming(benchmark::State& state) {
    Stream3 gas(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) gas.step();
    state.counters["particle_steps"] = benchmark::Counter(
        static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}

/// The everyday size, ten times it, and the large one.
void sizes(benchmark::internal::Benchmark* rows) {
    rows->Arg(100000)->Arg(1000000)->Arg(2000000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(streaming)->Apply(sizes);
BENCHMARK(inflated)->Apply(sizes);
BENCHMARK(folded)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
