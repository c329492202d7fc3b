// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <string>

#include "io/results/results_file.hpp"
#include "solver/records.hpp"

/// A small scene with one of everything that results can hold; every number of it differs.
namespace corpuscle::scene {

/// A folder that is gone at the end of the scope.
struct Folder {
    explicit Folder(const std::string& name)
        : path(std::filesystem::temp_directory_path() /
               ("corpuscle_" + name + "_" + std::to_string(getpid()))) {
        std::filesystem::remove_all(path);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path path;
};

inline io::RunInfo info() {
    return {"corpuscle", "0.1.0", "bag.k", "kg-mm-ms-K", 18446744073709551615ULL, 2};
}

/// Two bags, a quad and a triangle on five nodes.
inline RecordLayout layout() {
    RecordLayout l;
    l.airbags = {
        {.id = 7, .has_initial_air = true, .species = {0, 1, 2}, .parts = {10, 11}},
        {.id = 9, .has_initial_air = false, .species = {1}, .parts = {12}, .has_particles = false}};
    l.parts = {10, 11, 12};
    l.part_mass = {2.0, 0.5, 0.0};
    l.rigid_bodies = {20};
    l.walls = {31, 32};
    l.moving_walls = {32};
    l.contacts = {41};
    l.joints = {51, 53};
    l.history_nodes = {102, 105};
    l.history_node_rows = {1, 4};
    l.node_id = {101, 102, 103, 104, 105};
    l.coordinates = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.1, 2, 1e-9}};
    l.shell_id = {1001, 1002};
    l.shell_part = {10, 11};
    l.shell_nodes = {{0, 1, 2, 3}, {3, 2, 4, 4}};
    return l;
}

/// Numbers that tell their place: each call of next() is one more.
class Counter {
public:
    explicit Counter(double start) : value_(start) {}
    double next() { return value_ += 1.0; }
    Vec3 next3() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }

private:
    double value_;
};

inline Sample sample(const RecordLayout& layout, std::size_t row) {
    Counter c(1000.0 * static_cast<double>(row) + 0.125);
    Sample s;
    s.time = 0.5 * static_cast<double>(row);
    s.dt = 1e-3;
    s.step = static_cast<std::int64_t>(100 * row);
    EnergyBooks& e = s.energy;
    for (double* book :
         {&e.kinetic, &e.strain, &e.gas, &e.contact, &e.friction, &e.damping, &e.smoothing,
          &e.ambient, &e.inflow, &e.outflow, &e.external, &e.total, &e.residual})
        *book = c.next();
    for (const auto& bag : layout.airbags) {
        AirbagSample& b = s.airbags.emplace_back();
        for (double* value : {&b.volume, &b.pressure, &b.temperature, &b.mass, &b.mass_in,
                              &b.mass_out_vent, &b.mass_out_fabric, &b.particles, &b.particles_out,
                              &b.energy, &b.translational_energy, &b.mass_rate_in, &b.mass_rate_out,
                              &b.surface_area, &b.static_pressure, &b.static_temperature})
            *value = c.next();
        for (std::size_t k = 0; k < bag.species.size(); ++k)
            b.species.push_back({c.next(), c.next(), c.next()});
        for (std::size_t k = 0; k < bag.parts.size(); ++k)
            b.parts.push_back({c.next(), c.next(), c.next(), c.next()});
    }
    for (std::size_t i = 0; i < layout.parts.size(); ++i)
        s.parts.push_back({c.next(), c.next(), c.next3()});
    for (std::size_t i = 0; i < layout.rigid_bodies.size(); ++i)
        s.rigid_bodies.push_back({c.next3(), c.next3(), c.next3(), c.next3(), c.next3()});
    // such that their mean forces differ too
    const double grown = static_cast<double>(row + 1);
    for (std::size_t i = 0; i < layout.walls.size(); ++i)
        s.wall_impulse.push_back(grown * c.next3());
    for (std::size_t i = 0; i < layout.moving_walls.size(); ++i)
        s.moving_walls.push_back({c.next3(), c.next3()});
    for (std::size_t i = 0; i < layout.contacts.size(); ++i)
        s.contacts.push_back({grown * c.next3(), c.next(), c.next(), c.next()});
    for (std::size_t i = 0; i < layout.joints.size(); ++i)
        s.joints.push_back({grown * c.next3(), grown * c.next3()});
    for (std::size_t i = 0; i < layout.history_nodes.size(); ++i) {
        s.node_coordinates.push_back(c.next3());
        s.node_velocity.push_back(c.next3());
    }
    return s;
}

/// Impulse per time since the sample of the row before; 0 in row 0.
template <class Pick>
Vec3 mean_since(const RecordLayout& layout, std::size_t row, Pick&& impulse) {
    if (row == 0) return Vec3::Zero();
    const Sample now = sample(layout, row), before = sample(layout, row - 1);
    return (impulse(now) - impulse(before)) / (now.time - before.time);
}
inline Vec3 wall_force(const RecordLayout& layout, std::size_t row, std::size_t wall) {
    return mean_since(layout, row, [=](const Sample& s) { return s.wall_impulse[wall]; });
}
inline Vec3 contact_force(const RecordLayout& layout, std::size_t row, std::size_t contact) {
    return mean_since(layout, row, [=](const Sample& s) { return s.contacts[contact].impulse; });
}

inline Frame::Particles particles(std::size_t count, Counter& c) {
    Frame::Particles p;
    for (std::size_t i = 0; i < count; ++i) {
        p.id.push_back((std::int64_t{1} << 40) + static_cast<std::int64_t>(i));
        p.bag.push_back(i % 2 == 0 ? 7 : 9);
        p.species.push_back(static_cast<std::int32_t>(i % 3));
        p.position.push_back(c.next3());
        p.velocity.push_back(c.next3());
        p.internal_energy.push_back(c.next());
        p.mass.push_back(c.next());
        p.temperature.push_back(static_cast<float>(1e5 + c.next() - 1e4 * static_cast<double>(i)));
    }
    return p;
}

/// @param particle_count  negative: none are shown
inline Frame frame(const RecordLayout& layout, std::size_t number, int particle_count) {
    Counter c(100.0 * static_cast<double>(number) + 0.25);
    Frame f;
    f.time = 1.5 * static_cast<double>(number);
    for (std::size_t i = 0; i < layout.node_id.size(); ++i) {
        f.coordinates.push_back(c.next3() + Vec3::Constant(1e-12));
        f.velocity.push_back(c.next3());
    }
    const auto triple = [&] {
        const Vec3 v = c.next3();
        return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()),
                                    static_cast<float>(v.z())};
    };
    for (std::size_t i = 0; i < layout.shell_id.size(); ++i) {
        f.shell_pressure.push_back(static_cast<float>(c.next()));
        f.shell_contact_pressure.push_back(static_cast<float>(c.next()));
        f.shell_stress.push_back(triple());
        f.shell_strain.push_back(triple());
        f.shell_active.push_back(i % 2 == 0 ? 1 : 0);
    }
    if (particle_count >= 0) f.particles = particles(static_cast<std::size_t>(particle_count), c);
    return f;
}

}  // namespace corpuscle::scene
