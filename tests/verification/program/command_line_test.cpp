// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: nothing that the command line or the deck says crashes the program or makes it hang: bad
// input ends with status 2 and its place, broken physics with 3.

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "io/results/hdf5.hpp"
#include "io/system/folder_lock.hpp"
#include "tests/places.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using Catch::Contains;
using test::shell;

namespace {

/// Of a run, into the folder DECK.out; 137 where it took more than a minute.
std::pair<int, std::string> run(const std::filesystem::path& deck, const std::string& options) {
    return shell("timeout -s KILL 60 " CORPUSCLE_PROGRAM " run '" + deck.string() + "' -q -o '" +
                 deck.string() + ".out' " + options + " 2>&1");
}

std::pair<int, std::string> program(const std::string& words) {
    return shell("timeout -s KILL 60 " CORPUSCLE_PROGRAM " " + words + " 2>&1");
}

/// A tetrahedron of edge 0.1 full of air particles, free to fly; of 3 shells it is open.
std::string balloon(const std::string& material, const std::string& end_time,
                    const std::string& more = "", int shells = 4) {
    std::string deck =
        "*KEYWORD\n*NODE\n1,0,0,0\n2,0.1,0,0\n3,0,0.1,0\n4,0,0,0.1\n*ELEMENT_SHELL\n";
    const char* const FACETS[] = {"1,1,1,2,3\n", "2,1,1,4,2\n", "3,1,1,3,4\n", "4,1,2,4,3\n"};
    for (int s = 0; s < shells; ++s) deck += FACETS[s];
    return deck + "*PART\nballoon\n1,1,1\n*SECTION_SHELL\n1,5\n1e-3,1e-3,1e-3,1e-3\n" + material +
           "*AIRBAG_PARTICLE\n1,0\n200,1,1\n2,0,0\n1e5,300.,0.029,29.1\n"
           "*CONTROL_TERMINATION\n" +
           end_time + "\n" + more + "*END\n";
}

const std::string CLOTH = "*MAT_ELASTIC\n1,800.,3e8,0.3\n";

}  // namespace

TEST_CASE("an interval of output far below the step is met in every step", "[io]") {
    const test::DeckFolder folder;
    const auto [status, text] =
        run(folder.write("deck.k", balloon(CLOTH, "1e-4", "*DATABASE_ABSTAT\n1e-30\n")), "");
    CAPTURE(text);
    CHECK(status == 0);
}

TEST_CASE("a scene whose steps never reach the end time stops, and says who sets them", "[io]") {
    const test::DeckFolder folder;
    const auto [status, text] = run(folder.write("deck.k", balloon(CLOTH, "1e30")), "");
    CHECK(status == 3);
    CHECK_THAT(text, Contains("the physics broke at time") && Contains("set by"));
}

TEST_CASE("a bag that next to nothing holds back stops before its gas is lost", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon("*MAT_RIGID\n1,1e-30,1e9,.3\n\n\n", "1e-4"));
    const auto [status, text] = run(deck, "");
    CHECK(status == 3);
    CHECK_THAT(text, Contains("rigid part 1 spins at") && Contains("which no step of"));
}

TEST_CASE("a run that breaks in its first step shows the start once", "[io]") {
    const test::DeckFolder folder;
    const auto deck =
        folder.write("deck.k", balloon(CLOTH, "1e-4", "*INITIAL_VELOCITY_NODE\n1,1e9,0,0\n"));
    const auto [status, text] = run(deck, "");
    CHECK(status == 3);
    CHECK_THAT(text, Contains("the physics broke at time 0:") && Contains("times the bag's size"));
    const io::Hdf5Reader results(deck.string() + ".out/results.h5");
    CHECK(results.read<double>("/frames/time") == std::vector<double>{0.0});
}

TEST_CASE("a bag that is not closed gets the line of its card", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4", "", 3));
    const auto [status, text] = run(deck, "");
    CHECK(status == 2);
    CHECK_THAT(text, Contains("deck.k:19: *AIRBAG_PARTICLE 1: is not closed: a hole of 3 edges"));
}

TEST_CASE("initial air whose Cv is not above 0 is refused, as a gas and as particles", "[io]") {
    const test::DeckFolder folder;
    for (const char* kind : {"1", "-1", "2"}) {
        CAPTURE(kind);
        std::string text = balloon(CLOTH, "1e-4");
        text.replace(text.find("\n2,0,0\n1e5"), 7, std::string("\n") + kind + ",0,0\n");
        text.replace(text.find("29.1"), 4, "8.0");
        const auto [status, told] = run(folder.write("deck.k", text), "");
        CHECK(status == 2);
        CHECK_THAT(told, Contains("deck.k:20: *AIRBAG_PARTICLE: initial air of bag 1: Cv ="));
    }
}

TEST_CASE("BLOCK by contact pressure needs no contact card", "[io]") {
    const test::DeckFolder folder;
    const std::string porous = "*MAT_FABRIC\n1,800.,3e8,3e8,,0.3,0.3\n1e8\n,0.5,20.,0,,,8\n\n\n";
    std::string text = balloon(porous, "1e-4");
    text.replace(text.find("*AIRBAG_PARTICLE\n1,0\n"), 21, "*AIRBAG_PARTICLE\n1,0,0,0,21\n");
    CHECK(run(folder.write("deck.k", text), "").first == 0);
}

TEST_CASE("a run without *DATABASE_BINARY_D3PLOT shows its start and its end", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4"));
    REQUIRE(run(deck, "").first == 0);
    const io::Hdf5Reader results(deck.string() + ".out/results.h5");
    CHECK(results.read<double>("/frames/time") == std::vector<double>{0.0, 1e-4});
}

TEST_CASE("run.json is JSON, and everything in it is where its name says", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write(
        "deck.k", balloon(CLOTH, "1e-4",
                          "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,5\n0.2,0.2,0,0,20,0,0,1e20\n"
                          "1,1,1e-3,1e-3\n"));
    const auto [status, text] = run(deck, "-j 2");
    CAPTURE(text);
    REQUIRE(status == 0);
    const std::string look =
        "node -e \"const r = JSON.parse(require('fs').readFileSync(process.argv[1]));"
        "process.exit(Array.isArray(r.warnings) && r.mended.length === 0 && r.threads === 2"
        " && r.steps > 0 && r.wall >= r.parallel && r.contact.pairs_stopped === 0"
        " && r.phases['cloth: strains and stresses'] >= 0 ? 0 : 1)\" '" +
        deck.string() + ".out/run.json'";
    CHECK(std::system(look.c_str()) == 0);
}

TEST_CASE("more particles than memory holds are refused before it is taken", "[io]") {
    const test::DeckFolder folder;
    std::string bags;
    for (int id = 2; id < 1000; ++id)
        bags += "*AIRBAG_PARTICLE_ID\n" + std::to_string(id) +
                "\n1,0\n100000000,1,1\n2,0,0\n1e5,300.,0.029,29.1\n";
    const auto [status, text] = run(folder.write("deck.k", balloon(CLOTH, "1e-4", bags)), "");
    CHECK(status == 2);
    CHECK_THAT(text, Contains("*AIRBAG_PARTICLE_ID: bag") && Contains("NP = 100000000"));
}

TEST_CASE("seeds below 0 and threads beyond counting are refused", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4"));
    for (const char* options : {"--seed -3", "--seed 1.5", "-j 0", "-j 100000", "--until -1",
                                "--seed 99999999999999999999", "--seed 18446744073709551616",
                                "--seed 0x10", "--seed 3e3"}) {
        CAPTURE(options);
        CHECK(run(deck, options).first == 2);
    }
    CHECK(run(deck, "--seed 3 -j 2").first == 0);
    CHECK(run(deck, "--seed 18446744073709551615").first == 0);
}

TEST_CASE("what standard output does not take makes a status of its own", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4")).string();
    for (const std::string& words :
         {std::string("--help"), std::string("--version"), "check '" + deck + "'",
          "run '" + deck + "' -o '" + deck + "x'"}) {
        CAPTURE(words);
        const auto [status, text] = shell(CORPUSCLE_PROGRAM " " + words + " 2>&1 >/dev/full");
        CHECK(status == 1);
        CHECK_THAT(text, Contains("No space left on device"));
    }
}

TEST_CASE("a folder in use is left alone", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4"));
    const std::filesystem::path out = deck.string() + ".out";
    {
        const io::FolderLock other(out);
        for (const char* options : {"", "--restart"}) {
            const auto [status, text] = run(deck, options);
            CHECK(status == 2);
            CHECK_THAT(text, Contains("deck.k.out is in use by another run (process " +
                                      std::to_string(getpid()) + ")"));
        }
        CHECK_FALSE(std::filesystem::exists(out / "results.h5"));
    }
    CHECK(run(deck, "").first == 0);
}

TEST_CASE("a study's folder in use is left alone, and so are its runs", "[io][study]") {
    const test::DeckFolder folder;
    folder.write("deck.k", balloon(CLOTH, "&end", "*PARAMETER\nR end, 1e-6\n"));
    const auto study =
        folder.write("s.toml",
                     "deck = \"deck.k\"\nresponses = [\"end:/history/airbag/1/mass\"]\n"
                     "[factors]\nEND = [1e-6, 2e-6]\n");
    const std::string words = "study '" + study.string() + "' -o '" + study.string() + ".out'";
    {
        const io::FolderLock lock(study.string() + ".out");
        for (const char* share : {"", " --share 0/2"}) {
            const auto [status, text] = program(words + share);
            CAPTURE(text);
            CHECK(status == 2);
            CHECK_THAT(text, Contains("is in use by another run (process "));
        }
        CHECK_FALSE(std::filesystem::exists(study.string() + ".out/study.csv"));
    }
    CHECK(program(words + " --share 0/2").first == 0);
    const auto [status, text] = program(words);
    CAPTURE(text);
    CHECK(status == 0);
}

TEST_CASE("a file that may not grow any more is an error with results so far", "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write(
        "deck.k",
        balloon(CLOTH, "1e-4", "*DATABASE_BINARY_D3PLOT\n2e-6\n*DATABASE_ABSTAT\n1e-7\n"));
    const auto [status, text] =
        shell("ulimit -f 400; timeout -s KILL 60 " CORPUSCLE_PROGRAM " run '" + deck.string() +
              "' -q -o '" + deck.string() + ".out' 2>&1");
    CAPTURE(text);
    CHECK(status == 1);
    CHECK_THAT(text, Contains("File too large") && Contains("results so far"));
    const io::Hdf5Reader results(deck.string() + ".out/results.h5");
    CHECK_FALSE(results.read<double>("/history/time").empty());
    CHECK_FALSE(results.read<double>("/frames/time").empty());
}

TEST_CASE("a kill between the end of the results and that of the run leaves nothing stale",
          "[io]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4"));
    const std::filesystem::path out = deck.string() + ".out";
    REQUIRE(run(deck, "").first == 0);
    CHECK(std::filesystem::exists(out / "run.json"));
    std::ofstream(out / "checkpoint") << "of the run before it ended";
    std::filesystem::create_directories(out / "results.parts");
    const auto [status, text] = run(deck, "--restart");
    CHECK(status == 0);
    CHECK_THAT(text, Contains("nothing is left to do"));
    CHECK_FALSE(std::filesystem::exists(out / "checkpoint"));
    CHECK_FALSE(std::filesystem::exists(out / "results.parts"));
    SECTION("of another scene there is something to do") {
        const auto [other, told] = run(deck, "--restart --seed 2");
        CHECK(other == 2);
        CHECK_THAT(told, Contains("is of another scene"));
    }
    SECTION("nor is a wall more the same scene") {
        folder.write("deck.k", balloon(CLOTH, "1e-4", "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1\n"));
        const auto [other, told] = run(deck, "--restart");
        CHECK(other == 2);
        CHECK_THAT(told, Contains("is of another scene"));
    }
    SECTION("as there is after the end") {
        const auto [longer, told] = run(deck, "--restart --until 2e-4");
        CHECK(longer == 2);
        CHECK_THAT(told, Contains("came to its end at 0.0001"));
    }
}

TEST_CASE("motion at the start counts as brought in", "[io]") {
    const test::DeckFolder folder;
    std::string text = balloon(CLOTH, "1e-5", "*INITIAL_VELOCITY\n\n1.,2.,3.\n");
    const std::size_t bag = text.find("*AIRBAG"), end = text.find("*CONTROL");
    const auto deck = folder.write("deck.k", text.erase(bag, end - bag)).string();
    const auto [status, told] =
        shell(CORPUSCLE_PROGRAM " run '" + deck + "' -o '" + deck + "x' 2>&1");
    CAPTURE(told);
    REQUIRE(status == 0);
    const std::size_t at = told.rfind('(', told.find("of what was brought in"));
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(told.substr(at + 1)) < 1.0);
}

TEST_CASE("an export that a run has nothing for is skipped, old ones are removed", "[export]") {
    const test::DeckFolder folder;
    const auto deck = folder.write("deck.k", balloon(CLOTH, "1e-4"));
    REQUIRE(run(deck, "").first == 0);
    const std::filesystem::path out = deck.string() + ".out";
    const auto [status, text] = program("export '" + out.string() + "' --iso-mme --csv --d3plot");
    CHECK(status == 0);
    CHECK_THAT(text, Contains("warning: skipped --iso-mme: expected results with a rigid body"));
    for (const char* name : {"history.csv", "d3plot", "d3plot01"})
        CHECK(std::filesystem::exists(out / name));
    const auto [again, said] = run(deck, "");
    CHECK(again == 0);
    CHECK_THAT(said, Contains("of an earlier run, removed: d3plot, d3plot01, d3plot02, "
                              "history.csv, run.json"));
    CHECK_FALSE(std::filesystem::exists(out / "history.csv"));
    CHECK_FALSE(std::filesystem::exists(out / "d3plot01"));
}
