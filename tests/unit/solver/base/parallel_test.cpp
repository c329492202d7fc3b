// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/parallel.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include "solver/base/cores.hpp"
#include "solver/base/tasks.hpp"
#include "tests/benchmark/loop_meter.hpp"

using namespace corpuscle;

namespace {

/// Threads as a test wants them, then as they were.
class Threads {
public:
    explicit Threads(int n) { parallel::set_threads(n); }
    ~Threads() { parallel::set_threads(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_ = parallel::threads();
};

class Counter final : public parallel::LoopObserver {
public:
    void begin(const parallel::CallSite& /*where*/) override { ++begun; }
    void end() override { ++ended; }
    void end_chunk() override {}
    int begun = 0, ended = 0;
};

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

}  // namespace

TEST_CASE("what a loop finds is in the items' order on any number of threads", "[base]") {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < 10000; ++i)
        if (i % 7 == 3) expected.push_back(i);
    for (const int n : {1, 2, 5}) {
        const Threads threads(n);
        parallel::Gathered<std::size_t> found;
        for (int again = 0; again < 2; ++again) {
            std::vector<std::size_t> all;
            found.find(10000, all, [](std::size_t i, auto&& take) {
                if (i % 7 == 3) take(i);
            });
            CHECK(all == expected);
        }
    }
}

TEST_CASE("loops side by side do all that each of them does", "[base]") {
    for (const int n : {1, 2, 5}) {
        const Threads threads(n);
        std::vector<int> light(10000, 0), heavy(37, 0);
        int once = 0;
        parallel::side_by_side(parallel::alone([&] { ++once; }),
                               parallel::each(
                                   heavy.size(), [&](std::size_t i) { ++heavy[i]; }, 4),
                               parallel::each(light.size(), [&](std::size_t i) { ++light[i]; }));
        CHECK(once == 1);
        CHECK(heavy == std::vector<int>(37, 1));
        CHECK(light == std::vector<int>(10000, 1));
    }
}

TEST_CASE("of loops in turn each finds what the one before has done", "[base]") {
    for (const int n : {1, 2, 5}) {
        const Threads threads(n);
        constexpr std::size_t COUNT = 10000, LOOPS = 6;
        std::vector<std::size_t> value(COUNT, 1), next(COUNT);
        parallel::in_turn(LOOPS, [&](std::size_t loop) {
            const auto& from = loop % 2 == 0 ? value : next;
            auto& to = loop % 2 == 0 ? next : value;
            return parallel::each(COUNT, [&](std::size_t i) {
                to[i] = from[i] + from[COUNT - 1 - i];  // far off: another thread's
            });
        });
        CHECK(value == std::vector<std::size_t>(COUNT, 64));  // 2^LOOPS
    }
}

TEST_CASE("loops of different kinds in turn wait for each other", "[base]") {
    for (const int n : {1, 2, 5}) {
        const Threads threads(n);
        std::vector<std::size_t> value(10000, 0), next(20000, 0);
        std::size_t sum = 0;
        parallel::in_turn(
            parallel::each(value.size(), [&](std::size_t i) { value[i] = i; }),
            parallel::each(
                next.size(), [&](std::size_t i) { next[i] = value[9999 - i / 2]; }, 7),
            parallel::alone([&] {
                for (const std::size_t v : next) sum += v;
            }));
        CHECK(sum == 2 * 49995000);
    }
}

TEST_CASE("tasks begin when those that they wait for are done", "[base]") {
    constexpr std::size_t COUNT = 3000;
    parallel::Tasks tasks;
    for (const int n : {1, 2, 5}) {
        const Threads threads(n);
        for (const bool is_worth_it : {true, false}) {
            // Of a binary tree from its root: each adds to what its parent has found
            std::vector<std::size_t> depth(COUNT, 0), count(COUNT, 0);
            tasks.run(
                COUNT,
                [](std::size_t task, auto&& visit) {
                    if (task > 0) visit((task - 1) / 2);
                },
                [&](std::size_t task) {
                    depth[task] = task == 0 ? 1 : depth[(task - 1) / 2] + 1;
                    ++count[task];
                },
                is_worth_it, parallel::Cut().where);
            CHECK(count == std::vector<std::size_t>(COUNT, 1));
            for (std::size_t task = 0; task < COUNT; ++task) {
                std::size_t levels = 0;
                for (std::size_t k = task + 1; k > 0; k /= 2) ++levels;
                REQUIRE(depth[task] == levels);
            }
        }
    }
    tasks.run(
        0, [](std::size_t, auto&&) {}, [](std::size_t) { FAIL(); }, true, parallel::Cut().where);
}

TEST_CASE("an observer sees loops that threads share, not those within them", "[base]") {
    const Threads threads(2);
    Counter counter;
    parallel::for_each(
        8, [](std::size_t) { parallel::for_each(10000, [](std::size_t) {}); }, 1);
    CHECK(counter.begun == 1);
    parallel::for_each(10, [](std::size_t) {});  // not worth a call
    CHECK(counter.begun == 1);
    parallel::for_each(10000, [](std::size_t) {});
    CHECK(counter.begun == 2);
    CHECK(counter.ended == 2);
}

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
    CHECK(site.first.find("parallel_test.cpp:") != std::string::npos);
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
        time.size(),
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

TEST_CASE("two hardware threads of a core are one core", "[base]") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "corpuscle_cores_test";
    const std::vector<std::string> siblings{"0,4", "1,5", "2-3", "2-3", "0,4", "1,5"};
    for (std::size_t cpu = 0; cpu < siblings.size(); ++cpu) {
        const fs::path of = folder / ("cpu" + std::to_string(cpu)) / "topology";
        fs::create_directories(of);
        std::ofstream(of / "thread_siblings_list") << siblings[cpu] << "\n";
    }
    CHECK(parallel::cores_of({0, 1, 2, 3, 4, 5}, folder) == 3);
    CHECK(parallel::cores_of({0, 4, 3}, folder) == 2);
    CHECK(parallel::cores_of({0, 1, 6, 7}, folder) == 4);  // nothing is known of 6 and 7
    CHECK(parallel::cores() >= 1);
    CHECK(parallel::cores() <= parallel::processors());
    fs::remove_all(folder);
}
