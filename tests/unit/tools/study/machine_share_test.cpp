// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/machine_share.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>

using namespace corpuscle;

TEST_CASE("a study's runs share a machine's cores", "[study]") {
    constexpr study::Machine MACHINE{16, 32};
    const auto shared = [&](std::size_t runs, int workers = 0, int threads = 0) {
        study::Study one;
        one.says_workers = workers > 0;
        one.says_threads = threads > 0;
        one.workers = std::max(1, workers);
        one.threads = std::max(1, threads);
        study::share_machine(one, runs, MACHINE);
        return std::pair(one.workers, one.threads);
    };
    CHECK(shared(1000) == std::pair(32, 1));
    CHECK(shared(20) == std::pair(20, 1));
    CHECK(shared(16) == std::pair(16, 1));
    CHECK(shared(8) == std::pair(8, 2));
    CHECK(shared(5) == std::pair(5, 3));
    CHECK(shared(1) == std::pair(1, 16));
    CHECK(shared(0) == std::pair(1, 16));
    CHECK(shared(1000, 0, 4) == std::pair(4, 4));  // what is said holds
    CHECK(shared(1000, 4) == std::pair(4, 4));
    CHECK(shared(2, 4) == std::pair(4, 8));
    CHECK(shared(1000, 40, 3) == std::pair(40, 3));
    CHECK(shared(1, 0, 64) == std::pair(1, 64));
}
