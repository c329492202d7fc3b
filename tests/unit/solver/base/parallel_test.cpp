// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/parallel.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <vector>

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
    void begin() override { ++begun; }
    void end() override { ++ended; }
    void end_chunk() override {}
    int begun = 0, ended = 0;
};

/// A clock that stands until it is moved on.
class HandClock {
public:
    using Clock = benchmark::LoopMeter::Clock;
    static Clock::time_point now() { return Clock::time_point(time_); }
    static void pass(int milliseconds) { time_ += std::chrono::milliseconds(milliseconds); }

private:
    inline static Clock::duration time_{};
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
    benchmark::LoopMeter meter(&HandClock::now);
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
}
