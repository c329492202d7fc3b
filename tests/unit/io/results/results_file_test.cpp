// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::Hdf5Reader;
using io::ResultsFile;
using io::Shape;

namespace {

std::vector<double> flat(const Points& points) {
    std::vector<double> values;
    for (const Vec3& p : points) values.insert(values.end(), p.begin(), p.end());
    return values;
}

std::vector<float> single(const Points& points) {
    std::vector<float> values;
    for (const Vec3& p : points)
        for (const double x : p) values.push_back(static_cast<float>(x));
    return values;
}

template <std::size_t COLUMNS, class T>
std::vector<T> flat(const std::vector<std::array<T, COLUMNS>>& rows) {
    std::vector<T> values;
    for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
    return values;
}

/// Every dataset below a group, full paths.
std::set<std::string> datasets(const Hdf5Reader& file, const std::string& group = "") {
    std::set<std::string> found;
    for (const std::string& name : file.names(group + "/")) {
        const std::string path = group + "/" + name;
        if (file.is_group(path))
            found.merge(datasets(file, path));
        else
            found.insert(path);
    }
    return found;
}

/// Checks histories by path, and remembers which were checked.
struct Histories {
    const Hdf5Reader& file;
    const std::vector<Sample>& samples;
    std::set<std::string> checked{};

    template <class Pick>
    void expect(const std::string& path, Pick&& pick) {
        std::vector<double> values;
        Shape shape{samples.size()};
        for (const Sample& s : samples) {
            if constexpr (std::is_convertible_v<decltype(pick(s)), double>) {
                values.push_back(pick(s));
            } else {
                const Vec3 v = pick(s);
                values.insert(values.end(), v.begin(), v.end());
                shape = {samples.size(), 3};
            }
        }
        INFO(path);
        CHECK(file.shape(path) == shape);
        CHECK(file.read<double>(path) == values);
        CHECK(file.element_size(path) == 8);
        checked.insert(path);
    }

    /// Of an impulse so far: the force that it makes since the row before.
    template <class Pick>
    void expect_mean(const std::string& path, Pick&& pick) {
        expect(path, [&](const Sample& s) -> Vec3 {
            if (&s == samples.data()) return Vec3::Zero();
            const Sample& before = *(&s - 1);
            return (pick(s) - pick(before)) / (s.time - before.time);
        });
    }
};

void expect_energy(Histories& h) {
    const auto book = [&](const std::string& name, double EnergyBooks::*member) {
        h.expect("/history/energy/" + name, [=](const Sample& s) { return s.energy.*member; });
    };
    book("kinetic", &EnergyBooks::kinetic);
    book("strain", &EnergyBooks::strain);
    book("gas", &EnergyBooks::gas);
    book("contact", &EnergyBooks::contact);
    book("friction", &EnergyBooks::friction);
    book("damping", &EnergyBooks::damping);
    book("smoothing", &EnergyBooks::smoothing);
    book("ambient", &EnergyBooks::ambient);
    book("inflow", &EnergyBooks::inflow);
    book("outflow", &EnergyBooks::outflow);
    book("external", &EnergyBooks::external);
    book("total", &EnergyBooks::total);
    book("residual", &EnergyBooks::residual);
}

void expect_airbag(Histories& h, std::size_t i, const std::string& id,
                   const std::vector<std::string>& species, const std::vector<std::string>& parts) {
    const auto of = [&](const std::string& name, double AirbagSample::*member) {
        h.expect("/history/airbag/" + id + "/" + name,
                 [=](const Sample& s) { return s.airbags[i].*member; });
    };
    of("volume", &AirbagSample::volume);
    of("pressure", &AirbagSample::pressure);
    of("temperature", &AirbagSample::temperature);
    of("mass", &AirbagSample::mass);
    of("mass_in", &AirbagSample::mass_in);
    of("mass_out_vent", &AirbagSample::mass_out_vent);
    of("mass_out_fabric", &AirbagSample::mass_out_fabric);
    of("particles", &AirbagSample::particles);
    of("particles_out", &AirbagSample::particles_out);
    of("energy", &AirbagSample::energy);
    of("translational_energy", &AirbagSample::translational_energy);
    h.expect("/history/airbag/" + id + "/owed_momentum",
             [=](const Sample& s) { return s.airbags[i].owed_momentum; });
    h.expect("/history/airbag/" + id + "/owed_angular_momentum",
             [=](const Sample& s) { return s.airbags[i].owed_angular_momentum; });
    for (std::size_t k = 0; k < species.size(); ++k) {
        const std::string at = "/history/airbag/" + id + "/species/" + species[k];
        h.expect(at + "/mass", [=](const Sample& s) { return s.airbags[i].species[k].mass; });
        h.expect(at + "/temperature",
                 [=](const Sample& s) { return s.airbags[i].species[k].temperature; });
        h.expect(at + "/energy", [=](const Sample& s) { return s.airbags[i].species[k].energy; });
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::string at = "/history/airbag/" + id + "/part/" + parts[k];
        h.expect(at + "/pressure", [=](const Sample& s) { return s.airbags[i].parts[k].pressure; });
        h.expect(at + "/area", [=](const Sample& s) { return s.airbags[i].parts[k].area; });
        h.expect(at + "/mass_out", [=](const Sample& s) { return s.airbags[i].parts[k].mass_out; });
        h.expect(at + "/heat_lost",
                 [=](const Sample& s) { return s.airbags[i].parts[k].heat_lost; });
    }
}

void expect_the_rest(Histories& h) {
    h.expect("/history/time", [](const Sample& s) { return s.time; });
    const std::vector<std::string> parts{"10", "11", "12"};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string at = "/history/part/" + parts[i];
        h.expect(at + "/kinetic_energy",
                 [=](const Sample& s) { return s.parts[i].kinetic_energy; });
        h.expect(at + "/strain_energy", [=](const Sample& s) { return s.parts[i].strain_energy; });
        h.expect(at + "/momentum", [=](const Sample& s) { return s.parts[i].momentum; });
    }
    const std::string body = "/history/rigid_body/20";
    h.expect(body + "/position", [](const Sample& s) { return s.rigid_bodies[0].position; });
    h.expect(body + "/velocity", [](const Sample& s) { return s.rigid_bodies[0].velocity; });
    h.expect(body + "/acceleration",
             [](const Sample& s) { return s.rigid_bodies[0].acceleration; });
    h.expect(body + "/force", [](const Sample& s) { return s.rigid_bodies[0].force; });
    h.expect_mean("/history/rigidwall/31/force", [](const Sample& s) { return s.wall_impulse[0]; });
    h.expect_mean("/history/rigidwall/32/force", [](const Sample& s) { return s.wall_impulse[1]; });
    h.expect("/history/rigidwall/32/displacement",
             [](const Sample& s) { return s.moving_walls[0].displacement; });
    h.expect("/history/rigidwall/32/velocity",
             [](const Sample& s) { return s.moving_walls[0].velocity; });
    h.expect_mean("/history/contact/41/force",
                  [](const Sample& s) { return s.contacts[0].impulse; });
    h.expect("/history/contact/41/energy", [](const Sample& s) { return s.contacts[0].energy; });
    h.expect("/history/contact/41/pairs", [](const Sample& s) { return s.contacts[0].pairs; });
    h.expect("/history/contact/41/penetration",
             [](const Sample& s) { return s.contacts[0].penetration; });
    for (const std::size_t j : {std::size_t{0}, std::size_t{1}}) {
        const std::string of = j == 0 ? "/history/joint/51" : "/history/joint/53";
        h.expect_mean(of + "/force", [=](const Sample& s) { return s.joints[j].impulse; });
        h.expect_mean(of + "/moment", [=](const Sample& s) { return s.joints[j].turning; });
    }
    h.expect("/history/node/102/coordinates",
             [](const Sample& s) { return s.node_coordinates[0]; });
    h.expect("/history/node/102/velocity", [](const Sample& s) { return s.node_velocity[0]; });
    h.expect("/history/node/105/coordinates",
             [](const Sample& s) { return s.node_coordinates[1]; });
    h.expect("/history/node/105/velocity", [](const Sample& s) { return s.node_velocity[1]; });
}

void expect_frame(const Hdf5Reader& file, const std::string& at, const Frame& f) {
    INFO(at);
    CHECK(file.read<double>(at + "/coordinates") == flat(f.coordinates));
    CHECK(file.shape(at + "/coordinates") == Shape{5, 3});
    CHECK(file.read<float>(at + "/velocity") == single(f.velocity));
    CHECK(file.shape(at + "/velocity") == Shape{5, 3});
    CHECK(file.read<float>(at + "/shell_pressure") == f.shell_pressure);
    CHECK(file.shape(at + "/shell_pressure") == Shape{2});
    CHECK(file.read<float>(at + "/shell_contact_pressure") == f.shell_contact_pressure);
    CHECK(file.read<float>(at + "/shell_stress") == flat(f.shell_stress));
    CHECK(file.shape(at + "/shell_stress") == Shape{2, 3});
    CHECK(file.read<float>(at + "/shell_strain") == flat(f.shell_strain));
    CHECK(file.shape(at + "/shell_strain") == Shape{2, 3});
    CHECK(file.read<std::uint8_t>(at + "/shell_active") == f.shell_active);
    CHECK(file.shape(at + "/shell_active") == Shape{2});
    CHECK(file.has(at + "/particles") == f.particles.has_value());
    if (!f.particles) return;
    const Frame::Particles& p = *f.particles;
    const std::uint64_t n = p.id.size();
    CHECK(file.read<std::int64_t>(at + "/particles/id") == p.id);
    CHECK(file.read<std::int32_t>(at + "/particles/bag") == p.bag);
    CHECK(file.read<std::int32_t>(at + "/particles/species") == p.species);
    CHECK(file.read<double>(at + "/particles/position") == flat(p.position));
    CHECK(file.shape(at + "/particles/position") == Shape{n, 3});
    CHECK(file.read<float>(at + "/particles/velocity") == single(p.velocity));
    CHECK(file.shape(at + "/particles/velocity") == Shape{n, 3});
    CHECK(file.read<double>(at + "/particles/internal_energy") == p.internal_energy);
    CHECK(file.read<double>(at + "/particles/mass") == p.mass);
    CHECK(file.read<float>(at + "/particles/temperature") == p.temperature);
}

}  // namespace

TEST_CASE("every history comes back value by value under its promised path", "[io]") {
    const scene::Folder folder("histories");
    const RecordLayout layout = scene::layout();
    std::vector<Sample> samples;
    {
        ResultsFile results(folder.path, scene::info(), layout);
        for (std::size_t row = 0; row < 130; ++row) {
            samples.push_back(scene::sample(layout, row));
            results.append(samples.back());
        }
        results.finish("normal");
    }
    const Hdf5Reader file(folder.path / "results.h5");
    Histories histories{file, samples};
    expect_energy(histories);
    expect_airbag(histories, 0, "7", {"0", "1", "2"}, {"10", "11"});
    expect_airbag(histories, 1, "9", {"1"}, {"12"});
    expect_the_rest(histories);
    // and nothing else is there
    std::set<std::string> written = datasets(file);
    std::erase_if(written, [](const std::string& path) { return !path.starts_with("/history/"); });
    CHECK(written == histories.checked);
}

TEST_CASE("mesh and frames come back value by value, while running and when finished", "[io]") {
    const scene::Folder folder("frames");
    const RecordLayout layout = scene::layout();
    const std::vector<Frame> frames{scene::frame(layout, 0, 0), scene::frame(layout, 1, 4),
                                    scene::frame(layout, 2, -1)};
    ResultsFile results(folder.path, scene::info(), layout);
    for (const Frame& f : frames) results.write(f);
    results.flush();
    const bool finished = GENERATE(false, true);
    if (finished) results.finish("normal");
    CHECK(std::filesystem::exists(folder.path / "results.parts") == !finished);

    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.read<std::int32_t>("/mesh/node_id") == layout.node_id);
    CHECK(file.read<double>("/mesh/coordinates") == flat(layout.coordinates));
    CHECK(file.shape("/mesh/coordinates") == Shape{5, 3});
    CHECK(file.read<std::int32_t>("/mesh/shell_id") == layout.shell_id);
    CHECK(file.read<std::int32_t>("/mesh/shell_part") == layout.shell_part);
    CHECK(file.read<std::int32_t>("/mesh/shell_nodes") == flat(layout.shell_nodes));
    CHECK(file.shape("/mesh/shell_nodes") == Shape{2, 4});
    CHECK(file.read<std::int32_t>("/mesh/xdmf_topology") ==
          std::vector<std::int32_t>{5, 0, 1, 2, 3, 4, 3, 2, 4});
    CHECK(file.read<double>("/frames/time") == std::vector<double>{0.0, 1.5, 3.0});
    CHECK(file.names("/frames") == std::vector<std::string>{"00000", "00001", "00002", "time"});
    expect_frame(file, "/frames/00000", frames[0]);
    expect_frame(file, "/frames/00001", frames[1]);
    expect_frame(file, "/frames/00002", frames[2]);
}

TEST_CASE("the root says who ran what and how it ended", "[io]") {
    const scene::Folder folder("root");
    ResultsFile results(folder.path, scene::info(), scene::layout());
    std::string termination = "running";
    SECTION("while it runs") {}
    SECTION("in the end") {
        results.finish(termination = "normal");
    }
    SECTION("when it broke") {
        results.finish(termination = "error: at time 1: shell 3 inverted");
    }
    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.text("/", "program") == "corpuscle");
    CHECK(file.text("/", "version") == "0.1.0");
    CHECK(file.number<int>("/", "format") == 1);
    CHECK(file.text("/", "deck") == "bag.k");
    CHECK(file.text("/", "unit_system") == "kg-mm-ms-K");
    CHECK(file.number<std::uint64_t>("/", "seed") == 18446744073709551615ULL);
    CHECK(file.number<int>("/", "threads") == 2);
    CHECK(file.text("/", "termination") == termination);
}

TEST_CASE("every dataset has a unit and a description, in the deck's units", "[io]") {
    const scene::Folder folder("units");
    const RecordLayout layout = scene::layout();
    io::RunInfo info = scene::info();
    const auto [system, pressure, time, force] =
        GENERATE(table<std::string, std::string, std::string, std::string>(
            {{"SI", "Pa", "s", "N"},
             {"kg-mm-ms-K", "GPa", "ms", "kN"},
             {"ton-mm-s-K", "MPa", "s", "N"},
             {"consistent", "deck [pressure]", "deck [time]", "deck [force]"}}));
    info.unit_system = system;
    ResultsFile results(folder.path, info, layout);
    results.append(scene::sample(layout, 0));
    results.write(scene::frame(layout, 0, 3));
    results.finish("normal");

    const Hdf5Reader file(folder.path / "results.h5");
    for (const std::string& path : datasets(file)) {
        INFO(path);
        CHECK_FALSE(file.text(path, "unit").empty());
        CHECK_FALSE(file.text(path, "description").empty());
    }
    CHECK(file.text("/history/airbag/7/pressure", "unit") == pressure);
    CHECK(file.text("/frames/00000/shell_stress", "unit") == pressure);
    CHECK(file.text("/history/time", "unit") == time);
    CHECK(file.text("/frames/time", "unit") == time);
    CHECK(file.text("/history/rigidwall/31/force", "unit") == force);
    CHECK(file.text("/frames/00000/particles/id", "unit") == "-");
}

TEST_CASE("a run without samples or frames leaves empty histories", "[io]") {
    const scene::Folder folder("empty");
    ResultsFile(folder.path, scene::info(), scene::layout()).finish("normal");
    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.shape("/history/time") == Shape{0});
    CHECK(file.shape("/history/node/102/velocity") == Shape{0, 3});
    CHECK(file.shape("/frames/time") == Shape{0});
}

TEST_CASE("a new run clears away the frames of an earlier one", "[io]") {
    const scene::Folder folder("again");
    const RecordLayout layout = scene::layout();
    ResultsFile(folder.path, scene::info(), layout).write(scene::frame(layout, 0, 1));
    ResultsFile(folder.path, scene::info(), layout).flush();
    CHECK_FALSE(Hdf5Reader(folder.path / "results.h5").has("/frames/00000"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "results.parts/00000.h5"));
}

TEST_CASE("two things of one kind with one id are told apart from a broken disk", "[io]") {
    const scene::Folder folder("twins");
    RecordLayout layout = scene::layout();
    layout.walls = {31, 31};
    CHECK_THROWS_AS(ResultsFile(folder.path, scene::info(), layout), InputError);
}

TEST_CASE("a results folder that cannot be made is named with the reason", "[io]") {
    const scene::Folder folder("file_in_the_way");
    std::ofstream(folder.path) << "a file, not a folder";
    CHECK_THROWS_AS(ResultsFile(folder.path / "run", scene::info(), scene::layout()), SystemError);
    CHECK_THROWS_WITH(ResultsFile(folder.path / "run", scene::info(), scene::layout()),
                      Catch::Contains("Not a directory") && Catch::Contains(folder.path.string()));
}

TEST_CASE("a number that is not finite is refused by its name, and is never in the results",
          "[io]") {
    const scene::Folder folder("finite");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    results.append(scene::sample(layout, 0));
    results.write(scene::frame(layout, 0, 20));
    const double broken = GENERATE(as<double>{}, NaN, INF, -INF);
    CAPTURE(broken);
    const auto fault = [&](auto&& spoil, auto what, auto&& take) {
        spoil(what);
        try {
            take(what);
        } catch (const PhysicsError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto of_sample = [&](auto&& spoil) {
        return fault(spoil, scene::sample(layout, 1), [&](const Sample& s) { results.append(s); });
    };
    const auto of_frame = [&](auto&& spoil) {
        return fault(spoil, scene::frame(layout, 1, 20), [&](const Frame& f) { results.write(f); });
    };
    using Catch::Contains;
    CHECK_THAT(of_sample([&](Sample& s) { s.energy.contact = broken; }),
               Contains("at time 0.5: /history/energy/contact is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.airbags[1].pressure = broken; }),
               Contains("/history/airbag/9/pressure is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.airbags[0].species[2].temperature = broken; }),
               Contains("/history/airbag/7/species/2/temperature is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.node_velocity[1].z() = broken; }),
               Contains("/history/node/105/velocity is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.coordinates[3].y() = broken; }),
               Contains("at time 1.5: position of node 104 is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.shell_stress[1][2] = static_cast<float>(broken); }),
               Contains("stress of shell 1002 is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.particles->velocity[7].x() = broken; }),
               Contains("velocity of particle " + std::to_string((std::int64_t{1} << 40) + 7)));
    CHECK_THAT(of_frame([&](Frame& f) { f.particles->internal_energy[0] = broken; }),
               Contains("internal energy of particle"));
    CHECK_THAT(
        of_frame([&](Frame& f) { f.particles->temperature[19] = static_cast<float>(broken); }),
        Contains("temperature of particle"));
    results.append(scene::sample(layout, 1));
    results.finish("error: not finite");
    const io::Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.shape("/frames/time") == io::Shape{1});
    const auto pressure = file.read<double>("/history/airbag/9/pressure");
    REQUIRE(pressure.size() == 2);
    CHECK(pressure[1] == scene::sample(layout, 1).airbags[1].pressure);
}
