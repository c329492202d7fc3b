// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/places.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/report/pictures.hpp"

/// Pages of small runs, and what a person with a browser sees of them.
namespace corpuscle::test {

namespace fs = std::filesystem;

/// A page in Chromium, driven by playwright-core with a script of tests/verification/page.
class Visit {
public:
    /// Whether there is all that a visit wants; says that the test is skipped if not.
    [[nodiscard]] static bool is_possible() {
        std::string lacks;
        if (report::browser().empty())
            lacks = "there is no Chromium on the PATH";
        else if (std::system("command -v node > /dev/null 2>&1") != 0)
            lacks = "there is no node on the PATH";
        else if (!fs::exists(fs::path(CORPUSCLE_BROWSER_DRIVER) / "node_modules/playwright-core"))
            lacks = "playwright-core is not in " CORPUSCLE_BROWSER_DRIVER;
        if (!lacks.empty()) WARN("skipped: " << lacks << " (tools/setup brings it)");
        return lacks.empty();
    }

    /// Opens `page` and does what the script does.
    Visit(const std::string& script, const std::string& page, const std::vector<std::string>& words,
          const fs::path& folder) {
        std::ofstream(folder / "page.html", std::ios::binary) << page;
        std::string command =
            fmt::format("CORPUSCLE_BROWSER_DRIVER='{}' node '{}/{}' \"$(command -v {})\" '{}'",
                        CORPUSCLE_BROWSER_DRIVER, CORPUSCLE_PAGE_VISITS, script, report::browser(),
                        (folder / "page.html").string());
        for (const std::string& word : words) command += fmt::format(" '{}'", word);
        std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
        REQUIRE(pipe != nullptr);
        std::string text;
        std::array<char, 4096> part{};
        while (std::fgets(part.data(), part.size(), pipe) != nullptr) {
            const std::string line = part.data();
            text += line;
            if (const std::size_t is = line.find('='); is != std::string::npos)
                seen_[line.substr(0, is)] = line.substr(is + 1, line.size() - is - 2);
        }
        const int status = ::pclose(pipe);
        INFO(text);
        REQUIRE(status == 0);
    }

    /// What the script said under this name.
    [[nodiscard]] std::string operator[](const std::string& name) const {
        INFO(name);
        REQUIRE(seen_.count(name) == 1);
        return seen_.at(name);
    }

private:
    std::map<std::string, std::string> seen_;
};

/// Four frames of a small scene that grows, by so much a frame; the first bag's pressure in each.
inline std::vector<double> write_results(const fs::path& folder, double growth = 0.2) {
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder, scene::info(), layout);
    std::vector<double> pressure;
    for (std::size_t k = 0; k < 4; ++k) {
        Sample sample = scene::sample(layout, k);
        sample.time = 1.5 * static_cast<double>(k);     // as the frames
        sample.airbags[0].pressure += 5000.0 * growth;  // a curve of its own
        pressure.push_back(sample.airbags[0].pressure);
        results.append(sample);
        Frame frame = scene::frame(layout, k, 5);
        for (std::size_t n = 0; n < frame.coordinates.size(); ++n) {
            const Vec3& x = layout.coordinates[n];
            frame.coordinates[n] =
                (1.0 + growth * static_cast<double>(k)) * Vec3(x.x(), x.y(), 0.4 * (x.x() + x.y()));
        }
        for (Vec3& x : frame.particles->position) x = 0.01 * x / x.norm();
        results.write(frame);
    }
    results.finish("normal");
    return pressure;
}

}  // namespace corpuscle::test
