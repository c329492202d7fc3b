// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a bag with a missing rim part, hanging nodes, turned facets or a small hole is mended, and
// has the volume and pressure of the whole one (tests/decks/closing_*.k).

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "io/deck.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/closing.hpp"
#include "solver/simulation.hpp"
#include "tests/places.hpp"

using namespace corpuscle;

namespace {

Model read_closing(const std::string& name) {
    return io::read_deck(std::string(CORPUSCLE_DECKS) + "/" + name);
}

struct EndOfRun {
    double volume, pressure;
};

EndOfRun end_of(Model model) {
    close_bags(model);
    Simulation scene(std::move(model));
    while (!scene.is_over()) scene.step([](Simulation&) {});
    const gas::ControlVolume& gas = scene.uniform_bags().at(0).gas();
    return {gas.volume(), gas.pressure()};
}

EndOfRun end_of(const std::string& name) {
    return end_of(read_closing(name));
}

std::string only_fault(Model model) {
    try {
        close_bags(model);
    } catch (const InputError& error) {
        REQUIRE(error.faults.size() == 1);
        return error.faults[0];
    }
    return {};
}

std::string only_mending(Model& model) {
    close_bags(model);
    REQUIRE(model.mendings.size() == 1);
    return model.mendings[0];
}

/// Each quad cut into four: nodes in the middle of its edges, which neighbours share, and of itself.
void refine(Model& model) {
    std::map<std::pair<Index, Index>, Index> middles;
    int id = *std::max_element(model.node_id.begin(), model.node_id.end());
    const auto add = [&](const Vec3& at) {
        model.x.push_back(at);
        model.velocity.push_back(Vec3::Zero());
        model.node_id.push_back(++id);
        return static_cast<Index>(model.x.size()) - 1;
    };
    const auto middle = [&](Index a, Index b) {
        const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), -1);
        if (is_new) at->second = add(0.5 * (model.x[a] + model.x[b]));
        return at->second;
    };
    std::vector<Shell> finer;
    for (const Shell& shell : model.shells) {
        const auto& n = shell.nodes;
        const Index centre =
            add(0.25 * (model.x[n[0]] + model.x[n[1]] + model.x[n[2]] + model.x[n[3]]));
        for (std::size_t k = 0; k < 4; ++k)
            finer.push_back(
                {static_cast<int>(finer.size()) + 1,
                 shell.part,
                 {n[k], middle(n[k], n[(k + 1) % 4]), centre, middle(n[(k + 3) % 4], n[k])}});
    }
    model.shells = std::move(finer);
    std::vector<Index>& bag = model.uniform_bags[0].shells;
    bag.resize(model.shells.size());
    std::iota(bag.begin(), bag.end(), 0);
}

/// Without the four quads at the node that is nearest to `at`, as a hole for a sensor's lead.
void cut_hole(Model& model, const Vec3& at) {
    Index nearest = 0;
    for (std::size_t n = 0; n < model.x.size(); ++n)
        if ((model.x[n] - at).norm() < (model.x[nearest] - at).norm())
            nearest = static_cast<Index>(n);
    const std::size_t erased = std::erase_if(model.shells, [&](const Shell& shell) {
        return std::find(shell.nodes.begin(), shell.nodes.end(), nearest) != shell.nodes.end();
    });
    REQUIRE(erased == 4);
    model.uniform_bags[0].shells.resize(model.shells.size());
}

}  // namespace

TEST_CASE("a part whose free edges are the hole joins the bag", "[closing]") {
    using Catch::Contains;
    Model model = read_closing("closing_rim_part.k");
    CHECK_THAT(only_mending(model),
               Contains("*AIRBAG_WANG_NEFSKE 7: part 2 \"face with the nozzle\" joins it: its 4 "
                        "shells close a hole of 8 edges"));
    const EndOfRun whole = end_of("closing_clean.k"), mended = end_of("closing_rim_part.k");
    CHECK(mended.volume == Approx(whole.volume).epsilon(1e-12));
    CHECK(mended.pressure == Approx(whole.pressure).epsilon(1e-12));

    Model refused = read_closing("closing_rim_part.k");
    refused.closes_bags = false;
    CHECK_THAT(only_fault(refused),
               Contains("is not closed: a hole of 8 edges about (0.1, 0.05, 0.05), 0.1414 wide, of "
                        "area 0.01") &&
                   Contains("part 2 \"face with the nozzle\" has all nodes of its rim: add it"));
}

TEST_CASE("facets that are turned are a mending, or refused", "[closing]") {
    Model model = read_closing("closing_clean.k");
    for (const std::size_t s : {0U, 3U})  // quads, of two facets each
        std::swap(model.shells[s].nodes[1], model.shells[s].nodes[3]);
    Model refused = model;
    const Simulation mended(std::move(model), 1);
    CHECK_THAT(mended.model().mendings.back(), Catch::Contains("4 facets turned"));
    refused.closes_bags = false;
    std::string why;
    try {
        const Simulation none(std::move(refused), 1);
    } catch (const InputError& error) {
        why = error.what();
    }
    CHECK_THAT(why, Catch::Contains("4 facets have their normals against their neighbours'"));
}

TEST_CASE("nodes that hang on the rim of a finer face are tied", "[closing]") {
    Model model = read_closing("closing_hanging.k");
    CHECK_THAT(only_mending(model), Catch::Contains("16 hanging nodes tied"));
    CHECK(model.tied_nodes.size() == 16);
    const EndOfRun whole = end_of("closing_clean_fine.k"), mended = end_of("closing_hanging.k");
    CHECK(mended.volume == Approx(whole.volume).epsilon(0.01));
    CHECK(mended.pressure == Approx(whole.pressure).epsilon(0.01));
}

TEST_CASE("a small hole gets a lid without mass, a large one is described", "[closing]") {
    using Catch::Contains;
    Model model = read_closing("closing_hole.k");
    const std::size_t shells = model.shells.size();
    CHECK_THAT(only_mending(model), Contains("a hole of 4 edges about (0.025, 0.025, 0.1), 0.07071 "
                                             "wide, of area 0.0025") &&
                                        Contains("closed by a lid without mass, part 3"));
    CHECK(model.shells.size() == shells + 2);
    const Simulation scene(model);
    CHECK(scene.uniform_bags().at(0).gas().volume() == Approx(1e-3).epsilon(1e-12));
    const EndOfRun whole = end_of("closing_clean.k"), mended = end_of("closing_hole.k");
    CHECK(mended.volume == Approx(whole.volume).epsilon(0.02));
    CHECK(mended.pressure == Approx(whole.pressure).epsilon(0.02));

    Model large = read_closing("closing_rim_part.k");
    std::erase_if(large.shells, [](const Shell& shell) { return shell.part == 1; });
    large.uniform_bags[0].shells = std::vector<Index>(large.shells.size());
    for (std::size_t s = 0; s < large.shells.size(); ++s)
        large.uniform_bags[0].shells[s] = static_cast<Index>(s);
    CHECK_THAT(only_fault(large),
               Contains("of area 0.01") && Contains("share of the bag's area = "));
    large.lid_share = 0.25;
    CHECK_THAT(only_mending(large), Contains("lid without mass"));
}

TEST_CASE("facets that are turned round change nothing", "[closing]") {
    Model model = read_closing("closing_clean.k");
    for (std::size_t s = 0; s < model.shells.size(); s += 3)
        std::swap(model.shells[s].nodes[1], model.shells[s].nodes[3]);
    const EndOfRun whole = end_of("closing_clean.k"), mended = end_of(model);
    CHECK(mended.volume == Approx(whole.volume).epsilon(1e-9));
    CHECK(mended.pressure == Approx(whole.pressure).epsilon(1e-9));
}

TEST_CASE("the finer the mesh, the less a shell that is missing changes", "[closing]") {
    const auto without_one = [](const std::string& name) {
        Model model = read_closing(name);
        const std::size_t gone = model.shells.size() / 2;
        model.shells.erase(model.shells.begin() + static_cast<std::ptrdiff_t>(gone));
        std::vector<Index>& bag = model.uniform_bags[0].shells;
        std::erase(bag, static_cast<Index>(gone));
        for (Index& shell : bag) shell -= shell > static_cast<Index>(gone) ? 1 : 0;
        return model;
    };
    double before = 1.0;
    for (const char* name : {"closing_clean.k", "closing_clean_fine.k"}) {
        const EndOfRun whole = end_of(name), mended = end_of(without_one(name));
        const double change = std::abs(mended.volume / whole.volume - 1.0);
        CAPTURE(name, change, mended.pressure / whole.pressure - 1.0);
        CHECK(change < 0.5 * before);
        before = change;
    }
    CHECK(before < 1e-3);
}

TEST_CASE("a hole of a few facets of a fine mesh changes volume and pressure by less than 0.1 %",
          "[closing]") {
    Model whole = read_closing("closing_clean_fine.k");
    refine(whole);
    refine(whole);
    REQUIRE(whole.shells.size() == 1536);
    Model holed = whole;
    cut_hole(holed, {0.03, 0.05, 0.1});
    const EndOfRun clean = end_of(whole);
    CHECK_THAT(only_mending(holed), Catch::Contains("a hole of 8 edges"));
    const EndOfRun mended = end_of(holed);
    CAPTURE(mended.volume / clean.volume - 1.0, mended.pressure / clean.pressure - 1.0);
    CHECK(clean.volume > 1.05e-3);  // it has swollen, from 1 l
    CHECK(mended.volume == Approx(clean.volume).epsilon(1e-3));
    CHECK(mended.pressure == Approx(clean.pressure).epsilon(1e-3));
}
