// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: no command writes over what it reads, whatever the names, and no run over what other
// programs wrote.

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

#include "io/results/results_file.hpp"
#include "tests/places.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using Catch::Contains;

namespace {

std::pair<int, std::string> corpuscle_in(const std::filesystem::path& folder,
                                         const std::string& words) {
    return test::shell("cd '" + folder.string() + "' && " CORPUSCLE_PROGRAM " " + words + " 2>&1");
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("an output that is an input is refused", "[io]") {
    const test::DeckFolder folder;
    const std::filesystem::path models = CORPUSCLE_MODELS;
    const auto recipe = folder.write("bag.toml", bytes_of(models / "recipes/zigzag.toml"));
    const auto here = recipe.parent_path();
    folder.write("bag.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    std::filesystem::create_symlink("bag.toml", here / "link.k");
    std::filesystem::create_hard_link(here / "bag.ply", here / "other.k");
    for (const char* words :
         {"fold bag.toml -o bag.toml", "fold bag.toml -o ./link.k", "mesh bag.ply -o bag.ply",
          "mesh bag.ply -o other.k", "new --from bag.toml -o link.k"}) {
        CAPTURE(words);
        const auto [status, text] = corpuscle_in(here, words);
        CHECK(status == 2);
        CHECK_THAT(text, Contains("expected another file: this is bag."));
        CHECK(bytes_of(recipe) == bytes_of(models / "recipes/zigzag.toml"));
        CHECK(bytes_of(here / "bag.ply").starts_with("ply"));
    }
    CHECK(std::filesystem::is_symlink(here / "link.k"));
}

TEST_CASE("a run that has no histories yet has no responses, and says so", "[responses]") {
    const scene::Folder folder("no_histories");
    { const io::ResultsFile begun(folder.path / "bag.out", scene::info(), scene::layout()); }
    const auto [status, text] = corpuscle_in(folder.path, "responses bag.out");
    CHECK(status == 2);
    CHECK_THAT(text, Contains("bag.out: the run has no histories yet"));
}

TEST_CASE("a page is not written over the results that it shows", "[io]") {
    const scene::Folder folder("page_over_results");
    { const io::ResultsFile begun(folder.path / "bag.out", scene::info(), scene::layout()); }
    const auto [refused, told] = corpuscle_in(folder.path, "report bag.out -o bag.out/results.h5");
    CHECK(refused == 2);
    CHECK_THAT(told, Contains("expected another file: this is bag.out/results.h5"));
}

TEST_CASE("a run refuses a folder with results of another program", "[io]") {
    const test::DeckFolder folder;
    const auto here = folder.write("deck.k", test::small_deck()).parent_path();
    const std::string name = GENERATE("d3plot", "d3plot01", "binout", "nodout", "history.csv",
                                      "results.h5", "checkpoint");
    const auto file = folder.write("theirs/" + name, "of another program");
    const auto [status, text] = corpuscle_in(here, "run deck.k -o theirs --until 1e-3");
    CHECK(status == 2);
    CHECK_THAT(text, Contains("theirs holds no results of corpuscle, but " + name + ":"));
    CHECK(bytes_of(file) == "of another program");
    std::filesystem::remove(file);
    CHECK(std::filesystem::is_empty(here / "theirs"));
}

TEST_CASE("another program's exports stay where they are beside results of corpuscle", "[io]") {
    const test::DeckFolder folder;
    const auto here = folder.write("deck.k", test::small_deck()).parent_path();
    const std::string run = "run deck.k -o out --until 1e-3";
    REQUIRE(corpuscle_in(here, run).first == 0);
    REQUIRE(corpuscle_in(here, "export out --d3plot --binout --csv").first == 0);
    const auto [status, text] = corpuscle_in(here, run);
    CHECK(status == 0);
    CHECK_THAT(text, Contains("removed: binout, d3plot, d3plot01, ") && Contains("history.csv"));
    const std::string name = GENERATE("d3plot", "glstat", "binout", "history.csv",
                                      "history_fast.csv", "cpm_sensor", "responses.json");
    const std::string theirs = "of another\nprogram\n";
    const auto file = folder.write("out/" + name, theirs);
    const auto [refused, told] = corpuscle_in(here, run);
    CHECK(refused == 2);
    CHECK_THAT(told, Contains("out holds results of another program, " + name + ":"));
    CHECK(bytes_of(file) == theirs);
}

TEST_CASE("a run takes away exports of its own, not the tests of others", "[export]") {
    const test::DeckFolder folder;
    const auto here = folder.write("deck.k", test::small_deck()).parent_path();
    folder.write("out/notes.txt", "of the user");
    folder.write("out/theirs/theirs.mme", "Laboratory name             :Kiel\n");
    const std::string run = "run deck.k -o out --until 1e-3";
    REQUIRE(corpuscle_in(here, run).first == 0);
    folder.write("out/own/own.mme", "Laboratory name             :corpuscle 1\n");
    folder.write("out/own/Channel/own.001", "");
    folder.write("out/mixed/mixed.mme", "Laboratory name             :corpuscle 1\n");
    folder.write("out/mixed/photo", "of the user");
    const auto [status, text] = corpuscle_in(here, run);
    CHECK(status == 0);
    CHECK_THAT(text, Contains("removed: mixed, own, run.json"));
    CHECK_FALSE(std::filesystem::exists(here / "out/own"));
    CHECK_FALSE(std::filesystem::exists(here / "out/mixed/mixed.mme"));
    for (const char* kept : {"notes.txt", "theirs/theirs.mme", "mixed/photo", "results.h5"})
        CHECK(std::filesystem::exists(here / "out" / kept));
}
