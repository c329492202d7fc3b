// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "io/results/ascii_files.hpp"
#include "io/results/ascii_tables.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_ascii_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using namespace results_ascii_setup;

TEST_CASE("a number keeps its column whatever its exponent", "[io]") {
    const double value = GENERATE(0.0, 1.0, -1.0, 1.2345678e-100, -1.2345678e-100, -9.999999e299);
    CHECK(io::field(value, 12, 5).size() == 12);
    CHECK(std::stod(io::field(value, 12, 5)) == Approx(value).epsilon(1e-3));
}

TEST_CASE("abstat has the bag's numbers in LS-DYNA's columns", "[io]") {
    const RecordLayout layout = scene::layout();
    const Sample s = scene::sample(layout, 3);
    Sample before = s;  // the first bag is of particles, the second of uniform pressure
    before.time -= 0.5;
    for (AirbagSample& bag : before.airbags) {
        bag.mass_in -= 1.5;
        bag.mass_out_vent -= 0.25;
        bag.mass_out_fabric -= 1.0;
    }
    const auto rows = lines(io::abstat_state(layout, s, before));
    REQUIRE(rows.size() == 5);
    CHECK(rows[0].empty());
    CHECK(rows[1].empty());
    CHECK(rows[2].find("airbag/cv #") != std::string::npos);
    for (std::size_t i = 0; i < 2; ++i) {
        const AirbagSample& b = s.airbags[i];
        check_near(cut(rows[3 + i], {12, 8, 15, 15, 15, 15, 15, 11, 11, 11, 11, 11}),
                   {1.5, i == 0 ? 7.0 : 9.0, b.volume, b.pressure, b.energy,
                    i == 0 ? 3.0 : b.mass_rate_in, b.mass / b.volume,
                    i == 0 ? 2.5 : b.mass_rate_out, b.mass, b.temperature, b.surface_area, 0.0});
    }
    const auto first = lines(io::abstat_state(layout, s, s));
    CHECK(cut(first[3], {12, 8, 15, 15, 15, 15, 15, 11, 11, 11, 11, 11})[5] == 0.0);
}

TEST_CASE("abstat_cpm has the rows of the bags of particles alone", "[io]") {
    const RecordLayout layout = scene::layout();  // the second bag is of uniform pressure
    const Sample s = scene::sample(layout, 3);
    const auto all = lines(io::abstat_state(layout, s, s)),
               rows = lines(io::abstat_cpm_state(layout, s, s));
    REQUIRE(rows.size() == 4);
    for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i] == all[i]);
}

TEST_CASE("cpm_sensor: heading of its own, then the time and three lines a sensor", "[io]") {
    RecordLayout layout = scene::layout();
    layout.sensors = 2;
    Sample s = scene::sample(layout, 3);
    s.sensors = {{120.0, 1.1e5, 320.0, 1.2, Vec3(3, -4, 12), Vec3(0.1, -0.2, 0.3)},
                 {0.0, 0.0, 0.0, 0.0, Vec3::Zero(), Vec3(-1, 2, -3)}};
    const auto heading = lines(io::cpm_sensor_heading(layout)),
               rows = lines(io::cpm_sensor_state(s));
    REQUIRE(heading.size() == 8);
    check_near(cut(heading[1], {5, 5}), {2, 16});
    CHECK(heading[5] == "         pres         dens         temp        npart");
    REQUIRE(rows.size() == 1 + 2 * 3);
    check_near(cut(rows[0], {13}), {1.5});
    check_near(cut(rows[1], {13, 13, 13}), {0.1, -0.2, 0.3});
    check_near(cut(rows[2], {13, 13, 13, 13}), {3, -4, 12, 13});
    check_near(cut(rows[3], {13, 13, 13, 13}), {1.1e5, 1.2, 320, 120});
    check_near(cut(rows[4], {13, 13, 13}), {-1, 2, -3});
    check_near(cut(rows[6], {13, 13, 13, 13}), {0, 0, 0, 0});
}

TEST_CASE("matsum has each part's energies and momentum and the mean velocity of its mass",
          "[io]") {
    const RecordLayout layout = scene::layout();
    const Sample s = scene::sample(layout, 3);
    const auto rows = lines(io::matsum_state(layout, s));
    REQUIRE(rows.size() == 3 + 4 * 3);
    CHECK(rows[2].substr(0, 7) == " time =");
    CHECK(std::stod(rows[2].substr(7, 13)) == Approx(1.5));
    const auto number = [](const std::string& row, const std::string& name) {
        const std::size_t at = row.find(name);
        REQUIRE(at != std::string::npos);
        return std::stod(row.substr(at + name.size(), 13));
    };
    for (std::size_t p = 0; p < 3; ++p) {
        const std::string* row = &rows[3 + 4 * p];
        CHECK(row[0].substr(0, 7) == " mat.#=");
        CHECK(std::stoi(row[0].substr(7, 8)) == layout.parts[p]);
        CHECK(row[0].find("inten=") == 25);
        CHECK(row[0].find("kinen=") == 49);
        CHECK(number(row[0], "inten=") == Approx(s.parts[p].strain_energy).epsilon(1e-4));
        CHECK(number(row[0], "kinen=") == Approx(s.parts[p].kinetic_energy).epsilon(1e-4));
        for (const int axis : {0, 1, 2}) {
            const std::string name = std::string(1, "xyz"[axis]);
            const double momentum = s.parts[p].momentum[axis], mass = layout.part_mass[p];
            CHECK(row[1].find(name + "-mom=") == static_cast<std::size_t>(1 + 24 * axis));
            CHECK(number(row[1], name + "-mom=") == Approx(momentum).epsilon(1e-4));
            CHECK(number(row[2], name + "-rbv=") ==
                  Approx(mass > 0.0 ? momentum / mass : 0.0).epsilon(1e-4));
        }
        CHECK(number(row[3], "hgeng=") == 0.0);
    }
}

TEST_CASE("glstat's energies close when the ledger does", "[io]") {
    Sample start, end;
    start.energy.kinetic = 2.0;
    start.energy.gas = 10.0;
    start.energy.total = 12.0;
    EnergyBooks& e = end.energy;
    e.kinetic = 3.0;
    e.strain = 1.0;
    e.gas = 50.0;
    e.smoothing = 0.5;
    e.contact = 0.25;
    e.friction = 0.75;
    e.damping = 1.5;
    e.ambient = 4.0;
    e.outflow = 6.0;
    e.total = 67.0;
    e.inflow = 70.0;
    e.external = -15.0;
    e.residual = e.total - (start.energy.total + e.inflow + e.external);
    REQUIRE(e.residual == 0.0);
    end.time = 0.02;
    end.dt = 1e-6;
    const auto rows = lines(io::glstat_state(end, start));
    REQUIRE(rows.size() == 13);
    const std::vector<std::pair<std::string, double>> expected{
        {" time...........................", 0.02}, {" time step......................", 1e-6},
        {" kinetic energy.................", 3.0},  {" internal energy................", 51.5},
        {" system damping energy..........", 1.5},  {" sliding interface energy.......", 1.0},
        {" external work..................", 45.0}, {" total energy...................", 57.0},
        {" total energy / initial energy..", 1.0}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(rows[4 + i].substr(0, 32) == expected[i].first);
        CHECK(rows[4 + i].size() == 46);
        CHECK(std::stod(rows[4 + i].substr(32)) == Approx(expected[i].second));
    }
}

TEST_CASE("rcforc tells both sides of a contact, equal and opposite", "[io]") {
    const RecordLayout layout = scene::layout();
    const Sample before = scene::sample(layout, 0), s = scene::sample(layout, 1);
    const auto rows = lines(io::rcforc_state(layout, s, before));
    REQUIRE(rows.size() == 2);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string& row = rows[side];
        CHECK(row.substr(0, 8) == (side == 0 ? "  slave " : "  master"));
        CHECK(std::stoi(row.substr(8, 11)) == 41);
        CHECK(row.substr(19, 5) == " time");
        CHECK(std::stod(row.substr(24, 12)) == Approx(0.5));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CHECK(row.substr(36 + 16 * axis, 4) == std::string("  ") + "xyz"[axis] + " ");
            const double force = std::stod(row.substr(40 + 16 * axis, 12));
            CHECK(force == Approx((side == 0 ? 1.0 : -1.0) *
                                  scene::contact_force(layout, 1, 0)[static_cast<int>(axis)]));
        }
    }
}

TEST_CASE("rwforc's normal force is the force along the wall's normal", "[io]") {
    RecordLayout layout = scene::layout();
    layout.wall_normals = {Vec3::UnitZ(), Vec3(0.6, 0.8, 0.0)};
    const Sample before = scene::sample(layout, 0), s = scene::sample(layout, 1);
    const auto rows = lines(io::rwforc_state(layout, s, before));
    REQUIRE(rows.size() == 5);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 f = scene::wall_force(layout, 1, i);
        check_near(cut(rows[3 + i], {12, 8, 15, 15, 15, 15}),
                   {0.5, 31.0 + static_cast<double>(i), f.dot(layout.wall_normals[i]), f.x(), f.y(),
                    f.z()});
    }
}

TEST_CASE("rbdout tells where a rigid body is and how far it came", "[io]") {
    const RecordLayout layout = scene::layout();
    const Sample start = scene::sample(layout, 0), s = scene::sample(layout, 2);
    const auto rows = lines(io::rbdout_state(layout, s, start));
    REQUIRE(rows.size() == 10);
    CHECK(rows[2].substr(0, 57) == "  r i g i d   b o d y   m o t i o n   a t  cycle=     200");
    CHECK(rows[4] == " rigid body       20");
    const Sample::Rigid& body = s.rigid_bodies[0];
    const std::vector<std::pair<std::string, Vec3>> expected{
        {"    coordinates:", body.position},
        {"  displacements:", body.position - start.rigid_bodies[0].position},
        {"     velocities:", body.velocity},
        {"  accelerations:", body.acceleration}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(rows[6 + i].substr(0, 16) == expected[i].first);
        const Vec3& v = expected[i].second;
        check_near(cut(rows[6 + i].substr(16), {12, 12, 12}), {v.x(), v.y(), v.z()});
    }
}

TEST_CASE("nodout's acceleration is the mean since the state before", "[io]") {
    const RecordLayout layout = scene::layout();
    const Sample before = scene::sample(layout, 1), s = scene::sample(layout, 2);
    const auto rows = lines(io::nodout_state(layout, s, before));
    REQUIRE(rows.size() == 8);
    CHECK(rows[3].substr(0, 55) == " n o d a l   p r i n t   o u t   f o r   t i m e  s t e");
    const std::vector<int> widths{9, 13, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 x = s.node_coordinates[i], v = s.node_velocity[i];
        const Vec3 u =
            x - layout.coordinates[static_cast<std::size_t>(layout.history_node_rows[i])];
        const Vec3 a = (v - before.node_velocity[i]) / 0.5;
        check_near(cut(rows[6 + i], widths),
                   {i == 0 ? 102.0 : 105.0, u.x(), u.y(), u.z(), v.x(), v.y(), v.z(), a.x(), a.y(),
                    a.z(), x.x(), x.y(), x.z()});
    }
}
