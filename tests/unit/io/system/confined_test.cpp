// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/confined.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>

using namespace corpuscle;
using Catch::Contains;

TEST_CASE("what a confined reader hands over comes back byte by byte", "[io]") {
    const std::size_t size = GENERATE(0U, 1U, 1000000U);  // the last is more than a pipe holds
    std::vector<char> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * i);
    const io::Confined found = io::confined([&] { return bytes; });
    REQUIRE(found.bytes);
    CHECK(*found.bytes == bytes);
    CHECK(found.failure.empty());
}

TEST_CASE("whatever becomes of a confined reader, this process goes on and says it", "[io]") {
    const auto failure = [](const std::function<std::vector<char>()>& reader) {
        const io::Confined found = io::confined(reader, {.seconds = 1, .memory = 1 << 28});
        CHECK_FALSE(found.bytes);
        return found.failure;
    };
    CHECK_THAT(failure([]() -> std::vector<char> { throw std::runtime_error("a bad file"); }),
               Catch::Equals("a bad file"));
    CHECK_THAT(failure([]() -> std::vector<char> {
                   std::raise(SIGSEGV);
                   return {};
               }),
               Contains("its reader crashed") && Contains("fault"));
    const auto begin = std::chrono::steady_clock::now();
    CHECK_THAT(failure([]() -> std::vector<char> {
                   for (volatile unsigned i = 0;;) {
                       const unsigned next = i + 1;
                       i = next;
                   }
               }),
               Contains("took more than 1 s"));
    CHECK_THAT(failure([]() -> std::vector<char> {
                   for (;;) usleep(1000);
               }),
               Contains("took more than 1 s"));
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(60));
}

#ifndef __has_feature
#define __has_feature(what) 0
#endif
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer)
TEST_CASE("a confined reader that asks for too much memory gets none", "[io]") {
    const io::Confined found = io::confined([] { return std::vector<char>(std::size_t{1} << 30); },
                                            {.seconds = 30, .memory = 1 << 28});
    CHECK_FALSE(found.bytes);
    CHECK_THAT(found.failure, Contains("asked for more than 268 MB"));
}
#endif
