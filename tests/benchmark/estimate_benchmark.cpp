// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// `corpuscle check`'s estimate of steps and time against what `corpuscle run` took, model by model, on
// one thread. Time is the processor's (user time of the run), so a machine that others load too does not
// count. Status 1 where an estimate of time is off by more than a factor of two.
//
// usage: benchmark_estimate [DECK [UNTIL]]   default: all models, long ones by their first part

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places.hpp"

namespace {

namespace fs = std::filesystem;

struct Case {
    std::string deck;  ///< in models/
    double until;      ///< end time, in the deck's unit; 0: the deck's
};

/// Short models whole; of long ones what a minute or less of one core does.
const std::vector<Case> CASES{
    {"driver_bag_flat/driver_bag_flat.k", 12.0},
    {"driver_bag_folded/driver_bag_folded.k", 8.0},
    {"driver_bag_folded/driver_bag_folded_coarse.k", 12.0},
    {"fast_piston/fast_piston.k", 0.0},
    {"helium_air/helium_air.k", 0.0},
    {"notes_bag/notes_bag.k", 6.0},
    {"oop_linear/oop_linear.k", 6.0},
    {"oop_linear/oop_linear_coarse.k", 8.0},
    {"oop_linear/oop_linear_torso.k", 4.0},
    {"oop_static/oop_static.k", 5.0},
    {"oop_static/oop_static_coarse.k", 0.0},
    {"oop_static/oop_static_torso.k", 5.0},
    {"porous_tank/porous_tank.k", 0.0},
    {"tank_test/tank_test.k", 0.0},
    {"two_chambers/two_chambers.k", 0.0},
    {"two_inflators/two_inflators.k", 0.0},
    {"vented_tank/vented_tank.k", 0.0},
    {"verification/box_at_rest/case.k", 0.0},
    {"verification/far_vent/case.k", 0.0},
    {"verification/piston_wave/case.k", 0.0},
    {"verification/slow_piston/case.k", 0.0},
    {"verification/sod/case.k", 0.0},
    {"verification/string/case_32.k", 0.0},
    {"verification/vacuum/case.k", 0.0},
    {"verification/vent_by_chamber/case.k", 0.0},
};

std::string said(const std::string& command) {
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    std::string text;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    return pclose(pipe) == 0 ? text : std::string();
}

/// Of all children that have ended.                                                             [s]
double user_seconds() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return static_cast<double>(used.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

/// The number that the first group of the pattern finds.
double number(const std::string& text, const std::string& pattern) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(pattern)) ? std::stod(found[1]) : NAN;
}

/// Whether the estimate of time is within a factor of two.
bool compare(const fs::path& deck, double until) {
    const std::string options =
        "'" + deck.string() + "' -j 1" + (until > 0.0 ? fmt::format(" --until {:g}", until) : "");
    const std::string program = CORPUSCLE_PROGRAM;
    const std::string checked = said(program + " check " + options + " 2>/dev/null");
    const fs::path out = fs::temp_directory_path() / fmt::format("estimate.{}", getpid());
    const double before = user_seconds();
    said(program + " run " + options + " -q -o '" + out.string() + "' 2>&1");
    const double took = user_seconds() - before;
    std::ostringstream run;
    run << std::ifstream(out / "run.json").rdbuf();
    fs::remove_all(out);
    const double steps = number(checked, R"(, ([0-9.e+]+) steps)"),
                 seconds = number(checked, R"(some ([0-9.e+]+) s)"),
                 stepped = number(run.str(), R"re("steps": ([0-9.e+]+))re");
    const double share = seconds / took;
    const bool is_near = share > 0.5 && share < 2.0;
    fmt::print("{:46} {:8g} {:9.3g} {:9.3g} {:6.2f} {:8.3g} {:8.3g} {:6.2f}{}\n",
               fs::relative(deck, CORPUSCLE_MODELS).string(), until, steps, stepped,
               steps / stepped, seconds, took, share,
               is_near ? "" : "  <-- more than a factor of two");
    std::fflush(stdout);
    return is_near;
}

}  // namespace

int main(int count, char** words) {
    fmt::print("{:46} {:>8} {:>9} {:>9} {:>6} {:>8} {:>8} {:>6}\n", "", "until", "steps", "made",
               "share", "s", "taken", "share");
    bool are_near = true;
    if (count > 1)
        return compare(fs::absolute(words[1]), count > 2 ? std::stod(words[2]) : 0.0) ? 0 : 1;
    for (const Case& one : CASES)
        are_near = compare(fs::path(CORPUSCLE_MODELS) / one.deck, one.until) && are_near;
    return are_near ? 0 : 1;
}
