// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "io/text/progress.hpp"

using namespace corpuscle;

namespace {

/// A file that is gone at the end of the scope; text() is what was written.
class Scratch {
public:
    Scratch() : file_(std::tmpfile()) {}
    ~Scratch() { std::fclose(file_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    std::FILE* file() { return file_; }
    std::string text() {
        std::rewind(file_);
        std::string all;
        for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_))
            all += static_cast<char>(c);
        return all;
    }

private:
    std::FILE* file_;
};

void run(io::Progress& progress, int steps) {
    for (int i = 1; i <= steps; ++i)
        progress.step(0.04 * i / steps, 1e-6, "shell 1017", 100000, 0.00123, i);
    progress.finish();
}

}  // namespace

TEST_CASE("away from a terminal progress is a line every 5 %, however many steps", "[io]") {
    const int steps = GENERATE(20, 1000, 100000);
    Scratch out;
    io::Progress progress(0.04, false, out.file());
    run(progress, steps);
    const std::string text = out.text();
    CHECK(std::count(text.begin(), text.end(), '\n') == 20);
    CHECK(text.find("  5 %") == 0);
    CHECK(text.find("100 %  t 0.04") != std::string::npos);
    for (const char* word : {"dt 1e-06 (shell 1017)", "100000 particles", "residual 0.12 %", "ETA"})
        CHECK(text.find(word) != std::string::npos);
}

TEST_CASE("long steps skip lines, never repeat them", "[io]") {
    Scratch out;
    io::Progress progress(1.0, false, out.file());
    for (const double t : {0.01, 0.52, 0.54, 0.551, 1.0}) progress.step(t, 0.1, "gas", 1, 0.0, 1);
    const std::string text = out.text();
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("on a terminal one line renews itself at most five times a second", "[io]") {
    Scratch out;
    io::Progress progress(0.04, false, out.file(), /*is_terminal=*/true);
    run(progress, 100000);  // much faster than 0.2 s a step
    const std::string text = out.text();
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK(text.back() == '\n');
    const auto renewals = std::count(text.begin(), text.end(), '\r');
    CHECK(renewals >= 2);  // the first step and the end
    CHECK(renewals <= 20);
    CHECK(text.rfind("100 %") > text.rfind('\r'));
}

TEST_CASE("quiet means quiet", "[io]") {
    Scratch out;
    io::Progress progress(0.04, true, out.file(), GENERATE(false, true));
    run(progress, 1000);
    CHECK(out.text().empty());
}

TEST_CASE("durations read as people say them", "[io]") {
    CHECK(io::duration_text(0.2) == "0 s");
    CHECK(io::duration_text(42.4) == "42 s");
    CHECK(io::duration_text(59.6) == "1 min 00 s");
    CHECK(io::duration_text(200) == "3 min 20 s");
    CHECK(io::duration_text(7500) == "2 h 05 min");
}
