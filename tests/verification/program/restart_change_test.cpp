// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a restart with other outputs goes on with those, and one that is refused leaves the folder
// as it was, so that the run can still go on.

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "io/results/checkpoint.hpp"
#include "io/results/hdf5.hpp"
#include "tests/places.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A tetrahedron of edge 0.1 full of air particles; a checkpoint every 100 steps.
std::string floating_bag(const std::string& outputs) {
    return "*KEYWORD\n*NODE\n1,0,0,0\n2,0.1,0,0\n3,0,0.1,0\n4,0,0,0.1\n*ELEMENT_SHELL\n"
           "1,1,1,2,3\n2,1,1,4,2\n3,1,1,3,4\n4,1,2,4,3\n"
           "*PART\nballoon\n1,1,1\n*SECTION_SHELL\n1,5\n1e-3,1e-3,1e-3,1e-3\n"
           "*MAT_ELASTIC\n1,800.,3e8,0.3\n"
           "*AIRBAG_PARTICLE\n1,0\n200,1,1\n2,0,0\n1e5,300.,0.029,29.1\n"
           "*CONTROL_TERMINATION\n1e3\n*DATABASE_BINARY_D3DUMP\n100\n" +
           outputs + "*END\n";
}

std::string every(const std::string& what, const std::string& interval) {
    return "*DATABASE_" + what + "\n" + interval + "\n";
}

/// A run of this bag that was killed after a checkpoint.
class KilledRun {
public:
    explicit KilledRun(const std::string& outputs) {
        say(outputs);
        const std::string checkpoint = (out_ / "checkpoint").string();
        const auto [status, text] = test::shell(
            CORPUSCLE_PROGRAM " run '" + deck_ + "' -q -o '" + out_.string() +
            "' >/dev/null 2>&1 & i=0; while [ ! -e '" + checkpoint +
            "' ] && [ $i -lt 3000 ]; do sleep 0.02; i=$((i+1)); done; kill -9 $!; wait");
        const auto left = io::read_checkpoint(out_);
        REQUIRE(left.has_value());
        time_ = left->t;
    }
    /// The deck asks for these outputs from now on.
    void say(const std::string& outputs) {
        deck_ = folder_.write("bag.k", floating_bag(outputs)).string();
        out_ = fs::path(deck_).parent_path() / "bag.out";
    }
    [[nodiscard]] std::pair<int, std::string> restart(double until) const {
        std::ostringstream words;
        words.precision(17);
        words << CORPUSCLE_PROGRAM " run '" << deck_ << "' -q --restart -o '" << out_.string()
              << "' --until " << until << " 2>&1";
        return test::shell(words.str());
    }
    /// All files but the lock, by name.
    [[nodiscard]] std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(out_))
            if (entry.is_regular_file() && entry.path().filename() != "lock")
                all[entry.path().string()] = text_of(entry.path());
        return all;
    }
    [[nodiscard]] std::string text(const std::string& name) const { return text_of(out_ / name); }
    [[nodiscard]] std::vector<double> times(const std::string& path) const {
        return io::Hdf5Reader(out_ / "results.h5").read<double>(path);
    }
    [[nodiscard]] fs::path operator/(const std::string& name) const { return out_ / name; }
    [[nodiscard]] double time() const { return time_; }  ///< of the checkpoint

private:
    static std::string text_of(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    test::DeckFolder folder_;
    std::string deck_;
    fs::path out_;
    double time_ = 0.0;
};

constexpr double LONGEST_STEP = 1e-4;  ///< of this bag, and more

/// Each multiple of the interval from `from` on has a time at the first step that reaches it.
void check_multiples(const std::vector<double>& times, double interval, double from, double end) {
    std::vector<double> found;
    for (const double t : times)
        if (t >= from && t < end) found.push_back(t);
    std::vector<double> expected;
    for (double k = std::ceil(from / interval); k * interval < end; ++k)
        expected.push_back(k * interval);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i] >= expected[i] * (1.0 - 1e-9));
        CHECK(found[i] < expected[i] + LONGEST_STEP);
    }
}

/// Times of a text file's states, in its first 12 columns.
std::vector<double> times_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> times;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);)
        if (++number > 2 && line.find("       1 ") == 12)
            times.push_back(std::stod(line.substr(0, 12)));
    return times;
}

}  // namespace

TEST_CASE("a terminal that hangs up ends a run behind a checkpoint, and not one under nohup",
          "[restart]") {
    const bool is_heeded = GENERATE(true, false);
    const test::DeckFolder folder;
    const fs::path here = folder.write("bag.k", floating_bag("")).parent_path();
    const auto [status, text] = test::shell(
        "cd '" + here.string() + "'; " + (is_heeded ? "" : "trap '' HUP; ") +
        CORPUSCLE_PROGRAM
        " run bag.k -q -o out >said 2>&1 & i=0; "
        "while [ ! -e out/checkpoint ] && [ $i -lt 3000 ]; do sleep 0.02; i=$((i+1)); done; "
        "kill -HUP $!; " +
        (is_heeded ? "" : "sleep 0.5; grep '^State' /proc/$!/status; kill -TERM $!; ") + "wait $!");
    CAPTURE(text);
    CHECK(status == 1);
    if (!is_heeded) CHECK_THAT(text, Contains("State") && !Contains("zombie"));
    CHECK(io::read_checkpoint(here / "out").has_value());
}

TEST_CASE("a restart to before its checkpoint is refused, and the run can still go on",
          "[restart]") {
    const KilledRun run(every("GLSTAT", "5e-4"));
    const auto before = run.files();
    const auto [status, text] = run.restart(0.5 * run.time());
    CHECK(status == 2);
    CHECK_THAT(text, Contains("--restart: end time = ") && Contains("or later: the checkpoint in"));
    CHECK(run.files() == before);
    CHECK(run.restart(1.5 * run.time()).first == 0);
    CHECK(run.times("/frames/time").back() == Approx(1.5 * run.time()).epsilon(1e-12));
}

TEST_CASE("a restart with other intervals goes on at their multiples", "[restart]") {
    KilledRun run(every("ABSTAT", "3e-4") + every("BINARY_D3PLOT", "1e-3"));
    const std::string ab = GENERATE("3.7e-4", "1.3e-3", "2e-4"), plot = GENERATE("2.6e-3", "4e-4");
    run.say(every("ABSTAT", ab) + every("BINARY_D3PLOT", plot));
    const double end = run.time() + 0.01;
    const auto [status, text] = run.restart(end);
    CAPTURE(text, run.time());
    REQUIRE(status == 0);
    for (const auto& [path, old, now] : {std::tuple("/history/time", 3e-4, std::stod(ab)),
                                         std::tuple("/frames/time", 1e-3, std::stod(plot))}) {
        CAPTURE(path);
        const std::vector<double> times = run.times(path);
        check_multiples(times, old, 0.0, run.time());
        check_multiples(times, now, run.time(), end);
        CHECK(times.back() == end);
    }
    check_multiples(times_of(run.text("abstat")), std::stod(ab), run.time() + LONGEST_STEP, end);
}

TEST_CASE("a restart with a text file more or less leaves the others as they are", "[restart]") {
    KilledRun run(every("GLSTAT", "4e-4") + every("ABSTAT", "3e-4") + every("RBDOUT", "1e-3"));
    const std::string old_glstat = run.text("glstat");
    run.say(every("ABSTAT", "3e-4") + every("RBDOUT", "1e-3") + every("MATSUM", "5e-4"));
    const double end = run.time() + 0.01;
    const auto [status, text] = run.restart(end);
    CAPTURE(text);
    REQUIRE(status == 0);
    CHECK(run.text("glstat") == old_glstat);
    check_multiples(times_of(run.text("abstat")), 3e-4, 0.0, end);
    std::istringstream matsum(run.text("matsum"));
    std::vector<double> times;
    for (std::string line; std::getline(matsum, line);)
        if (line.starts_with(" time =")) times.push_back(std::stod(line.substr(7)));
    check_multiples(times, 5e-4, run.time(), end);
}

TEST_CASE("a restart that misses rows of a text file touches none", "[restart]") {
    const KilledRun run(every("ABSTAT", "3e-4") + every("GLSTAT", "3e-4"));
    fs::resize_file(run / "abstat", 100);
    const auto before = run.files();
    const auto [status, text] = run.restart(1.0);
    CHECK(status == 1);
    CHECK_THAT(text, Contains("abstat is shorter than at the checkpoint"));
    CHECK(run.files() == before);
}
