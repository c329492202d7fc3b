// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

namespace results_file_setup {

using namespace corpuscle;
using io::Hdf5Reader;
using io::ResultsFile;
using io::Shape;

inline std::vector<double> flat(const Points& points) {
    std::vector<double> values;
    for (const Vec3& p : points) values.insert(values.end(), p.begin(), p.end());
    return values;
}

inline std::vector<float> single(const Points& points) {
    std::vector<float> values;
    for (const Vec3& p : points)
        for (const double x : p) values.push_back(static_cast<float>(x));
    return values;
}

template <std::size_t COLUMNS, class T>
inline std::vector<T> flat(const std::vector<std::array<T, COLUMNS>>& rows) {
    std::vector<T> values;
    for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
    return values;
}

/// Every dataset below a group, full paths.
inline std::set<std::string> datasets(const Hdf5Reader& file, const std::string& group = "") {
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

inline void expect_energy(Histories& h) {
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

inline void expect_airbag(Histories& h, std::size_t i, const std::string& id,
                          const std::vector<std::string>& species,
                          const std::vector<std::string>& parts) {
    const auto of = [&](const std::string& name, double AirbagSample::*member) {
        h.expect("/history/airbag/" + id + "/" + name,
                 [=](const Sample& s) { return s.airbags[i].*member; });
    };
    of("volume", &AirbagSample::volume);
    of("pressure", &AirbagSample::pressure);
    of("temperature", &AirbagSample::temperature);
    of("static_pressure", &AirbagSample::static_pressure);
    of("static_temperature", &AirbagSample::static_temperature);
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

inline void expect_the_rest(Histories& h) {
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
    h.expect(body + "/angular_momentum",
             [](const Sample& s) { return s.rigid_bodies[0].angular_momentum; });
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

inline void expect_frame(const Hdf5Reader& file, const std::string& at, const Frame& f) {
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

}  // namespace results_file_setup
