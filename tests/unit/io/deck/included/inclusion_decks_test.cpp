// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: *INCLUDE_TRANSFORM changes the ids of a file and where it lies, and nothing else of its
// scene, whatever keywords it has (tests/decks).

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>

#include "io/deck.hpp"
#include "solver/simulation.hpp"
#include "tests/places.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

namespace fs = std::filesystem;

/// Every kind has an offset of its own, so that an id of another kind is of nothing.
constexpr int BY_NODES = 11000, BY_ELEMENTS = 23000, BY_PARTS = 31000, BY_MATERIALS = 47000;
const std::string OFFSETS = "11000,23000,31000,47000,53000,67000,71000\n83000\n\n";

std::vector<fs::path> all_decks() {
    std::vector<fs::path> decks;
    for (const fs::directory_entry& entry : fs::directory_iterator(CORPUSCLE_DECKS))
        if (entry.path().extension() == ".k" &&
            !entry.path().filename().string().starts_with("closing_"))  // no scenes as written
            decks.push_back(entry.path());
    std::sort(decks.begin(), decks.end());
    return decks;
}

std::string including(const fs::path& deck, const std::string& cards, const std::string& rows) {
    return "*KEYWORD\n*INCLUDE_TRANSFORM\n" + deck.string() + "\n" + cards +
           (rows.empty() ? "0\n" : "7\n*DEFINE_TRANSFORMATION\n7\n" + rows) + "*END\n";
}

/// The model of a deck that the transformation's rows place; none: gravity would turn, which is
/// refused.
std::optional<Model> placed(const DeckFolder& folder, const fs::path& deck,
                            const std::string& rows) {
    try {
        return folder.read(including(deck, "0\n0\n\n", rows));
    } catch (const InputError& error) {
        for (const std::string& fault : error.faults)
            if (!contains(fault, "expected a body load in the deck itself")) throw;
        return {};
    }
}

/// Without particles, whose random directions do not turn with the scene.
bool is_drawn(const Model& model) {
    return !model.bags.empty();
}

Points after(Model model, int steps) {
    Simulation simulation(std::move(model), 1);
    for (int k = 0; k < steps && !simulation.is_over(); ++k) simulation.step([](Simulation&) {});
    return simulation.nodes().x;
}

double size_of(const Points& x) {
    Eigen::AlignedBox3d box;
    for (const Vec3& at : x) box.extend(at);
    return box.diagonal().norm();
}

/// The farthest that a node is off the place that the map gives to it.
double farthest(const Points& x, const Points& as_written, const Eigen::Affine3d& map) {
    double most = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        most = std::max(most, (x[i] - map * as_written[i]).norm());
    return most;
}

/// Contact that begins at a corner or along an edge takes one side or the other by a rounding, and so
/// do thin bodies of a few nodes: they are held to a share of how far nodes move, where a direction
/// that was read wrongly shows as all of it.
constexpr double ROUNDING = 1e-9, SHARE_OF_MOTION = 0.02;
constexpr int STEPS = 25;

/// Runs a deck as it is and put in place by the rows. False: not to be compared.
bool compare(const DeckFolder& folder, const fs::path& deck, const std::string& rows,
             const Eigen::Affine3d& map) {
    CAPTURE(deck.filename().string());
    Model plain = io::read_deck(deck);
    std::optional<Model> moved = placed(folder, deck, rows);
    if (!moved || is_drawn(plain)) return false;
    const Points start = plain.x;
    const double rounding = ROUNDING * size_of(start);
    const bool touches = !plain.contacts.empty() || !plain.rigid_extra_nodes.empty();
    CHECK(farthest(moved->x, start, map) < rounding);
    const Points x = after(std::move(plain), STEPS), y = after(std::move(*moved), STEPS);
    const double motion = farthest(x, start, Eigen::Affine3d::Identity());
    CHECK(farthest(y, x, map) < rounding + (touches ? SHARE_OF_MOTION * motion : 0.0));
    return true;
}

int compare_all(const std::string& rows, const Eigen::Affine3d& map) {
    const DeckFolder folder;
    int compared = 0;
    for (const fs::path& deck : all_decks()) compared += compare(folder, deck, rows, map) ? 1 : 0;
    return compared;
}

void check_ids(const Model& plain, const Model& shifted) {
    REQUIRE(shifted.x == plain.x);
    REQUIRE(shifted.shells.size() == plain.shells.size());
    REQUIRE(shifted.parts.size() == plain.parts.size());
    for (std::size_t i = 0; i < plain.x.size(); ++i)
        CHECK(shifted.node_id[i] == plain.node_id[i] + BY_NODES);
    for (std::size_t s = 0; s < plain.shells.size(); ++s) {
        CHECK(shifted.shells[s].id == plain.shells[s].id + BY_ELEMENTS);
        CHECK(shifted.shells[s].nodes == plain.shells[s].nodes);
        CHECK(shifted.shells[s].part == plain.shells[s].part);
    }
    for (std::size_t p = 0; p < plain.parts.size(); ++p) {
        CHECK(shifted.parts[p].id == plain.parts[p].id + BY_PARTS);
        CHECK(shifted.parts[p].material == plain.parts[p].material);
        const Index m = plain.parts[p].material;
        if (m >= 0 && plain.materials[static_cast<std::size_t>(m)].id > 0)
            CHECK(shifted.materials[static_cast<std::size_t>(m)].id ==
                  plain.materials[static_cast<std::size_t>(m)].id + BY_MATERIALS);
    }
    CHECK(shifted.history_nodes == plain.history_nodes);
}

}  // namespace

TEST_CASE("offsets shift all ids of a file and nothing else: the same bits", "[io]") {
    const DeckFolder folder;
    for (const fs::path& deck : all_decks()) {
        CAPTURE(deck.filename().string());
        Model plain = io::read_deck(deck), shifted = folder.read(including(deck, OFFSETS, ""));
        check_ids(plain, shifted);
        CHECK(after(std::move(plain), STEPS) == after(std::move(shifted), STEPS));
    }
}

TEST_CASE("a file's scene twice in one deck, by offsets, is two scenes that do not know each other",
          "[io]") {
    const DeckFolder folder;
    const auto deck = fs::path(CORPUSCLE_DECKS) / "wang_nefske_molar.k";
    const Model plain = io::read_deck(deck);
    const std::string twice = "*INCLUDE_TRANSFORM\n" + deck.string() + "\n" + OFFSETS +
                              "1\n*DEFINE_TRANSFORMATION\n1\nTRANSL,5.0\n";
    const Model model =
        folder.read("*KEYWORD\n*INCLUDE\n" + deck.string() + "\n" + twice + "*END\n");
    const std::size_t n = plain.x.size(), e = plain.shells.size();
    REQUIRE(model.x.size() == 2 * n);
    REQUIRE(model.uniform_bags.size() == 2 * plain.uniform_bags.size());
    for (std::size_t i = 0; i < n; ++i) CHECK(model.x[n + i] == plain.x[i] + Vec3(5, 0, 0));
    for (std::size_t s = 0; s < e; ++s)
        for (std::size_t k = 0; k < 4; ++k)
            CHECK(model.shells[e + s].nodes[k] == plain.shells[s].nodes[k] + static_cast<Index>(n));
    CHECK(model.uniform_bags[1].shells[0] ==
          plain.uniform_bags[0].shells[0] + static_cast<Index>(e));
}

TEST_CASE("a scene that is moved and turned onto other axes runs as the scene that is not",
          "[io]") {
    const Vec3 through(0.3, 0.2, 0.1), shift(0.5, -0.25, 1.0);
    const Eigen::Affine3d map = Eigen::Translation3d(shift) * Eigen::Translation3d(through) *
                                Eigen::AngleAxisd(2.0 * M_PI / 3.0, Vec3(1, 1, 1).normalized()) *
                                Eigen::Translation3d(-through);
    CHECK(compare_all("ROTATE,1,1,1,0.3,0.2,0.1,120\nTRANSL,0.5,-0.25,1\n", map) > 30);
}

TEST_CASE("a scene that is turned anyhow runs as the scene that is not", "[io]") {
    const Eigen::Affine3d map(Eigen::AngleAxisd(37.0 * M_PI / 180.0, Vec3(1, 2, 3).normalized()));
    CHECK(compare_all("ROTATE,1,2,3,0,0,0,37\n", map) > 30);
}

TEST_CASE("a mirrored scene runs as the mirror image: bodies, walls, loads, ties", "[io]") {
    // quads under pressure are cut along their other diagonal
    const Eigen::Affine3d map =
        Eigen::Translation3d(0.2, 0, 0) * Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0));
    const DeckFolder folder;
    for (const char* deck :
         {"gravity_part.k", "joint_hinge.k", "joint_stiffness.k", "joints_chain.k", "joints_hit.k",
          "loads_of_nodes.k", "masses_of_rigid.k", "rigid_loads.k", "stiffened.k", "tied_contact.k",
          "wall_box.k", "adaptivity.k", "table_of_solids.k"})
        CHECK(compare(folder, fs::path(CORPUSCLE_DECKS) / deck, "MIRROR,0.1,0,0,1.1,0,0\n", map));
}
