// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/loop_meter.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <vector>

#include "solver/base/parallel.hpp"
#include "solver/base/tasks.hpp"
#include "tests/unit/solver/base/some_threads.hpp"

using namespace corpuscle;
using support::Threads;

namespace {

/// A clock that stands until it is moved on.
class HandClock {
public:
    using Clock = benchmark::LoopMeter::Clock;
    static Clock::time_point now() { return Clock::time_point(time_); }
    static Clock::time_point busy() { return Clock::time_point(busy_); }
    static void wait(int milliseconds) { time_ += std::chrono::milliseconds(milliseconds); }
    static void pass(int milliseconds) {
        wait(milliseconds);
        busy_ += std::chrono::milliseconds(milliseconds);
    }

private:
    inline static Clock::duration time_{}, busy_{};  ///< of all; of this thread
};

parallel::TaskShares shares_of_like_weight(std::size_t tasks) {
    parallel::TaskShares shares;
    shares.deal(
        tasks, [](std::size_t place) { return place; }, [](std::size_t) { return 1.0; });
    return shares;
}

}  // namespace

TEST_CASE("chunks of 30, 10, 10 and 10 ms take 60, 30 and 30 ms on 1, 2 and 4 cores", "[base]") {
    const Threads threads(1);
    benchmark::LoopMeter meter(&HandClock::now, &HandClock::busy);
    const std::vector<int> chunks{30, 10, 10, 10};
    parallel::for_each(
        chunks.size(), [&](std::size_t i) { HandClock::pass(chunks[i]); }, 1);
    HandClock::pass(20);
    CHECK(meter.loops() == 1);
    CHECK(meter.seconds() == Approx(0.080));
    CHECK(meter.outside() == Approx(0.020));
    CHECK(meter.wall(0) == Approx(0.080));       // 1 core: all, and what lies outside
    CHECK(meter.wall(1) == Approx(0.050));       // 2 cores
    CHECK(meter.wall(2) == Approx(0.050));       // 4 cores: the longest chunk
    CHECK(meter.wall(1, 1.0) == Approx(1.050));  // a call of the threads a loop
    CHECK(meter.wall(0, 1.0) == Approx(0.080));
    const auto sites = meter.sites();
    REQUIRE(sites.size() == 2);  // the loop, and what came before it
    const auto& site =
        sites.begin()->first.find("->") == std::string::npos ? *sites.begin() : *sites.rbegin();
    CHECK(site.first.find("loop_meter_test.cpp:") != std::string::npos);
    CHECK(site.second.time == Approx(0.060));
    CHECK(site.second.lost(2) == Approx(0.015));  // 30 ms instead of a quarter of 60
}

TEST_CASE("loops in turn wait for each other: 30 and 10, then 10 and 30 ms", "[base]") {
    const Threads threads(1);
    benchmark::LoopMeter meter(&HandClock::now, &HandClock::busy);
    const int time[2][2] = {{30, 10}, {10, 30}};
    parallel::in_turn(2, [&](std::size_t loop) {
        return parallel::each(
            2, [&time, loop](std::size_t i) { HandClock::pass(time[loop][i]); }, 1);
    });
    CHECK(meter.loops() == 1);
    CHECK(meter.wall(0) == Approx(0.080));
    CHECK(meter.wall(1) == Approx(0.060));       // not 40: 30 each
    CHECK(meter.wall(1, 1.0) == Approx(1.560));  // a call, and a wait that costs half of one
}

TEST_CASE("tasks of 30 and 10 ms, then 20 that wait for the first alone, and 10", "[base]") {
    const Threads threads(1);
    benchmark::LoopMeter meter(&HandClock::now, &HandClock::busy);
    const std::vector<int> time{30, 10, 20, 10};
    parallel::Tasks tasks;
    tasks.run(
        shares_of_like_weight(time.size()),
        [](std::size_t task, auto&& visit) {
            if (task == 2) visit(std::size_t{0});
        },
        [&](std::size_t task) { HandClock::pass(time[task]); }, true, parallel::Cut().where);
    CHECK(meter.wall(0) == Approx(0.070));
    // The second core has done its first at 10 ms, and waits until 30 for the first core
    CHECK(meter.wall(1) == Approx(0.050));
    CHECK(meter.wall(1, 1.0) == Approx(1.050));  // one call, no wait of all for all
}

TEST_CASE("what another program takes is none of a loop's time", "[base]") {
    const Threads threads(1);
    benchmark::LoopMeter meter(&HandClock::now, &HandClock::busy);
    parallel::for_each(
        4, [&](std::size_t i) { i == 1 ? HandClock::wait(50) : HandClock::pass(10); }, 1);
    CHECK(meter.seconds() == Approx(0.030));
    CHECK(meter.wall(1) == Approx(0.020));
}
