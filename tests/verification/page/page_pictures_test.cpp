// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: report --png draws a run's frames without a window. Without Chromium this says that it was
// skipped.

#include <zlib.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

using namespace corpuscle;

namespace {

/// Width and height of a PNG, and how much of its packed lines is not 0: filtered, an even area is.
struct Png {
    std::uint32_t width = 0, height = 0;
    double ink = 0.0;

    explicit Png(const std::string& bytes) {
        REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < 4; ++k)
                value = value << 8U | static_cast<unsigned char>(bytes.at(at + k));
            return value;
        };
        width = number(16);
        height = number(20);
        std::string packed;
        for (std::size_t at = 8; at + 12 <= bytes.size(); at += 12 + number(at))
            if (bytes.substr(at + 4, 4) == "IDAT") packed += bytes.substr(at + 8, number(at));
        std::string lines(static_cast<std::size_t>(height) * (1 + 4 * width), '\0');
        uLongf size = lines.size();
        REQUIRE(uncompress(reinterpret_cast<Bytef*>(lines.data()), &size,
                           reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
        lines.resize(size);
        ink = static_cast<double>(
                  std::count_if(lines.begin(), lines.end(), [](char c) { return c != 0; })) /
              static_cast<double>(size);
    }
};

}  // namespace

TEST_CASE("pictures of a run are drawn without a window and are not blank", "[report]") {
    if (report::browser().empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("pictures");
    test::write_results(folder.path);
    const std::vector<report::PictureFile> all = report::pictures(report::page({folder.path}));
    constexpr double BLANK = 0.004;  // twice what the first line of an even area leaves
    REQUIRE(all.size() == 5);        // four frames and the strip
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(all[k].name == "picture_0" + std::to_string(k) + ".png");
        const Png png(all[k].bytes);
        CHECK((png.width == 640 && png.height == 480));
        CHECK(png.ink > BLANK);
        const bool moved = k == 0 || all[k].bytes != all[k - 1].bytes;
        CHECK(moved);
    }
    CHECK(all[4].name == "strip.png");
    const Png strip(all[4].bytes);
    CHECK((strip.width == 4 * 640 && strip.height == 480));
    CHECK(strip.ink > BLANK);
}
