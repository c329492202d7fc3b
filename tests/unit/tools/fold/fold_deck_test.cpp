// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/deck_pattern.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "solver/base/error.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/inspect/inspect.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

/// Two panels on a trapezoid, 400 long and 300 to 200 wide, as a deck in a folder of its own.
class PanelDeck {
public:
    double height = 0.0;    ///< of the front above the back, which narrows to the rim
    bool is_shared = true;  ///< rims share nodes, else they lie on each other
    bool is_one_part = false;
    bool has_vent = false;  ///< some shells of the back are part 5
    double jitter = 0.0;    ///< of the back's inner nodes, so that the meshes differ
    int broken = 0;         ///< 1: a rim node away, 2: a shell upright, 3: a hole in the back

    PanelDeck()
        : folder_(std::filesystem::temp_directory_path() /
                  ("corpuscle_fold_deck_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~PanelDeck() { std::filesystem::remove_all(folder_); }

    Recipe recipe(const std::string& pattern, const std::string& folds) {
        write();
        return parse_recipe(
            "[pattern]\nkind = \"deck\"\nfile = \"panels.k\"\nelement = 12\n"
            "gap = 0.8\n" +
                pattern + folds,
            (folder_ / "recipe.toml").string());
    }

private:
    static constexpr int COLUMNS = 32, ROWS = 24;

    void write() const {
        std::string nodes = "*KEYWORD\n*TITLE\nnot read\n*NODE\n", shells = "*ELEMENT_SHELL\n";
        std::mt19937 random(5);
        std::uniform_real_distribution<double> shift(-jitter, jitter);
        const auto id = [&](int panel, int i, int j) {
            const bool is_rim = i == 0 || j == 0 || i == COLUMNS || j == ROWS;
            return (is_rim && is_shared ? 0 : panel) * 10000 + j * 100 + i + 1;
        };
        int shell = 0;
        for (int panel = 0; panel < 2; ++panel)
            for (int j = 0; j <= ROWS; ++j)
                for (int i = 0; i <= COLUMNS; ++i) {
                    const bool is_rim = i == 0 || j == 0 || i == COLUMNS || j == ROWS;
                    if (is_rim && is_shared && panel == 1) continue;
                    const double u = static_cast<double>(i) / COLUMNS;
                    double x = 400.0 * u - 200.0;
                    double y = (300.0 - 100.0 * u) * (static_cast<double>(j) / ROWS - 0.5);
                    if (panel == 1 && !is_rim) {
                        x += shift(random);
                        y += shift(random);
                    }
                    if (broken == 1 && panel == 1 && i == 0 && j == 7) y += 3.0;
                    double z = is_rim ? 0.0 : (panel == 0 ? 0.5 : -0.5) * height;
                    if (broken == 2 && i == 5 && j == 5) z += 30.0;
                    nodes += fmt::format("{},{:.9g},{:.9g},{:.9g}\n", id(panel, i, j), x, y, z);
                }
        for (int panel = 0; panel < 2; ++panel)
            for (int j = 0; j < ROWS; ++j)
                for (int i = 0; i < COLUMNS; ++i) {
                    const bool is_middle = std::abs(i - 16) < 2 && std::abs(j - 12) < 2;
                    if (broken == 3 && panel == 1 && is_middle) continue;
                    int part = is_one_part ? 1 : panel + 1;
                    if (has_vent && panel == 1 && is_middle) part = 5;
                    const int a = id(panel, i, j), b = id(panel, i + 1, j),
                              c = id(panel, i + 1, j + 1), d = id(panel, i, j + 1);
                    const auto triangle = [&](int p, int q, int r) {
                        shells += fmt::format("{},{},{},{},{},{}\n", ++shell, part, p, q, r, r);
                    };
                    if (panel == 0) {  // front: quads that look up, back: triangles that look down
                        shells += fmt::format("{},{},{},{},{},{}\n", ++shell, part, a, b, c, d);
                    } else if ((i < COLUMNS / 2) == (j < ROWS / 2)) {  // no corner on the rim alone
                        triangle(a, c, b);
                        triangle(a, d, c);
                    } else {
                        triangle(a, d, b);
                        triangle(d, c, b);
                    }
                }
        std::ofstream(folder_ / "panels.k") << nodes << shells << "*END\n";
    }

    std::filesystem::path folder_;
};

constexpr double AREA = 2.0 * 400.0 * 250.0;

double area_of(const Bag& bag) {
    double sum = 0.0;
    for (const Cell& c : bag.sheet.cells) sum += area(c, bag.sheet.X);
    return sum;
}

std::string fault_of(PanelDeck& deck, const std::string& pattern) {
    try {
        static_cast<void>(fold::fold(deck.recipe(pattern, "")));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

bool has(const std::string& what, const char* part) {
    INFO(what);
    return what.find(part) != std::string::npos;
}

const std::string PARTS = "front = [1]\nback = [2, 5]\n";

}  // namespace

TEST_CASE("two panels of a deck are sewn along their rims", "[fold]") {
    PanelDeck deck;
    deck.is_shared = GENERATE(true, false);
    deck.has_vent = true;
    const Bag bag = make_deck_bag(deck.recipe(PARTS, ""));
    CHECK(bag.seam.size() == 2 * (32 + 24));
    CHECK(rim_edges(bag.sheet.cells).empty());
    CHECK(area_of(bag) == Approx(AREA));
    CHECK(bag.has_vents);
    CHECK(bag.parts.size() == 3);
    for (const Cell& c : bag.sheet.cells) CHECK(quality(c, bag.sheet.X) > 0.0);
    CHECK(crossing_cells(bag.sheet).empty());
}

TEST_CASE("a flat bag in one part is told apart by height", "[fold]") {
    PanelDeck deck;
    deck.is_one_part = true;
    deck.height = 2.0;
    const Bag bag = make_deck_bag(deck.recipe("", ""));
    CHECK(rim_edges(bag.sheet.cells).empty());
    CHECK(bag.parts.size() == 2);
    CHECK(bag.parts[0].id == 1);
    CHECK(bag.parts[0].is_front != bag.parts[1].is_front);
}

TEST_CASE("panels of a deck fold without a crossing, matching or not", "[fold]") {
    PanelDeck deck;
    deck.jitter = GENERATE(0.0, 2.0);
    const std::string both =
        "[[fold]]\nkind = \"zigzag\"\nside = \"both\"\nstart = 50\nwidth = 55\n";
    const std::string across = "[[fold]]\nkind = \"half\"\nangle = 90\nat = 5\n";
    const std::string tuck = "[[fold]]\nkind = \"tuck\"\nat = 140\n";
    const std::vector<std::string> all{both, both + across, tuck, tuck + across};
    const std::string folds = all[static_cast<std::size_t>(GENERATE(0, 1, 2, 3))];
    INFO(deck.jitter << "\n" << folds);
    const Bag bag = fold::fold(deck.recipe("front = [1]\nback = [2]\n", folds));
    const Inspection found = inspect(bag, 0.0);
    CHECK(found.crossings.empty());
    CHECK(found.greatest_strain < 0.08);
    CHECK(area_of(bag) == Approx(AREA).epsilon(0.01));
    std::vector<Cell> cells = bag.sheet.cells;
    CHECK(rim_edges(cells).empty());
}

TEST_CASE("the wider end of a deck's panels cannot be tucked in", "[fold]") {
    PanelDeck deck;
    const Recipe recipe = deck.recipe("front = [1]\nback = [2]\n",
                                      "[[fold]]\nkind = \"tuck\"\nside = \"left\"\nat = 140\n");
    CHECK_THROWS_WITH(fold::fold(recipe), Catch::Matchers::Contains("stands out by"));
}

TEST_CASE("a hole in a panel of a deck stays open", "[fold]") {
    PanelDeck deck;
    deck.broken = 3;
    const Bag bag = make_deck_bag(deck.recipe("front = [1]\nback = [2]\n", ""));
    CHECK(rim_edges(bag.sheet.cells).size() == 12);
}

TEST_CASE("decks that are no pattern are refused", "[fold]") {
    PanelDeck deck;
    CHECK(has(fault_of(deck, "front = [1]\nback = [7]\n"),
              "part 2 is in neither front nor back of [pattern]"));
    CHECK(has(fault_of(deck, "front = [1, 2]\nback = [2]\n"),
              "part 2 is in both front and back of [pattern]"));
    CHECK(has(fault_of(deck, "front = [1]\n"), "part numbers, for the other panel's are given"));
    CHECK(has(fault_of(deck, ""), "both panels lie at the same height"));
    CHECK(has(fault_of(deck, PARTS + "[hole]\ndiameter = 60\n"), "a deck's panels have their own"));
    deck.is_shared = false;
    deck.broken = 1;
    CHECK(has(fault_of(deck, PARTS), "the seam opens at node"));
    deck.broken = 2;
    CHECK(has(fault_of(deck, PARTS), "expected a flat pattern there"));
    CHECK(has(fault_of(deck, "front = [1]\nback = [2]\nlength = 3\n"), "length"));
    deck.broken = 0;
    Recipe gone = deck.recipe(PARTS, "");
    gone.pattern.deck = "nowhere.k";
    CHECK_THROWS_AS(fold::fold(gone), InputError);
}
