// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/bag.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "io/deck.hpp"
#include "solver/base/error.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/inspect/inspect.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

const std::string BAG =
    "[pattern]\nkind = \"disc\"\ndiameter = 400\nelement = 12\ngap = 0.8\n"
    "[hole]\ndiameter = 60\nreinforcement = 100\n[[vent]]\nat = [90, 60]\ndiameter = 40\n"
    "[[tether]]\nfrom = [-90, 0]\nlength = 180\nwidth = 40\n";
const std::string ZIGZAG = "[[fold]]\nkind = \"zigzag\"\nside = \"both\"\nstart = 60\nwidth = 55\n";

double area_of(const Bag& bag, int id) {
    double sum = 0.0;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e)
        if (bag.parts[bag.sheet.part[e]].id == id) sum += area(bag.sheet.cells[e], bag.sheet.X);
    return sum;
}

double disc(double diameter) {
    return 0.25 * std::numbers::pi * diameter * diameter;
}

}  // namespace

TEST_CASE("the pieces of a bag have the areas of their drawing", "[fold]") {
    const Bag bag = make_bag(parse_recipe(BAG, "bag.toml"), {});
    CHECK(area_of(bag, 1) == Approx(disc(400)).epsilon(0.005));
    CHECK(area_of(bag, 3) == Approx(disc(60)).epsilon(0.06));
    CHECK(area_of(bag, 3) + area_of(bag, 4) == Approx(disc(100)).epsilon(0.04));
    CHECK(area_of(bag, 5) == Approx(disc(40)).epsilon(0.08));
    CHECK(area_of(bag, 6) == Approx(180.0 * 40.0).epsilon(1e-6));
    CHECK(area_of(bag, 2) + area_of(bag, 3) + area_of(bag, 4) + area_of(bag, 5) ==
          Approx(area_of(bag, 1)));
}

TEST_CASE("the panels share the seam and nothing else, and close", "[fold]") {
    const Bag bag = fold::fold(parse_recipe(BAG + ZIGZAG, "bag.toml"));
    std::vector<Cell> panels;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e)
        if (bag.parts[bag.sheet.part[e]].id != 6) panels.push_back(bag.sheet.cells[e]);
    CHECK(rim_edges(panels).empty());
    std::map<std::pair<Index, Index>, int> ways;  // +1 and -1: neighbours agree in orientation
    for (const Cell& c : panels)
        for (int k = 0, n = corner_count(c); k < n; ++k) {
            const Index a = c[k], b = c[(k + 1) % n];
            ways[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    for (const auto& [edge, sum] : ways) CHECK(sum == 0);
}

TEST_CASE("a rectangle's panels share no edge at its corners but the seam's", "[fold]") {
    const std::string rectangle =
        "[pattern]\nkind = \"rectangle\"\nlength = 480\nwidth = 360\nelement = 14\ngap = 0.8\n";
    // the second has a line across a corner
    for (const char* angle : {"0", "87.7"}) {
        const Bag bag = fold::fold(parse_recipe(rectangle + ZIGZAG + "angle = " + angle +
                                                    "\n[[fold]]\nkind = \"half\"\nside = "
                                                    "\"right\"\nangle = 37\nat = 100\n",
                                                "bag.toml"));
        std::map<std::pair<Index, Index>, int> facets;
        for (const Triangle& t : triangles(bag.sheet.cells))
            for (std::size_t i = 0; i < 3; ++i) ++facets[std::minmax(t[i], t[(i + 1) % 3])];
        for (const auto& [edge, count] : facets) CHECK(count == 2);
    }
}

TEST_CASE("an open hole is a rim", "[fold]") {
    const std::string text =
        "[pattern]\nkind = \"disc\"\ndiameter = 400\nelement = 12\ngap = 0.8\n"
        "[hole]\ndiameter = 60\nopen = true\n";
    const Bag bag = make_bag(parse_recipe(text, "bag.toml"), {});
    CHECK(area_of(bag, 1) - area_of(bag, 2) == Approx(disc(60)).epsilon(0.06));
    CHECK_FALSE(rim_edges(bag.sheet.cells).empty());
}

TEST_CASE("an unfolded bag does not cross itself, and swapped layers are found", "[fold]") {
    Bag bag = make_bag(parse_recipe(BAG, "bag.toml"), {});
    CHECK(crossing_cells(bag.sheet).empty());
    Index nearest = 0;  // a node of the front in mid-panel, pushed through the back
    for (Index n = 0; n < static_cast<Index>(bag.sheet.x.size()); ++n)
        if (bag.sheet.x[n].z() > 0.0 && (bag.sheet.x[n] - Vec3(0, -100, 0)).norm() <
                                            (bag.sheet.x[nearest] - Vec3(0, -100, 0)).norm())
            nearest = n;
    bag.sheet.x[nearest] += Vec3(1.3, 0.7, -3.0);
    CHECK_FALSE(crossing_cells(bag.sheet).empty());
}

TEST_CASE("what does not fit the pattern is refused", "[fold]") {
    const std::string disc =
        "[pattern]\nkind = \"disc\"\ndiameter = 200\nelement = 12\ngap = 0.8\n";
    const auto make = [&](const std::string& more) {
        return make_bag(parse_recipe(disc + more, "b"), {});
    };
    CHECK_THROWS_AS(make("[hole]\ndiameter = 210\n"), InputError);
    CHECK_THROWS_AS(make("[[vent]]\nat = [90, 0]\ndiameter = 30\n"), InputError);
    // no element of 12 is left of it
    CHECK_THROWS_WITH(make("[[vent]]\nat = [40, 33]\ndiameter = 6\n"),
                      Catch::Contains("the mesh has 0 of its area"));
    CHECK_THROWS_AS(make("[[tether]]\nfrom = [0, 0]\nlength = 120\nwidth = 20\n"), InputError);
    CHECK_THROWS_AS(make("[[tether]]\nfrom = [-50, 0]\nlength = 100\nwidth = 30\n"
                         "[[tether]]\nfrom = [-50, 20]\nlength = 100\nwidth = 30\n"),
                    InputError);
}

TEST_CASE("a tether that ends where a fold does is told, and a band that ends elsewhere",
          "[fold]") {
    const std::string pattern =
        "[pattern]\nkind = \"disc\"\ndiameter = 400\nelement = 12\ngap = 0.8\n";
    const std::string rest =
        "[[tether]]\nfrom = [-90, 0]\nlength = 180\nwidth = 40\n"
        "[[fold]]\nkind = \"zigzag\"\nstart = 60\nwidth = 45\n";
    // line at 105, its band's border at 93
    const Bag taken = fold::fold(parse_recipe(pattern + rest, "bag.toml"));
    REQUIRE(taken.remarks.size() == 1);
    CHECK(taken.remarks[0] ==
          "bag.toml:6: [[tether]] is 183 long in place of 180: it ends where a fold does");
    CHECK(area_of(taken, 6) == Approx(183.0 * 40.0));
    // at 90
    const Bag exact = fold::fold(parse_recipe(pattern + "band = 15\n" + rest, "bag.toml"));
    CHECK(exact.remarks.empty());
    CHECK(area_of(exact, 6) == Approx(180.0 * 40.0));
}

TEST_CASE("a vent that is not as large as it is drawn is told", "[fold]") {
    const auto with_elements_of = [](const std::string& size) {
        std::string bag = BAG;
        bag.replace(bag.find("= 12") + 2, 2, size);
        return make_bag(parse_recipe(bag, "bag.toml"), {});
    };
    const Bag coarse = with_elements_of("20");
    CHECK(area_of(coarse, 5) == Approx(1039.0).epsilon(1e-3));
    REQUIRE(coarse.remarks.size() == 1);
    CHECK(coarse.remarks[0] ==
          "bag.toml: [[vent]] at = [90, 60] has an area of 1039 in place of "
          "1257: smaller elements are nearer");
    const Bag fine = with_elements_of("5");
    CHECK(area_of(fine, 5) == Approx(disc(40)).epsilon(0.02));
    CHECK(fine.remarks.empty());
}

TEST_CASE("the deck holds the folded bag and its flat shape", "[fold]") {
    const Recipe recipe = parse_recipe(BAG + ZIGZAG, "bag.toml");
    const Bag bag = fold::fold(recipe);
    const Inspection found = inspect(bag, recipe.pattern.gap);
    CHECK(found.crossings.empty());
    const auto folder =
        std::filesystem::temp_directory_path() / ("corpuscle_fold_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "mesh.k") << bag_deck(bag, recipe, found);
    std::ofstream deck(folder / "bag.k");
    deck << "*KEYWORD\n*INCLUDE\nmesh.k\n*CONTROL_TERMINATION\n1.0\n";
    for (int id = 1; id <= 6; ++id) deck << "*PART\ncloth\n" << id << ",1,1\n";
    deck << "*SECTION_SHELL\n1,5\n.3,.3,.3,.3\n*MAT_FABRIC\n1,7e-7,.35\n.005\n\n\n\n*END\n";
    deck.close();
    const Model model = io::read_deck(folder / "bag.k");
    std::filesystem::remove_all(folder);
    REQUIRE(model.x.size() == bag.sheet.x.size());
    REQUIRE(model.shells.size() == bag.sheet.cells.size());
    REQUIRE(model.references.size() == 1);
    REQUIRE(model.references[0].nodes.size() == bag.sheet.X.size());
    for (std::size_t n = 0; n < model.x.size(); ++n) {
        CHECK((model.x[n] - bag.sheet.x[n]).norm() < 1e-9);
        CHECK((model.references[0].nodes[n].second - bag.sheet.X[n]).norm() < 1e-9);
    }
}

TEST_CASE("the strain across a needle is reported, which its edges hardly show", "[fold]") {
    Bag bag;
    bag.parts = {{1, "cloth", false}};
    bag.sheet.X = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}};
    bag.sheet.x = {{0, 0, 3}, {0, 1, 3}, {-0.02, 0.5, 3}};  // turned, and twice as high
    bag.sheet.cells = {{0, 1, 2, 2}};
    bag.sheet.part = {0};
    const Inspection found = inspect(bag, 0.0);
    CHECK(found.greatest_strain < 1e-3);
    CHECK(found.greatest_stretch == Approx(0.5 * (2.0 * 2.0 - 1.0)));
    CHECK(found.stretched_at == 0);
}

TEST_CASE("a pack says by how much it does not fit", "[fold]") {
    Inspection found;
    found.low = Vec3::Zero();
    found.high = Vec3(100, 120, 40);
    CHECK(fit(found, {100, 120, 40}) == "fits into the package of 100 x 120 x 40");
    CHECK(fit(found, {110, 115, 30}) ==
          "does not fit into the package of 110 x 115 x 30: too great in width by 5, height by 10");
}

TEST_CASE("a disc smaller than its elements is refused, with the field", "[fold]") {
    const auto element = GENERATE(200.0, 300.0, 400.0, 500.0, 600.0, 1000.0, 5000.0);
    CAPTURE(element);
    const Recipe recipe =
        parse_recipe("[pattern]\nkind = \"disc\"\ndiameter = 600\ngap = 0.7\nelement = " +
                         std::to_string(element) + "\n",
                     "bag.toml");
    try {
        const Bag bag = fold::fold(recipe);
        CHECK(element < 1000.0);
        CHECK(area_of(bag, 1) > 0.5 * disc(600));
    } catch (const InputError& error) {
        CHECK(element > 250.0);
        CHECK_THAT(error.what(), Catch::Contains("bag.toml: [pattern] element = ") &&
                                     Catch::Contains("expected smaller elements"));
    }
}
