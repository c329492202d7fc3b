// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/unit/io/results_scene.hpp"

/// Pages of small runs, and what a browser says of them.
namespace corpuscle::test {

/// What a command prints.
inline std::string printed_by(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        text.append(part.data(), n);
    ::pclose(pipe);
    return text;
}

/// name=...; of what the visitor saw.
inline std::string seen(const std::string& dom, const std::string& name) {
    const std::size_t list = dom.find("<pre id=\"seen\">");
    REQUIRE(list != std::string::npos);
    const std::size_t at = dom.find(name + "=", list);
    INFO(dom.substr(list, 600));
    REQUIRE(at != std::string::npos);
    return dom.substr(at + name.size() + 1, dom.find(';', at) - at - name.size() - 1);
}

/// Four frames of a small scene that grows, by so much a frame; the first bag's pressure in each.
inline std::vector<double> write_results(const std::filesystem::path& folder, double growth = 0.2) {
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder, scene::info(), layout);
    std::vector<double> pressure;
    for (std::size_t k = 0; k < 4; ++k) {
        Sample sample = scene::sample(layout, k);
        sample.time = 1.5 * static_cast<double>(k);  // as the frames
        pressure.push_back(sample.airbags[0].pressure);
        results.append(sample);
        Frame frame = scene::frame(layout, k, 5);
        for (std::size_t n = 0; n < frame.coordinates.size(); ++n)
            frame.coordinates[n] = (1.0 + growth * static_cast<double>(k)) * layout.coordinates[n];
        for (Vec3& x : frame.particles->position) x = 0.01 * x / x.norm();
        results.write(frame);
    }
    results.finish("normal");
    return pressure;
}

}  // namespace corpuscle::test
