// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/archive.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>

using namespace corpuscle;

TEST_CASE("a span of bytes is archived with what it shows", "[base][archive]") {
    std::array<double, 3> told{1.5, -2.0, 3e300}, read{};
    std::uint32_t mark = 77, mark_read = 0;
    StateWriter writer;
    std::span<std::byte> from = std::as_writable_bytes(std::span(told));
    writer(from, mark);
    const std::array<double, 3> before = told;
    told.fill(0.0);  // the bytes are those of then
    StateReader reader(writer.bytes());
    std::span<std::byte> to = std::as_writable_bytes(std::span(read));
    reader(to, mark_read);
    CHECK(read == before);
    CHECK(mark_read == mark);
    CHECK(reader.is_at_end());
    CHECK(to.data() == reinterpret_cast<std::byte*>(read.data()));
}

TEST_CASE("a span of another length than that which was written is refused", "[base][archive]") {
    std::array<double, 3> told{};
    std::array<double, 2> read{};
    StateWriter writer;
    std::span<std::byte> from = std::as_writable_bytes(std::span(told));
    writer(from);
    StateReader reader(writer.bytes());
    std::span<std::byte> to = std::as_writable_bytes(std::span(read));
    CHECK_THROWS_AS(reader(to), SystemError);
}
