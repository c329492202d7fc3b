// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/parallel.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>
#include <vector>

#include "solver/base/cores.hpp"
#include "solver/base/tasks.hpp"
#include "tests/unit/solver/base/some_threads.hpp"

using namespace corpuscle;
using support::Threads;

namespace {

class Counter final : public parallel::LoopObserver {
public:
    void begin(const parallel::CallSite& /*where*/) override { ++begun; }
    void end() override { ++ended; }
    void end_chunk() override {}
    int begun = 0, ended = 0;
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

TEST_CASE("sorted items are those of std::sort, on any number of threads", "[base]") {
    for (const int n : {1, 2, 5})
        for (const std::size_t count : {0U, 1U, 127U, 128U, 129U, 257U, 1000U, 5000U}) {
            const Threads threads(n);
            std::vector<std::size_t> items, spare;
            for (std::size_t i = 0; i < count; ++i) items.push_back(i * 7919 % 10007);
            std::vector<std::size_t> expected = items;
            std::sort(expected.begin(), expected.end(), std::greater<>());
            parallel::sort(std::span(items), spare, std::greater<>());
            CHECK(items == expected);
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
        parallel::TaskShares shares;
        shares.deal(
            COUNT + 1,
            [](std::size_t place) {  // back to front, with a hole
                return place == 7 ? parallel::TaskShares::NONE
                                  : COUNT - 1 - (place > 7 ? place - 1 : place);
            },
            [](std::size_t task) { return task < 10 ? 100.0 : 1.0; });
        REQUIRE(shares.tasks() == COUNT);
        REQUIRE(shares.members() == n);
        for (const bool is_worth_it : {true, false}) {
            // Of a binary tree from its root: each adds to what its parent has found
            std::vector<std::size_t> depth(COUNT, 0), count(COUNT, 0);
            tasks.run(
                shares,
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
        {}, [](std::size_t, auto&&) {}, [](std::size_t) { FAIL(); }, true, parallel::Cut().where);
}

TEST_CASE("threads begin with tasks side by side, of like weight", "[base]") {
    const Threads threads(4);
    parallel::TaskShares shares;
    const std::vector<double> weight{1, 1, 1, 1, 4, 2, 2, 4};  // by task: runs of 4
    shares.deal(
        weight.size(), [](std::size_t place) { return 7 - place; },
        [&](std::size_t task) { return weight[task]; });
    const std::vector<std::vector<std::uint32_t>> expected{{7}, {5, 6}, {4}, {0, 1, 2, 3}};
    for (int m = 0; m < 4; ++m)
        CHECK(std::vector<std::uint32_t>(shares.of(m).begin(), shares.of(m).end()) == expected[m]);
}

TEST_CASE("chunks are done once each, whoever is late", "[base]") {
    for (const int n : {2, 3, 7}) {
        const Threads threads(n);
        for (int again = 0; again < 300; ++again) {
            std::vector<std::atomic<int>> done(101);
            parallel::for_each(
                done.size(),
                [&](std::size_t i) {
                    if (i == 3) std::this_thread::yield();
                    ++done[i];
                },
                1);
            for (const auto& count : done) REQUIRE(count == 1);
        }
    }
}

TEST_CASE("a forked process has threads of its own", "[base]") {
    const Threads threads(2);
    std::vector<int> value(10000, 0);
    parallel::for_each(value.size(), [&](std::size_t i) { value[i] = 1; });
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        alarm(20);
        parallel::for_each(value.size(), [&](std::size_t i) { ++value[i]; });
        _exit(value == std::vector<int>(value.size(), 2) ? 0 : 1);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

TEST_CASE("two threads that call at once both come through", "[base]") {
    const Threads threads(2);
    const auto add = [](std::vector<int>& to) {
        for (int again = 0; again < 200; ++again)
            parallel::for_each(to.size(), [&](std::size_t i) { ++to[i]; });
    };
    std::vector<int> here(10000, 0), there(10000, 0);
    std::thread other([&] { add(there); });
    add(here);
    other.join();
    CHECK(here == std::vector<int>(here.size(), 200));
    CHECK(there == here);
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
