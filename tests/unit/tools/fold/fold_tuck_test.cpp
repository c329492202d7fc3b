// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/moves/tuck.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/error.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/inspect/inspect.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

constexpr double TUCK_GAP = 1.0;

/// Points along s of the two panels, which are sewn at the right end.
Points panel(double side) {
    Points x;
    for (double s = -100.0; s <= 99.0; s += 1.0) x.emplace_back(s, 0.0, side * 0.5 * TUCK_GAP);
    x.emplace_back(100.0, 0.0, 0.0);
    for (double s = -100.0; s <= 100.0; s += 1.0) {  // so that the cloth has a width
        x.emplace_back(s, -50.0, 0.0);
        x.emplace_back(s, 50.0, 0.0);
    }
    return x;
}

Tuck tuck_at(double line) {
    Tuck f;
    f.line = line;
    f.name = "a tuck";
    choose_bands(f, panel(1.0), TUCK_GAP, 8.0);
    return f;
}

std::string rectangle(const std::string& folds) {
    return "[pattern]\nkind = \"rectangle\"\nlength = 400\nwidth = 300\nelement = 12\ngap = 0.8\n" +
           folds;
}
std::string disc(const std::string& folds) {
    return "[pattern]\nkind = \"disc\"\ndiameter = 400\nelement = 12\ngap = 0.8\n" + folds;
}

}  // namespace

TEST_CASE("a tuck lies between the panels, which it opens", "[fold]") {
    const Tuck f = tuck_at(60.0);
    for (const double side : {1.0, -1.0}) {
        Points x = panel(side);
        apply(f, TUCK_GAP, x);
        const auto at = [&](double s) { return x[static_cast<std::size_t>(s + 100.0)]; };
        CHECK(at(0.0) == Vec3(0.0, 0.0, 0.5 * side));  // before the ramp nothing moves
        const double drawn = 40.0 - at(40.0).x();
        CHECK(drawn > 0.0);
        CHECK(drawn < 0.13);                                               // what the panels climb
        CHECK(at(40.0).z() == Approx(1.5 * side));                         // opened
        CHECK(at(60.0).z() == Approx(1.0 * side));                         // the bend
        CHECK(at(80.0).x() == Approx(at(40.0).x()));                       // mirrored
        CHECK(at(80.0).z() == Approx(0.5 * side));                         // inside
        CHECK((at(100.0) - Vec3(20.0 - drawn, 0.0, 0.0)).norm() < 1e-12);  // the seam
    }
}

TEST_CASE("a tuck stretches nothing", "[fold]") {
    Points x = panel(1.0);
    const Points flat = x;
    apply(tuck_at(60.0), TUCK_GAP, x);
    double length = 0.0;
    for (std::size_t n = 0; n < 200; ++n) {
        CHECK((x[n + 1] - x[n]).norm() < (flat[n + 1] - flat[n]).norm() + 1e-12);
        length += (x[n + 1] - x[n]).norm();
    }
    CHECK(length == Approx(199.0 + std::hypot(1.0, 0.5)).epsilon(1e-9));
}

TEST_CASE("a tuck knows what comes to lie where", "[fold]") {
    const Tuck f = tuck_at(60.0);
    for (const double s : {-50.0, 3.0, 30.0, 45.0, 75.0, 90.0}) {
        Points x = panel(1.0);
        x.emplace_back(s, 0.0, 0.5);
        apply(f, TUCK_GAP, x);
        const auto found = before(f, TUCK_GAP, x.back().x());
        const bool is_known = std::any_of(found.begin(), found.end(),
                                          [&](double v) { return std::abs(v - s) < 1e-9; });
        CHECK(is_known);
        for (const double v : found) {
            Points y = panel(1.0);
            y.emplace_back(v, 0.0, 0.5);
            apply(f, TUCK_GAP, y);
            CHECK(y.back().x() == Approx(x.back().x()));
        }
    }
}

TEST_CASE("tucks do not cross, whatever they are combined with", "[fold]") {
    const std::string both = "[[fold]]\nkind = \"tuck\"\nside = \"both\"\nat = 130\n";
    const std::string across =
        "[[fold]]\nkind = \"zigzag\"\nside = \"both\"\nangle = 90\nstart = 40\n"
        "width = 45\n";
    const std::string along =
        "[[fold]]\nkind = \"zigzag\"\nside = \"both\"\nstart = 40\nwidth = 60\n";
    const std::string oblique =
        "[[fold]]\nkind = \"tuck\"\nangle = 30\nat = 120\n"
        "[[fold]]\nkind = \"half\"\nangle = -20\n";
    const std::string left =
        "[[fold]]\nkind = \"tuck\"\nside = \"left\"\nat = 150\n"
        "[[fold]]\nkind = \"roll\"\nstart = 120\nwidth = 45\ncount = 2\n";
    const std::string text =
        GENERATE_COPY(disc(both), rectangle(both), disc(both + across), rectangle(both + across),
                      disc(both + along), rectangle(both + along), disc(oblique),
                      rectangle(oblique), disc(left), rectangle(left));
    INFO(text);
    const Bag bag = fold::fold(parse_recipe(text, "tuck.toml"));
    const Inspection found = inspect(bag, 0.0);
    CHECK(found.crossings.empty());
    CHECK(found.layers >= 4);
    CHECK(found.greatest_strain < 0.06);
}

TEST_CASE("pleats that a coarse mesh does not reach any more are left flat", "[fold]") {
    const std::string across =
        "[[fold]]\nkind = \"tuck\"\nside = \"both\"\nat = 190\n"
        "[[fold]]\nkind = \"zigzag\"\nside = \"both\"\nangle = 90\nstart = 60\nwidth = ";
    const std::string width = GENERATE("60", "48", "80");
    const std::string text =
        "[pattern]\nkind = \"disc\"\ndiameter = 600\nelement = 30\ngap = 0.7\n" + across + width +
        "\n";
    INFO(text);
    const Bag bag = fold::fold(parse_recipe(text, "tuck.toml"));
    const Inspection found = inspect(bag, 0.0);
    CHECK(found.crossings.empty());
    CHECK(found.greatest_strain < 0.06);
}

TEST_CASE("tucks that cannot be are refused", "[fold]") {
    const auto fault = [&](const std::string& folds) {
        try {
            static_cast<void>(fold::fold(parse_recipe(disc(folds), "b.toml")));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto has = [](const std::string& what, const char* part) {
        INFO(what);
        return what.find(part) != std::string::npos;
    };
    const std::string tuck = "[[fold]]\nkind = \"tuck\"\nat = ";
    CHECK(has(fault(tuck + "250\n"), "where there is cloth on both sides"));
    CHECK(has(fault(tuck + "190\n"), "expected at least 24, two elements"));
    CHECK(has(fault(tuck + "-20\n"), "make it less deep"));
    CHECK(has(fault(tuck + "90\nside = \"both\"\n"), "make it less deep"));
    CHECK(has(fault("[[fold]]\nkind = \"half\"\nat = 60\n" + tuck + "30\n"),
              "expected the two panels"));
    CHECK(has(fault(tuck + "100\nonto = \"back\"\n"), "a tuck lies between the panels"));
    CHECK(has(fault("[[tether]]\nfrom = [50, 0]\nlength = 80\nwidth = 30\n" + tuck + "140\n"),
              "clear of tethers"));
}
