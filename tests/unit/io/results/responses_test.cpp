// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <numbers>

#include "io/responses/body_responses.hpp"
#include "io/responses/channel_filter.hpp"
#include "io/responses/criteria.hpp"
#include "io/results/rigid_history.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using Catch::Detail::Approx;

namespace {

std::vector<double> sampled(double dt, double length, auto&& f) {
    std::vector<double> a;
    for (double k = 0; k * dt <= length * (1.0 + 1e-12); ++k) a.push_back(f(k * dt));
    return a;
}

/// Amplitude that the filter leaves of a unit sine, from its middle half.
double gain(double frequency, double cfc, double dt) {
    const double w = 2.0 * std::numbers::pi * frequency, length = 60.0 / frequency;
    const auto y =
        io::filtered(sampled(dt, length, [&](double t) { return std::sin(w * t); }), dt, cfc);
    double c = 0.0, s = 0.0;
    const std::size_t a = y.size() / 4, b = a + y.size() / 2;
    for (std::size_t k = a; k < b; ++k) {
        const double t = static_cast<double>(k) * dt;
        c += y[k] * std::cos(w * t);
        s += y[k] * std::sin(w * t);
    }
    return 2.0 * std::hypot(c, s) / static_cast<double>(b - a);
}

/// A body of 2 kg in SI that flies at 5 m/s along x and is stopped and sent back by a half sine of
/// force from 4 ms on, 10 ms long, at 100 kHz.
struct Impact {
    static constexpr double DT = 1e-5, PEAK = 3000.0, LONG = 0.01, FROM = 0.004;
    io::BodyMotion motion{20, 2.0, DT, {}, {}, {}, {}};
    Impact() {
        Vec3 x(0.1, 0.2, 0.3), v(5, 0, 0);
        const auto impulse = [](double t) {  // since the start of the pulse
            t = std::clamp(t - FROM, 0.0, LONG);
            return PEAK * LONG / std::numbers::pi * (1.0 - std::cos(std::numbers::pi * t / LONG));
        };
        for (int k = 0; k <= 2000; ++k) {
            const double t = k * DT;
            const double j = k == 0 ? 0.0 : impulse(t) - impulse(t - DT);
            const Vec3 before = v;
            v.x() -= j / motion.mass;
            x += 0.5 * DT * (before + v) * (k > 0);
            motion.position.push_back(x);
            motion.velocity.push_back(v);
            motion.acceleration.push_back((v - before) / DT);
            motion.force.emplace_back(-j / DT, 0, 0);
        }
    }
};

std::map<std::string, io::Response> by_name(const std::vector<io::Response>& all) {
    std::map<std::string, io::Response> out;
    for (const io::Response& r : all) out.emplace(r.name, r);
    return out;
}

}  // namespace

TEST_CASE("a channel filter's gain is -3 dB at CFC/0.6 within 1 % of the frequency",
          "[responses]") {
    const double cfc = GENERATE(60.0, 180.0, 600.0, 1000.0);
    const double dt = GENERATE(1e-5, 3.9e-5);
    const double corner = cfc / 0.6, level = std::pow(10.0, -3.0 / 20.0);
    CHECK(gain(0.99 * corner, cfc, dt) > level);
    CHECK(gain(1.01 * corner, cfc, dt) < level);
    CHECK(gain(0.1 * corner, cfc, dt) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("a channel filter passes straight lines, has no delay, and keeps the mean",
          "[responses]") {
    const auto line = [](double t) { return 3.0 - 200.0 * t; };
    const auto ramp = sampled(1e-5, 0.02, line);
    const auto y = io::filtered(ramp, 1e-5, 180.0);
    for (std::size_t k = 0; k < y.size(); ++k) REQUIRE(y[k] == Approx(ramp[k]).margin(1e-9));

    const auto bump =
        sampled(1e-5, 0.04, [](double t) { return std::exp(-std::pow((t - 0.02) / 1e-3, 2)); });
    const auto smooth = io::filtered(bump, 1e-5, 180.0);
    for (std::size_t k = 0; k < smooth.size(); ++k)
        REQUIRE(smooth[k] == Approx(smooth[smooth.size() - 1 - k]).margin(1e-9));
}

TEST_CASE("a rate too low for a filter is refused, not aliased", "[responses]") {
    const std::vector<double> a(100, 1.0);
    CHECK_NOTHROW(io::filtered(a, 1.0 / 25000.0, 1000.0));
    CHECK_THROWS_AS(io::filtered(a, 1.0 / 24900.0, 1000.0), InputError);
    CHECK_NOTHROW(io::filtered(a, 1.0 / 24900.0, 600.0));
}

TEST_CASE("HIC of the check pulses", "[responses]") {
    const double dt = 1e-5;
    SECTION("half sine, 100 g, 10 ms: 0.4146 A^2.5 T") {
        const auto a = sampled(dt, 0.04, [](double t) {
            return t > 0.005 && t < 0.015 ? 100.0 * std::sin(std::numbers::pi * (t - 0.005) / 0.01)
                                          : 0.0;
        });
        const io::HeadInjury worst = io::head_injury(a, dt, 0.015);
        CHECK(worst.value == Approx(414.6).epsilon(1e-3));
        CHECK(worst.begin + worst.end == Approx(0.02).margin(2e-5));  // about the middle
        CHECK(io::head_injury(a, dt, 0.036).value == worst.value);
    }
    SECTION("rectangle, 80 g, 20 ms") {
        const auto a = sampled(dt, 0.02, [](double) { return 80.0; });
        CHECK(io::head_injury(a, dt, 0.015).value == Approx(858.65).epsilon(1e-5));
        CHECK(io::head_injury(a, dt, 0.036).value == Approx(1144.87).epsilon(1e-4));
    }
}

TEST_CASE("3 ms clip: triangles have exact levels", "[responses]") {
    const double dt = 1e-5;
    // peak 100 at the middle of 10 ms: above L for 10 ms (1 - L/100)
    const auto hat = [](double t, double from) {
        return std::max(0.0, 100.0 - std::abs(t - from - 0.005) / 0.005 * 100.0);
    };
    const auto one = sampled(dt, 0.03, [&](double t) { return hat(t, 0.00033); });
    CHECK(io::clip(one, dt, 3e-3, io::Clip::CONTIGUOUS) == Approx(70.0).epsilon(1e-9));
    CHECK(io::clip(one, dt, 3e-3, io::Clip::CUMULATIVE) == Approx(70.0).epsilon(1e-9));
    const auto two = sampled(dt, 0.03, [&](double t) { return hat(t, 0.0) + hat(t, 0.012); });
    CHECK(io::clip(two, dt, 3e-3, io::Clip::CONTIGUOUS) == Approx(70.0).epsilon(1e-9));
    CHECK(io::clip(two, dt, 3e-3, io::Clip::CUMULATIVE) == Approx(85.0).epsilon(1e-9));
    CHECK(io::clip(std::vector<double>(100, 5.0), dt, 3e-3, io::Clip::CONTIGUOUS) == 0.0);
}

TEST_CASE("responses of a hand-made impact", "[responses]") {
    const Impact impact;
    auto r = by_name(io::body_responses(impact.motion, "SI"));
    const double J = 2.0 * Impact::PEAK * Impact::LONG / std::numbers::pi, v_end = 5.0 - J / 2.0;
    CHECK(r.at("peak_force").value == Approx(3.0).epsilon(1e-5));
    CHECK(r.at("peak_force_cfc1000").value == Approx(3.0).epsilon(1e-3));
    CHECK(r.at("peak_force_cfc60").value < 2.99);
    CHECK(r.at("peak_acceleration").value == Approx(1500.0 / 9.80665).epsilon(1e-5));
    CHECK(r.at("peak_acceleration_cfc1000").value == Approx(1500.0 / 9.80665).epsilon(1e-3));
    CHECK(r.at("impulse").value == Approx(J).epsilon(1e-9));
    CHECK(r.at("impulse").value == Approx(2.0 * (5.0 - v_end)).epsilon(1e-9));
    CHECK(r.at("rebound_velocity").value == Approx(-v_end).epsilon(1e-9));
    CHECK(r.at("energy_absorbed").value == Approx(25.0 - v_end * v_end).epsilon(1e-9));
    CHECK(r.at("greatest_energy_absorbed").value == Approx(25.0).epsilon(1e-4));
    CHECK(r.at("time_to_contact").value == Approx(4.0).margin(1e-9));
    // it stops where 5 = PEAK T / (pi m) (1 - cos(pi s / T)), having gone 5 s - PEAK T / (pi m) (s
    // - T/pi sin)
    const double c = Impact::PEAK * Impact::LONG / std::numbers::pi / 2.0;
    const double s = Impact::LONG / std::numbers::pi * std::acos(1.0 - 5.0 / c);
    const double way = 5.0 * s - c * (s - Impact::LONG / std::numbers::pi *
                                              std::sin(std::numbers::pi * s / Impact::LONG));
    CHECK(r.at("greatest_intrusion").value == Approx(1e3 * way).epsilon(2e-3));
    CHECK(r.at("hic15").value ==
          Approx(0.4146 * std::pow(1500.0 / 9.80665, 2.5) * 0.01).epsilon(2e-3));
    CHECK(r.at("hic15").unit == "g^2.5 s");
    CHECK(r.at("peak_force").unit == "kN");
    CHECK(r.at("impulse").unit == "N s");
    CHECK(r.at("greatest_intrusion").unit == "mm");
}

TEST_CASE("responses do not depend on the deck's units", "[responses]") {
    const auto si = by_name(io::body_responses(Impact().motion, "SI"));
    Impact other;
    other.motion.interval *= 1e3;
    for (Vec3& x : other.motion.position) x *= 1e3;
    for (Vec3& a : other.motion.acceleration) a *= 1e-3;
    for (Vec3& f : other.motion.force) f *= 1e-3;
    auto mm = by_name(io::body_responses(other.motion, "kg-mm-ms-K"));
    CHECK(mm.size() == si.size());
    for (const auto& [name, response] : si) {
        CAPTURE(name);
        CHECK(mm.at(name).value == Approx(response.value).epsilon(1e-9));
        CHECK(mm.at(name).unit == response.unit);
    }
}

TEST_CASE("what cannot be told says why", "[responses]") {
    SECTION("unknown units") {
        const auto r = by_name(io::body_responses(Impact().motion, "consistent"));
        CHECK(std::isnan(r.at("hic15").value));
        CHECK(r.at("hic15").note == "the deck's units are unknown");
        CHECK(std::isfinite(r.at("impulse").value));
    }
    SECTION("a slow rate") {
        Impact impact;
        impact.motion.interval = 1e-3;
        const auto r = by_name(io::body_responses(impact.motion, "SI"));
        CHECK(std::isnan(r.at("peak_acceleration_cfc60").value));
        CHECK(r.at("peak_acceleration_cfc60").note.find("aliased") != std::string::npos);
    }
    SECTION("no contact") {
        Impact impact;
        for (Vec3& f : impact.motion.force) f.setZero();
        const auto r = by_name(io::body_responses(impact.motion, "SI"));
        CHECK(std::isnan(r.at("time_to_contact").value));
        CHECK(r.at("time_to_contact").note == "no contact");
        CHECK(r.at("impulse").value == 0.0);
    }
}

TEST_CASE("the uniform history of uneven steps keeps impulse, velocity and place", "[responses]") {
    const double mass = 3.0, interval = 0.01;
    const Vec3 v_0(2, 0, -1), x_0(1, 2, 3);
    io::RigidHistory history(interval, {{7, mass, x_0, v_0}});
    const auto force = [](double t) { return Vec3(40.0 * std::sin(9.0 * t), -5.0, 7.0 * t); };
    double t = 0.0, dt_last = 0.0;
    Vec3 x = x_0, v = v_0;
    for (int n = 0;; ++n) {
        const bool at_end = n == 180;
        const double dt = at_end ? dt_last : n % 7 == 0 ? 0.023 : 0.0007 * (1 + n % 5);
        v += 0.5 * (dt_last + dt) * force(t) / mass;
        history.observe(t, {{x, v, force(t)}}, at_end);
        if (at_end) break;
        x += dt * v;
        t += dt;
        dt_last = dt;
    }
    const io::BodyMotion motion = history.motions().at(0);
    REQUIRE(motion.velocity.size() == static_cast<std::size_t>(t / interval) + 1);
    Vec3 impulse = Vec3::Zero();
    for (std::size_t k = 1; k < motion.velocity.size(); ++k) {
        impulse += interval * motion.force[k];
        REQUIRE((mass * (motion.velocity[k] - v_0) - impulse).norm() < 1e-12 * impulse.norm());
        REQUIRE((mass * motion.acceleration[k] - motion.force[k]).norm() < 1e-9);
        // exact: m v_x = m v_0 + 40/9 (1 - cos 9 t), to the second order in the step
        const double at = static_cast<double>(k) * interval;
        CHECK(motion.velocity[k].x() ==
              Approx(2.0 + 40.0 / 9.0 / mass * (1.0 - std::cos(9.0 * at))).margin(0.02));
        CHECK(motion.position[k].y() == Approx(2.0 - 0.5 * 5.0 / mass * at * at).margin(0.002));
    }
}

TEST_CASE("results hold the followed bodies and, finished, their responses", "[responses]") {
    const scene::Folder folder("responses");
    io::ResultsFile results(folder.path, scene::info(), scene::layout());
    results.follow(0.01, {{20, 4.5, Vec3(1, 2, 3), Vec3(10, 0, 0)}});
    for (int n = 0; n <= 400; ++n)
        results.observe(0.005 * n, {{Vec3(1, 2, 3), Vec3(10 - 0.01 * n, 0, 0), Vec3(-9, 0, 0)}},
                        n == 400);
    results.finish("normal");

    const io::Hdf5Reader file(folder.path / "results.h5");
    REQUIRE(io::tracked_bodies(file) == std::vector<int>{20});
    const io::BodyMotion motion = io::read_motion(file, 20);
    CHECK(motion.mass == 4.5);
    CHECK(motion.interval == 0.01);
    CHECK(motion.velocity.size() == 201);
    CHECK(file.read<double>("/responses/20/peak_force").at(0) == Approx(9.0));
    CHECK(file.text("/responses/20/peak_force", "unit") == "kN");
    CHECK(file.text("/responses/20/hic15", "description").find("CFC 1000") != std::string::npos);
}

TEST_CASE("a body's rate is 100 kHz in every unit system, and its rows are bounded",
          "[responses]") {
    CHECK(io::rigid_interval("SI", 0.03) == Approx(1e-5));
    CHECK(io::rigid_interval("kg-mm-ms-K", 30.0) == Approx(1e-2));
    CHECK(io::rigid_interval("ton-mm-s-K", 0.03) == Approx(1e-5));
    CHECK(io::rigid_interval("consistent", 50.0) == Approx(1e-2));
    CHECK(io::rigid_interval("SI", 1000.0) == Approx(5e-3));
}

TEST_CASE("a history goes on at its own interval where another end time gives another",
          "[responses]") {
    const std::vector<io::RigidTrack> tracks{{7, 3.0, Vec3::Zero(), Vec3(1, 0, 0)}};
    const auto observe = [](io::RigidHistory& history, int n) {
        history.observe(0.01 * n, {{Vec3(0.01 * n, 0, 0), Vec3(1, 0, 0), Vec3::Zero()}}, false);
    };
    io::RigidHistory first(0.02, tracks), second(0.05, tracks);
    for (int n = 0; n < 20; ++n) observe(first, n);
    StateWriter to;
    to(first);
    StateReader from(to.bytes());
    from(second);
    for (int n = 20; n < 40; ++n) {
        observe(first, n);
        observe(second, n);
    }
    CHECK(second.rows() == first.rows());
    CHECK(second.motions()[0].interval == 0.02);
    CHECK(second.motions()[0].position.back().x() == Approx(0.38));
}
