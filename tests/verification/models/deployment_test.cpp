// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a bag that `corpuscle fold` has folded by any recipe deploys: no crossing in any frame, no
// particle lost, nothing that is no number, and books that close.
//
// An hour of computing in all, so hidden, and in slices if wanted:
//   RECIPES=1-5 verify_deployment "[.long]"      (default 1-24)
//   RESULTS=run.out/results.h5 verify_deployment "[.frames]"    counts crossings of any run

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "io/results/hdf5.hpp"
#include "solver/base/error.hpp"
#include "tests/places.hpp"
#include "tests/support/random/random_recipe.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"
#include "tools/verify/frame_crossings.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The inflated volume: of two discs [Paulsen 1994: 1.2185 a^3], of a pillow of two rectangles
/// [Robin 2004, of a paper bag]. Tethers and stretch are not in it.                        [mm^3]
double full_volume(const fold::Pattern& p) {
    if (p.kind == fold::PatternKind::DISC) return 1.2185 * std::pow(0.5 * p.diameter, 3);
    const double w = std::min(p.length, p.width), h = std::max(p.length, p.width);
    return w * w * w * (h / (std::numbers::pi * w) - 0.142 * (1.0 - std::pow(10.0, -h / w)));
}

/// The inflator's eight orifices, half as far from the axis as the model's: of a dish of 60 mm
/// meshes as coarse as these leave four nodes at the bottom. [mm]
std::string orifices() {
    std::string nodes = "*NODE\n";
    for (int k = 0; k < 8; ++k) {
        const double angle = (k + 0.5) * std::numbers::pi / 4.0;
        nodes += fmt::format("{}, {:.6f}, {:.6f}, -11.0\n", 200001 + k, 7.5 * std::cos(angle),
                             7.5 * std::sin(angle));
    }
    return nodes;
}

/// The deck round a folded mesh: cards of models/driver_bag_folded, without its housing, and its
/// inflator for a quarter more volume; vents let out 0.3 of their area, for they are as large as
/// the coarse mesh wants them. DT2MS: folds in any direction leave slivers, which would hold the
/// step at a tenth.
std::string deck_for(const fold::Bag& bag, const fold::Recipe& recipe, double volume) {
    const std::string model = text_of(CORPUSCLE_MODELS "/driver_bag_folded/module.k");
    const auto between = [&](const std::string& from, const std::string& to) {
        const auto a = model.find(from);
        REQUIRE(a != std::string::npos);
        const auto b = model.find(to, a);
        REQUIRE(b != std::string::npos);
        return model.substr(a, b - a);
    };
    std::string deck =
        "*KEYWORD\n*TITLE\nrandom recipe\n*PARAMETER\nI NP, 10000\nR ENDTIM, 20.0\n"
        "R DTPLOT, 0.5\n*INCLUDE\nmesh.k\n*CONTROL_TERMINATION\n&ENDTIM\n";
    deck += fmt::format("*PARAMETER\nR FLOW, {:.4f}\nR FIRE, 0.0\n", 1.25 * volume / 56.85e6);
    deck +=
        "*CONTROL_TIMESTEP\n0.0, 0.7, 0, 0.0, "
        "-0.003\n*DATABASE_ABSTAT\n0.1\n*DATABASE_GLSTAT\n0.1\n"
        "*DATABASE_BINARY_D3PLOT\n&DTPLOT\n";
    std::string closing;
    bool has_tether = false;
    std::vector<char> is_there(bag.parts.size(), 0);
    for (const int row : bag.sheet.part) is_there[static_cast<std::size_t>(row)] = 1;
    for (std::size_t p = 0; p < bag.parts.size(); ++p) {
        if (!is_there[p]) continue;
        const int id = bag.parts[p].id;
        const bool is_double = id == recipe.parts.reinforcement || id == recipe.parts.tether;
        deck += fmt::format("*PART\n{}\n{}, {}, 1\n", bag.parts[p].title, id, is_double ? 2 : 1);
        if (id == recipe.parts.tether)
            has_tether = true;
        else
            closing += fmt::format("{}{}", closing.empty() ? "" : ", ", id);
    }
    deck += between("*SECTION_SHELL_TITLE\nmembrane", "$ ---");
    deck += fmt::format(
        "*AIRBAG_PARTICLE_ID\n1, bag\n3, 1, {}, 0\n&NP, 0, 1, 293.0, 1.01325E-4, {}\n"
        "1, 1, 8\n",
        has_tether ? recipe.parts.tether : 0, recipe.vents.empty() ? 0 : 1);
    if (!recipe.vents.empty()) deck += fmt::format("{}, 0, 0.3, 0, 0, 1\n", recipe.parts.vent);
    deck += between("1.01325E-4     293.0   0.02897", "*SET_PART_LIST_TITLE");
    deck += "*SET_PART_LIST\n3\n" + closing + "\n";
    deck += between("*DEFINE_CURVE_TITLE\nmass flow", "$\n$ ---");
    deck += between("*RIGIDWALL_PLANAR_ID", "*NODE");
    return deck + orifices() + "*END\n";
}

struct Outcome {
    int status = -1;
    std::size_t shells = 0;
    double pressure = NaN;  ///< over the atmosphere's, at the end                          [kPa]
    double full = 0.0;      ///< most volume over full_volume()
    std::size_t frames = 0, crossings = 0;
    int lost = -1;          ///< particles; -1: the log does not say
    double residual = NaN;  ///< at worst, over what was brought in
    bool is_finite = false;
    double seconds = NaN;  ///< processor time
    std::string end;       ///< last words, if it failed
};

Outcome deploy(const std::string& recipe_text, const fs::path& folder) {
    Outcome outcome;
    const fold::Recipe recipe = fold::parse_recipe(recipe_text, "random.toml");
    const fold::Bag bag = fold::fold(recipe);
    const fold::Inspection found = fold::inspect(bag, recipe.pattern.gap);
    if (!found.crossings.empty()) throw InputError(std::string("crosses when folded"));
    outcome.shells = bag.sheet.cells.size();
    const double volume = full_volume(recipe.pattern);
    std::ofstream(folder / "recipe.toml") << recipe_text;
    std::ofstream(folder / "mesh.k") << fold::bag_deck(bag, recipe, found);
    std::ofstream(folder / "bag.k") << deck_for(bag, recipe, volume);

    const std::string command = fmt::format(
        "cd '{}' && bash -c 'TIMEFORMAT=%U; time {} run -j 1 bag.k -o out >log 2>&1' 2>seconds",
        folder.string(), CORPUSCLE_PROGRAM);
    const int ended = std::system(command.c_str());
    outcome.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    outcome.seconds = std::strtod(text_of(folder / "seconds").c_str(), nullptr);
    const std::string log = text_of(folder / "log");
    if (const auto at = log.find("lost particles: "); at != std::string::npos)
        outcome.lost = std::atoi(log.c_str() + at + 16);
    if (outcome.status != 0) outcome.end = log.substr(log.size() < 400 ? 0 : log.size() - 400);
    if (!fs::exists(folder / "out/results.h5")) return outcome;

    const io::Hdf5Reader file(folder / "out/results.h5");
    outcome.is_finite = true;
    const auto series = [&](const std::string& path) {
        const auto all = file.read<double>(path);
        for (const double value : all) outcome.is_finite &= std::isfinite(value);
        return all;
    };
    const auto volumes = series("/history/airbag/1/volume");
    outcome.full = *std::max_element(volumes.begin(), volumes.end()) / volume;
    outcome.pressure = 1e6 * (series("/history/airbag/1/pressure").back() - 1.01325e-4);
    double worst = 0.0;
    for (const double r : series("/history/energy/residual")) worst = std::max(worst, std::abs(r));
    outcome.residual = worst / series("/history/energy/inflow").back();
    const verify::FrameCrossings crossed = verify::frame_crossings(folder / "out/results.h5");
    outcome.frames = crossed.frames;
    outcome.crossings = crossed.crossings;
    return outcome;
}

}  // namespace

TEST_CASE("bags of random recipes deploy", "[.long]") {
    int first = 1, last = 24;
    if (const char* slice = std::getenv("RECIPES"))
        REQUIRE(std::sscanf(slice, "%d-%d", &first, &last) == 2);
    const char* kept = std::getenv("KEEP");  // folder for decks and results
    for (int seed = first; seed <= last; ++seed) {
        const std::string text = support::random_airbag_recipe(static_cast<unsigned>(seed));
        INFO("recipe " << seed << "\n" << text);
        const fs::path folder =
            kept ? fs::path(kept) / fmt::format("recipe_{}", seed)
                 : fs::temp_directory_path() / fmt::format("deployment.{}.{}", getpid(), seed);
        fs::create_directories(folder);
        try {
            const Outcome o = deploy(text, folder);
            fmt::print(
                "recipe {}: status {}, {} shells, volume {:.0f} %, {:.1f} kPa, {} crossings in {} "
                "frames, "
                "{} lost, residual {:.4f} %, {:.0f} s{}{}\n",
                seed, o.status, o.shells, 100.0 * o.full, o.pressure, o.crossings, o.frames, o.lost,
                100.0 * o.residual, o.seconds, o.end.empty() ? "" : ": ", o.end);
            CHECK(o.status == 0);
            CHECK(o.is_finite);
            CHECK(o.full > 0.7);  // tethers, creases and vents take some
            CHECK(o.frames >= 41);
            CHECK(o.crossings == 0);
            CHECK(o.lost == 0);
            CHECK(o.residual < 0.01);
        } catch (const InputError& refused) {
            fmt::print("recipe {}: not folded: {}\n", seed, refused.what());
        }
        std::fflush(stdout);
        if (!kept) fs::remove_all(folder);
    }
}

TEST_CASE("frames of a run do not cross", "[.frames]") {
    const char* results = std::getenv("RESULTS");
    REQUIRE(results != nullptr);
    const verify::FrameCrossings found = verify::frame_crossings(results);
    fmt::print("{}: {} crossings in {} frames, {} in one at most\n", results, found.crossings,
               found.frames, found.worst);
    CHECK(found.crossings == 0);
}
