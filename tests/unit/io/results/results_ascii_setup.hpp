// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include "io/results/ascii_files.hpp"
#include "io/results/ascii_tables.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

namespace results_ascii_setup {

using namespace corpuscle;

inline std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

inline std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The numbers of a line, cut at fixed widths.
inline std::vector<double> cut(const std::string& line, const std::vector<int>& widths) {
    std::vector<double> values;
    std::size_t at = 0;
    for (const int width : widths) {
        values.push_back(std::stod(line.substr(at, static_cast<std::size_t>(width))));
        at += static_cast<std::size_t>(width);
    }
    CHECK(line.size() == at);
    return values;
}

inline void check_near(const std::vector<double>& values, const std::vector<double>& expected) {
    REQUIRE(values.size() == expected.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        INFO("column " << i);
        CHECK(values[i] == Approx(expected[i]).epsilon(1e-3));  // abstat prints 4 digits
    }
}

}  // namespace results_ascii_setup
