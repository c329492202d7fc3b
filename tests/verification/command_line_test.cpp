// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: nothing that the command line or the deck says crashes the program or makes it hang: bad
// input ends with status 2 and its place, broken physics with 3.

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <utility>

#include "io/hdf5.hpp"
#include "tests/unit/io/deck_scene.hpp"

using namespace corpuscle;
using Catch::Contains;

namespace {

/// Exit status and all that was printed; 137 where it took more than a minute.
std::pair<int, std::string> run(const std::filesystem::path& deck, const std::string& options) {
    const std::string command = "timeout -s KILL 60 " CORPUSCLE_PROGRAM " run '" + deck.string() +
                                "' -q -o '" + deck.string() + ".out' " + options + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part;
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text};
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
    const auto [status, text] =
        run(folder.write("deck.k", balloon("*MAT_RIGID\n1,1e-30,1e9,.3\n\n\n", "1e-4")), "");
    CHECK(status == 3);
    CHECK_THAT(text, Contains("times the bag's size in one step"));
}

TEST_CASE("a run that breaks in its first step shows the start once", "[io]") {
    const test::DeckFolder folder;
    const auto deck =
        folder.write("deck.k", balloon(CLOTH, "1e-4", "*INITIAL_VELOCITY_NODE\n1,1e9,0,0\n"));
    const auto [status, text] = run(deck, "");
    CHECK(status == 3);
    CHECK_THAT(text, Contains("the physics broke at time 0:"));
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
        "process.exit(Array.isArray(r.warnings) && Array.isArray(r.mended) && r.threads === 2"
        " && r.steps > 0 && r.wall >= r.parallel && r.contact.pairs_stopped === 0"
        " && r.phases.motion > 0 ? 0 : 1)\" '" +
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
    for (const char* options : {"--seed -3", "--seed 1.5", "-j 0", "-j 100000", "--until -1"}) {
        CAPTURE(options);
        CHECK(run(deck, options).first == 2);
    }
    CHECK(run(deck, "--seed 3 -j 2").first == 0);
}
