// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: no legal deck ends with status 0 and a number in results.h5 that is not finite. What
// overflows stops the run with status 3 and a message that says what, where and in which phase;
// results so far stay, as the same run without the fault has them, and so does the last checkpoint.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "io/results/checkpoint.hpp"
#include "tests/places.hpp"
#include "tests/support/decks/busy_cube.hpp"
#include "tests/support/runs/datasets.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

constexpr double BREAKS_AT = 0.6e-3;  ///< [s]

struct Run {
    int status;
    std::string told;
    fs::path folder;
};

Run run(const fs::path& deck, const std::string& options = "") {
    const fs::path folder = deck.string() + ".out";
    const auto [status, told] =
        test::shell(fmt::format("ulimit -t 60; {} run '{}' -q -j 1 -o '{}' {} 2>&1",
                                CORPUSCLE_PROGRAM, deck.string(), folder.string(), options));
    return {status, told, folder};
}

/// The line that says why.
std::string reason(const std::string& told) {
    const auto at = told.find("the physics broke");
    return at == std::string::npos ? "none" : told.substr(at, told.find('\n', at) - at);
}

/// Curve 77: nothing up to BREAKS_AT, then `value`.
std::string jump(const char* value) {
    return fmt::format("*DEFINE_CURVE\n77\n0.0, 0.0\n{0}, 0.0\n{0}, {1}\n1.0, {1}\n", BREAKS_AT,
                       value);
}

struct Overflow {
    const char* name;
    support::BusyCube broken, whole;  ///< with a number that overflows, with an innocent one
    std::vector<const char*> words;   ///< of the message
};

std::vector<Overflow> overflows() {
    const auto by_cards = [](const char* name, const std::string& cards,
                             const std::vector<const char*>& words) {
        return Overflow{name, {cards + jump("1e100")}, {cards + jump("0.0")}, words};
    };
    return {by_cards("force on a node", "*LOAD_NODE_POINT\n8, 1, 77, 1e100\n",
                     {"kinetic energy overflows at node 8 near (", "that of loads"}),
            by_cards("gravity", "*LOAD_BODY_X\n77, 1e100\n",
                     {"kinetic energy overflows at node", "that of loads"}),
            by_cards("pressure", "*SET_SEGMENT\n9\n4, 3, 2, 1\n*LOAD_SEGMENT_SET\n9, 77, 1e100\n",
                     {"kinetic energy overflows at node", "that of loads"}),
            by_cards("driven node",
                     "*SET_NODE_LIST\n9\n8\n*BOUNDARY_PRESCRIBED_MOTION_SET\n9, 1, 0, 77, 1e100\n",
                     {"kinetic energy overflows at node 8 near ("}),
            by_cards("driven wall",
                     "*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n0\n0.0, 0.0, -0.05, 0.0, 0.0, 1.0\n"
                     "0.0, 0.0, 0.0, 0.0, 0.0\n77, 0, 0.0, 0.0, 1.0\n",
                     {"velocity of node 1 is not finite in single precision"})};
}

/// The values that both have of a history, up to the end of the shorter one, are the same bits.
bool begins_alike(const fs::path& broken, const fs::path& whole) {
    const io::Hdf5Reader a(broken), b(whole);
    bool is_alike = true;
    test::each_dataset(a, "/history", [&](const std::string& path) {
        const auto left = a.read<double>(path), right = b.read<double>(path);
        is_alike &= left.size() <= right.size() &&
                    std::memcmp(left.data(), right.data(), left.size() * sizeof(double)) == 0;
    });
    return is_alike;
}

}  // namespace

TEST_CASE("what overflows stops the run, and leaves the results so far and a checkpoint",
          "[finite]") {
    const test::DeckFolder folder;
    for (const Overflow& fault : overflows()) {
        const Run whole = run(folder.write("whole.k", fault.whole.deck()));
        CAPTURE(whole.told);
        REQUIRE(whole.status == 0);
        const test::Numbers all = test::numbers_of(whole.folder / "results.h5");
        CHECK(all.not_finite == "");
        CHECK(all.count > 10000);
        const fs::path deck = folder.write("broken.k", fault.broken.deck());
        const Run broken = run(deck);
        INFO(fault.name << "\n" << broken.told);
        CHECK(broken.status == 3);
        CHECK_THAT(broken.told, Contains("the physics broke at time "));
        for (const char* words : fault.words) CHECK_THAT(broken.told, Contains(words));

        const test::Numbers numbers = test::numbers_of(broken.folder / "results.h5");
        CHECK(numbers.not_finite == "");
        const io::Hdf5Reader results(broken.folder / "results.h5");
        CHECK_THAT(results.text("/", "termination"), Contains("error: "));
        const auto time = results.read<double>("/history/time");
        REQUIRE(time.size() >= 58);  // a row each 1e-5 s
        CHECK(time.back() > BREAKS_AT - 2e-5);
        CHECK(begins_alike(broken.folder / "results.h5", whole.folder / "results.h5"));

        const auto checkpoint = io::read_checkpoint(broken.folder);
        REQUIRE(checkpoint);
        CHECK(checkpoint->step % 40 == 0);
        CHECK(checkpoint->t > 0.75 * BREAKS_AT);
        CHECK(checkpoint->t < 0.9 * BREAKS_AT);
        // from it the run goes on: to an end before the fault, or to the same fault
        const Run again = run(deck, "--restart");
        CHECK(again.status == 3);
        CHECK(reason(again.told) == reason(broken.told));
        const Run before = run(deck, fmt::format("--restart --until {}", 0.9 * BREAKS_AT));
        CHECK(before.status == 0);
        CHECK(test::numbers_of(before.folder / "results.h5").not_finite.empty());
    }
}

TEST_CASE("a stress that results cannot hold stops the run, by its shell", "[finite]") {
    // masses and moduli in a unit of 1e-45 kg: all that is computed is finite, but not in 32 bits
    const test::DeckFolder folder;
    const std::string text = fmt::format(
        "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n11,1,1,2,3,4\n"
        "*PART\ncloth\n1,1,1\n*SECTION_SHELL\n1,9\n1e-3,1e-3,1e-3,1e-3\n"
        "*MAT_ELASTIC\n1,8e47,3e53,0.3\n*INITIAL_VELOCITY_NODE\n3,1,1,0\n"
        "*CONTROL_TERMINATION\n1e-3\n*DATABASE_BINARY_D3PLOT\n1e-4\n*END\n");
    const Run broken = run(folder.write("deck.k", text));
    CAPTURE(broken.told);
    CHECK(broken.status == 3);
    CHECK_THAT(broken.told, Contains("stress of shell 11 is not finite"));
    CHECK(test::numbers_of(broken.folder / "results.h5").not_finite.empty());
}

TEST_CASE("results of the decks of others have finite numbers only", "[finite]") {
    const test::DeckFolder folder;
    std::size_t runs = 0, numbers = 0;
    for (const auto& entry : fs::directory_iterator(CORPUSCLE_DECKS)) {
        if (entry.path().extension() != ".k") continue;
        const fs::path out = folder.write("out/deck.k", "").parent_path();
        const auto [status, told] =
            test::shell(fmt::format("ulimit -t 60; {} run '{}' -q -j 1 -o '{}' 2>&1",
                                    CORPUSCLE_PROGRAM, entry.path().string(), out.string()));
        INFO(entry.path().filename().string() << "\n" << told);
        const bool breaks = entry.path().stem() == "vacuum_room";
        if (status == 2 && !breaks) continue;  // some are there to be refused
        CHECK(status == (breaks ? 3 : 0));
        const test::Numbers found = test::numbers_of(out / "results.h5");
        CHECK(found.not_finite == "");
        numbers += found.count;
        ++runs;
    }
    CHECK(runs > 30);
    CHECK(numbers > 100000);
}
