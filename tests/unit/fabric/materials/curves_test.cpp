// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include <functional>
#include <random>

#include "fabric/materials/law.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/fabric/curves_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;
using namespace curves_setup;

TEST_CASE("a curve is followed, mirrored or straight below 0, and straight beyond its end",
          "[fabric][curves]") {
    const StressCurve warp(CURVES[0], Below::STRAIGHT), none(CURVES[1], Below::NOTHING),
        given(CURVES[1], Below::STRAIGHT), shear(CURVES[2], Below::MIRRORED);
    CHECK(warp.at(0.06).stress == Approx(12e6));
    CHECK(warp.at(-0.01).stress == Approx(-1e6));
    CHECK(warp.at(0.4).stress == Approx(124e6));
    CHECK(none.at(-0.1).stress == 0.0);
    CHECK(given.at(-0.1).stress == Approx(-0.5e6));
    CHECK(shear.at(-0.4).stress == Approx(-shear.at(0.4).stress).epsilon(1e-12));
    CHECK(shear.at(-0.4).energy == Approx(shear.at(0.4).energy));
    CHECK(warp.at(0.0).energy == 0.0);
    for (const double e : {-0.05, 0.01, 0.07, 0.2, 0.5})
        CHECK((warp.at(e + 1e-7).energy - warp.at(e - 1e-7).energy) / 2e-7 ==
              Approx(warp.at(e).stress).epsilon(1e-6));
    CHECK(warp.steepest() == Approx(340e6));
}

TEST_CASE("work is what is stored and what is lost, on any path of a loop", "[fabric][curves]") {
    const double reload = GENERATE(0.0, 0.4, 1.0);
    const LoadingLoop loop = warp_loop(reload);
    REQUIRE(loop.fault().empty());
    LoopMemory memory;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> target(-0.05, 0.35);
    double e = 0.0, work = 0.0, lost = 0.0, stress = 0.0, stored = 0.0;
    for (int leg = 0; leg < 40; ++leg) {
        const double from = e, to = target(random);
        const int steps = 4000;
        double worst = 0.0;
        for (int i = 1; i <= steps; ++i) {
            const double next = from + (to - from) * i / steps;
            const LoadingLoop::Answer a = loop.move(next, memory);
            worst = std::min(worst, a.lost);
            work += 0.5 * (stress + a.stress) * (next - e);
            lost += a.lost;
            stress = a.stress;
            stored = a.stored;
            e = next;
        }
        CHECK(worst >= -1e-6);  // of some 1e6
        CHECK(work == Approx(stored + lost).epsilon(2e-4).margin(50));
        const LoopMemory before = memory;
        CHECK(loop.move(e, memory).lost == 0.0);
        CHECK((memory.most == before.most && memory.back == before.back));
    }
    CHECK(lost > 0.0);
}

TEST_CASE("unloading meets the curve that the card gives, stretched to where it began",
          "[fabric][curves]") {
    const LoadingLoop loop = warp_loop(0.0);
    LoopMemory memory;
    CHECK(loop.move(0.3, memory).stress == Approx(90e6));
    CHECK(loop.move(0.25, memory).stress == Approx(50e6));
    CHECK(loop.move(0.1, memory).stress == Approx(2e6));
    CHECK(loop.move(0.3, memory).stress == Approx(90e6));
    CHECK(loop.move(-0.01, memory).stress == Approx(-1e6));
    LoopMemory half;
    const double most = loop.move(0.15, half).stress;
    CHECK(most == Approx(39e6));
    CHECK(loop.move(0.05, half).stress == Approx(9.5e6 * 2.0 / 22.0));  // U/L at a third of the way
    // RL = 1 comes back along the chord
    const LoadingLoop chord = warp_loop(1.0);
    LoopMemory other;
    static_cast<void>(chord.move(0.3, other));
    static_cast<void>(chord.move(0.1, other));
    CHECK(chord.move(0.2, other).stress == Approx(46e6));
}

TEST_CASE("curves that cannot be, or that would give energy, are named", "[fabric][curves]") {
    const auto faults = [](Curve load, Curve unload, double reload) {
        FabricCard c = curved_card(14, false, reload);
        c.curves.load = {0, -1, -1};
        c.curves.unload = {1, -1, -1};
        return curve_faults(c, std::vector<Curve>{std::move(load), std::move(unload)});
    };
    const Curve line{1, {0, 0.3}, {0, 30e6}}, low{2, {0, 0.2, 0.3}, {0, 5e6, 30e6}};
    CHECK(faults(line, low, 1.0).empty());
    const CurveFault above = faults(line, {2, {0, 0.1, 0.3}, {0, 20e6, 30e6}}, 0.0).at(0);
    CHECK(above.direction == 0);
    CHECK(above.unloads);
    // A share of loading that falls as it goes on: 0.95 at a third, 0.3 at two thirds
    CHECK(faults(line, {2, {0, 0.1, 0.29, 0.3}, {0, 9.5e6, 9.6e6, 9.7e6}}, 0.0).size() == 1);
    CHECK(faults(line, {2, {0, 0.1, 0.29, 0.3}, {0, 2e6, 9.6e6, 30e6}}, 0.0).empty());
    CHECK(faults(line, {2, {0, 0.1, 0.2, 0.3}, {0, 1e6, 19e6, 30e6}}, 0.0).empty());
    CHECK_FALSE(faults({1, {0, 0.1, 0.1}, {0, 1e6, 2e6}}, low, 0.0).at(0).unloads);
    CHECK(faults({1, {0, 0.1}, {1e6, 2e6}}, low, 0.0).size() == 1);
    CHECK(faults({1, {0, 0.1, 0.2}, {0, 2e6, 1e6}}, low, 0.0).size() == 1);
    CHECK_THROWS_AS(
        make_law({3, "", curved_card(4, false)}, std::vector<Curve>(6, Curve{1, {0, 1}, {0, -1}})),
        InputError);
}

TEST_CASE("a card with curves picks its law, and one without pays nothing", "[fabric][curves]") {
    const auto law = [](int form, bool unloads) {
        return make_law({1, "", curved_card(form, unloads)}, CURVES).law;
    };
    CHECK(std::get<Curved>(law(4, false)).measure() == YarnMeasure::GREEN);
    CHECK(std::get<Curved>(law(14, false)).measure() == YarnMeasure::ENGINEERING);
    CHECK(std::get<Looped>(law(4, true)).measure() == YarnMeasure::GREEN);
    CHECK(std::get<Looped>(law(14, true)).measure() == YarnMeasure::ENGINEERING);
    FabricCard plain = fabric_card();
    plain.form = 14;
    CHECK(std::holds_alternative<Linear>(make_law({1, "", plain}, CURVES).law));
}

TEST_CASE("with curves the force is the energy's slope", "[fabric][curves]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const int form = GENERATE(4, 14);
    const bool no_compression = GENERATE(false, true);
    const double amount = GENERATE(0.003, 0.03, 0.3);
    FabricCard card = curved_card(form, false);
    card.no_compression = no_compression;
    card.liner_E = 10e6;
    card.liner_ratio = 0.1;
    Sheet sheet = sheet_of(card, mesh);
    Membranes membranes = sheet.membranes();
    const Points x = plus(sheet.x, noise(sheet.x.size(), amount, 3));
    const Points f = force(membranes, x);
    const double step = 1e-8, scale = greatest(f);
    for (std::size_t n = 0; n < x.size(); n += 3)
        for (int i = 0; i < 3; ++i) {
            Points ahead = x, back = x;
            ahead[n][i] += step;
            back[n][i] -= step;
            force(membranes, ahead);
            const double more = membranes.strain_energy();
            force(membranes, back);
            const double slope = (more - membranes.strain_energy()) / (2.0 * step);
            CHECK(-slope == Approx(f[n][i]).margin(3e-5 * scale));
        }
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t n = 0; n < x.size(); ++n) {
        sum += f[n];
        moment += x[n].cross(f[n]);
    }
    CHECK(sum.norm() < 1e-12 * scale);
    CHECK(moment.norm() < 1e-12 * scale);
}

TEST_CASE("with curves a rigid motion stores nothing, and crushed elements stay finite",
          "[fabric][curves]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const int form = GENERATE(4, 14);
    const bool unloads = GENERATE(false, true);
    Sheet sheet = sheet_of(curved_card(form, unloads), mesh);
    Membranes membranes = sheet.membranes();
    const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    CHECK(greatest(force(membranes, moved(sheet.x, [&](const Vec3& p) {
                             return Vec3(turn * p + Vec3(3, 1, -2));
                         }))) < 1e-13 * 300e6 * 0.3e-3);
    CHECK(membranes.strain_energy() < 1e-20);
    const std::function<Vec3(const Vec3&)> maps[] = {
        [](const Vec3&) { return Vec3(1, 1, 1); },
        [](const Vec3& p) { return Vec3(p.x() + p.y(), 0, 0); },
        [](const Vec3& p) { return Vec3(-p.x(), p.y(), 0); },
        [](const Vec3& p) { return Vec3(std::abs(p.x() - 0.2), p.y(), 0); }};
    CAPTURE(form, unloads);
    for (const auto& map : maps) {
        Points f = zeros(sheet.x.size());
        CHECK(membranes.add_force(moved(sheet.x, map), zeros(f.size()), f) == -1);
        CHECK(std::isfinite(membranes.stable_step().dt));
        CHECK(greatest(f) < 1e9 * 0.3e-3);
    }
    Points x = sheet.x, f = zeros(x.size());
    x[3].x() = NaN;
    CHECK(membranes.add_force(x, zeros(x.size()), f) >= 0);
    // What was not finite is not remembered
    f = zeros(x.size());
    CHECK(membranes.add_force(sheet.x, zeros(x.size()), f) == -1);
    CHECK(std::isfinite(membranes.lost_energy()));
}

TEST_CASE("pulls and a picture frame meet the curves as their form reads them",
          "[fabric][curves]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const int form = GENERATE(4, 14);
    FabricCard card = curved_card(form, false);
    card.axes = 2;
    Sheet sheet = rectangle(card, mesh, 4, 3, 0.4, 0.3);
    sheet.curves = CURVES;
    Membranes membranes = sheet.membranes();
    const double h = 0.3e-3;
    const auto right = [&](const Points& x) {
        const Points f = force(membranes, x);
        Vec3 sum = Vec3::Zero();
        for (std::size_t n = 0; n < x.size(); ++n)
            if (sheet.x[n].x() > 0.4 - 1e-9) sum -= f[n];
        return sum;
    };
    const double l = GENERATE(1.03, 1.15);
    const Vec3 pull =
        right(moved(sheet.x, [&](const Vec3& p) { return Vec3(l * p.x(), p.y(), 0); }));
    const StressCurve warp(CURVES[0], Below::STRAIGHT);
    const double expected =
        form == 4 ? l * warp.at(0.5 * (l * l - 1)).stress : warp.at(l - 1).stress;
    CHECK(pull.x() == Approx(expected * h * 0.3).epsilon(1e-9));
    CHECK(std::abs(pull.y()) < 1e-9 * pull.x());

    // Frame: both yarns keep their length; the force along the side that turns works on γ
    const double gamma = GENERATE(0.1, 0.5, 0.9);
    const Vec3 frame = right(moved(sheet.x, [&](const Vec3& p) {
        return Vec3(p.x() + std::sin(gamma) * p.y(), std::cos(gamma) * p.y(), 0);
    }));
    const StressCurve shear(CURVES[2], Below::MIRRORED);
    const Vec3 other(std::sin(gamma), std::cos(gamma), 0), across(0, 1, 0);
    // Power per angle of the side that turns against the first: f · d g1
    const double moment =
        form == 4 ? shear.at(std::sin(gamma)).stress * std::cos(gamma) : shear.at(gamma).stress;
    CHECK(frame.dot(across) == Approx(moment * h * 0.3).epsilon(1e-9));
    if (form == 4) CHECK(frame.cross(other).norm() < 1e-9 * frame.norm());
    if (form == 14) CHECK(std::abs(frame.x()) < 1e-9 * frame.norm());  // no pull along the yarns
}
