// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/history_table.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include <cassert>
#include <type_traits>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// A sample of the layout's sizes, all zero.
Sample blank(const RecordLayout& layout) {
    Sample s;
    for (const auto& bag : layout.airbags) {
        AirbagSample& of = s.airbags.emplace_back();
        of.species.resize(bag.species.size());
        of.parts.resize(bag.parts.size());
        of.chambers.resize(bag.chambers.size());
    }
    s.parts.resize(layout.parts.size());
    s.rigid_bodies.resize(layout.rigid_bodies.size());
    s.wall_impulse.resize(layout.walls.size(), Vec3::Zero());
    s.moving_walls.resize(layout.moving_walls.size());
    s.contacts.resize(layout.contacts.size());
    s.joints.resize(layout.joints.size());
    s.sensors.resize(layout.sensors);
    s.node_coordinates.resize(layout.history_nodes.size(), Vec3::Zero());
    s.node_velocity = s.node_coordinates;
    return s;
}

[[maybe_unused]] bool has_sizes_of(const RecordLayout& layout, const Sample& s) {
    bool same = s.airbags.size() == layout.airbags.size() &&
                s.parts.size() == layout.parts.size() &&
                s.rigid_bodies.size() == layout.rigid_bodies.size() &&
                s.wall_impulse.size() == layout.walls.size() &&
                s.moving_walls.size() == layout.moving_walls.size() &&
                s.contacts.size() == layout.contacts.size() &&
                s.joints.size() == layout.joints.size() && s.sensors.size() == layout.sensors &&
                s.node_coordinates.size() == layout.history_nodes.size() &&
                s.node_velocity.size() == layout.history_nodes.size();
    for (std::size_t i = 0; same && i < s.airbags.size(); ++i)
        same = s.airbags[i].species.size() == layout.airbags[i].species.size() &&
               s.airbags[i].parts.size() == layout.airbags[i].parts.size() &&
               s.airbags[i].chambers.size() == layout.airbags[i].chambers.size();
    return same;
}

void energy(auto&& row, const EnergyBooks& e) {
    const auto book = [&](const char* name, const char* text, double value) {
        row(fmt::format("/history/energy/{}", name), Quantity::ENERGY, text, value);
    };
    book("kinetic", "kinetic energy of fabric and rigid bodies", e.kinetic);
    book("strain", "strain energy of the fabric", e.strain);
    book("gas", "all energy that the gas inside the bags holds", e.gas);
    book("contact", "taken by contacts, stored there or lost", e.contact);
    book("friction", "energy spent by friction so far", e.friction);
    book("damping", "energy spent by damping so far", e.damping);
    book("smoothing", "given by particles to the wall, not yet passed on to the fabric",
         e.smoothing);
    book("ambient", "work done against the atmosphere, p_atm (V - V at the start)", e.ambient);
    book("inflow", "energy brought in by inflators so far", e.inflow);
    book(
        "outflow",
        "energy that left with gas, and as heat to the fabric, so far; at TSW, of the gas's motion "
        "with the bag",
        e.outflow);
    book("external",
         "work of loads, supports, prescribed motion, and of contact that parts what began too "
         "near, so far",
         e.external);
    book("total", "what is there now and what was spent", e.total);
    book("residual", "total - (start + inflow + external): the error of the books", e.residual);
}

void airbag(auto&& row, const RecordLayout::Airbag& bag, const AirbagSample& s) {
    using enum Quantity;
    const std::string at = fmt::format("/history/airbag/{}/", bag.id);
    row(at + "volume", VOLUME, "enclosed volume", s.volume);
    row(at + "pressure", PRESSURE, "absolute: 2/3 of the translational energy per volume",
        s.pressure);
    row(at + "temperature", TEMPERATURE, "at which the gas at rest would hold `energy`",
        s.temperature);
    row(at + "static_pressure", PRESSURE,
        "pressure without the motion of each room's gas as a whole", s.static_pressure);
    row(at + "static_temperature", TEMPERATURE,
        "temperature without the motion of each room's gas as a whole", s.static_temperature);
    row(at + "mass", MASS, "gas inside", s.mass);
    row(at + "mass_in", MASS, "gas brought in by inflators so far", s.mass_in);
    row(at + "mass_out_vent", MASS, "gas lost through vents so far", s.mass_out_vent);
    row(at + "mass_out_fabric", MASS, "gas lost through porous fabric so far", s.mass_out_fabric);
    row(at + "particles", NONE, "particles inside", s.particles);
    row(at + "particles_out", NONE, "particles gone through vents and fabric so far",
        s.particles_out);
    row(at + "energy", ENERGY, "all that the gas inside holds, initial air too", s.energy);
    row(at + "translational_energy", ENERGY, "translational part of `energy`",
        s.translational_energy);
    row(at + "owed_momentum", MOMENTUM,
        "given up by particles at walls, not yet passed on to the fabric", s.owed_momentum);
    row(at + "owed_angular_momentum", ANGULAR_MOMENTUM, "the same about the origin of coordinates",
        s.owed_angular_momentum);
    for (std::size_t k = 0; k < bag.species.size(); ++k) {
        const std::string of = fmt::format("{}species/{}/", at, bag.species[k]);
        row(of + "mass", MASS, "this gas inside", s.species[k].mass);
        row(of + "temperature", TEMPERATURE, "at which this gas at rest would hold `energy`",
            s.species[k].temperature);
        row(of + "energy", ENERGY, "all that this gas inside holds", s.species[k].energy);
    }
    for (std::size_t k = 0; k < bag.parts.size(); ++k) {
        const std::string on = fmt::format("{}part/{}/", at, bag.parts[k]);
        row(on + "pressure", PRESSURE,
            "gas impulse on the part's inside per area and time since the last sample, unsmoothed",
            s.parts[k].pressure);
        row(on + "area", AREA, "area of the part's inside", s.parts[k].area);
        row(on + "mass_out", MASS, "gas lost through this part so far", s.parts[k].mass_out);
        row(on + "heat_lost", ENERGY, "heat that this part took from the gas so far",
            s.parts[k].heat_lost);
    }
    for (std::size_t k = 0; k < bag.chambers.size(); ++k) {
        const std::string in = fmt::format("{}chamber/{}/", at, bag.chambers[k]);
        row(in + "volume", VOLUME, "of the chamber", s.chambers[k].volume);
        row(in + "pressure", PRESSURE, "absolute: 2/3 of the translational energy per volume",
            s.chambers[k].pressure);
        row(in + "temperature", TEMPERATURE, "at which its gas at rest would hold `energy`",
            s.chambers[k].temperature);
        row(in + "static_pressure", PRESSURE,
            "pressure without the motion of each room's gas as a whole",
            s.chambers[k].static_pressure);
        row(in + "static_temperature", TEMPERATURE,
            "temperature without the motion of each room's gas as a whole",
            s.chambers[k].static_temperature);
        row(in + "mass", MASS, "gas in it", s.chambers[k].mass);
        row(in + "energy", ENERGY, "all that its gas holds", s.chambers[k].energy);
    }
}

void bodies(auto&& row, const RecordLayout& layout, const Sample& s) {
    using enum Quantity;
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        const std::string of = fmt::format("/history/part/{}/", layout.parts[i]);
        row(of + "kinetic_energy", ENERGY, "kinetic energy of the part", s.parts[i].kinetic_energy);
        row(of + "strain_energy", ENERGY, "strain energy of the part", s.parts[i].strain_energy);
        row(of + "momentum", MOMENTUM, "momentum of the part", s.parts[i].momentum);
    }
    for (std::size_t i = 0; i < layout.rigid_bodies.size(); ++i) {
        const std::string of = fmt::format("/history/rigid_body/{}/", layout.rigid_bodies[i]);
        row(of + "position", LENGTH, "centre of mass", s.rigid_bodies[i].position);
        row(of + "velocity", VELOCITY, "of the centre of mass", s.rigid_bodies[i].velocity);
        row(of + "acceleration", ACCELERATION, "of the centre of mass",
            s.rigid_bodies[i].acceleration);
        row(of + "force", FORCE, "contact and gas on the body", s.rigid_bodies[i].force);
        row(of + "angular_momentum", ANGULAR_MOMENTUM, "about the centre of mass",
            s.rigid_bodies[i].angular_momentum);
    }
    for (std::size_t i = 0; i < layout.history_nodes.size(); ++i) {
        const std::string of = fmt::format("/history/node/{}/", layout.history_nodes[i]);
        row(of + "coordinates", LENGTH, "position of the node", s.node_coordinates[i]);
        row(of + "velocity", VELOCITY, "velocity of the node", s.node_velocity[i]);
    }
}

void sensors(auto&& row, const RecordLayout& layout, const Sample& s) {
    using enum Quantity;
    for (std::size_t i = 0; i < layout.sensors; ++i) {
        const std::string of = fmt::format("/history/cpm_sensor/{}/", i + 1);
        row(of + "particles", NONE, "particles in the sensor", s.sensors[i].particles);
        row(of + "pressure", PRESSURE, "absolute: of the particles' motion about their mean",
            s.sensors[i].pressure);
        row(of + "temperature", TEMPERATURE, "of that motion", s.sensors[i].temperature);
        row(of + "density", DENSITY, "particles' mass over the sensor's volume",
            s.sensors[i].density);
        row(of + "velocity", VELOCITY, "mean of the particles, by mass", s.sensors[i].velocity);
        row(of + "coordinates", LENGTH, "of the sensor's centre", s.sensors[i].centre);
    }
}

void touching(auto&& row, const RecordLayout& layout, const Sample& s, const Sample& before) {
    using enum Quantity;
    const double span = s.time - before.time;
    for (std::size_t i = 0; i < layout.walls.size(); ++i)
        row(fmt::format("/history/rigidwall/{}/force", layout.walls[i]), FORCE,
            "on the rigid wall, mean since the row before; 0 in the first",
            mean_force(s.wall_impulse[i], before.wall_impulse[i], span));
    for (std::size_t i = 0; i < layout.moving_walls.size(); ++i) {
        const std::string of = fmt::format("/history/rigidwall/{}/", layout.moving_walls[i]);
        row(of + "displacement", LENGTH, "of the rigid wall, since the start",
            s.moving_walls[i].displacement);
        row(of + "velocity", VELOCITY, "of the rigid wall", s.moving_walls[i].velocity);
    }
    for (std::size_t i = 0; i < layout.contacts.size(); ++i) {
        const std::string of = fmt::format("/history/contact/{}/", layout.contacts[i]);
        row(of + "force", FORCE, "resultant on SURFA, mean since the row before; 0 in the first",
            mean_force(s.contacts[i].impulse, before.contacts[i].impulse, span));
        row(of + "energy", ENERGY, "energy stored in the contact", s.contacts[i].energy);
        row(of + "pairs", NONE, "places that are nearer than the contact thickness",
            s.contacts[i].pairs);
        row(of + "penetration", NONE, "greatest part of the contact thickness that is missing",
            s.contacts[i].penetration);
    }
    for (std::size_t i = 0; i < layout.joints.size(); ++i) {
        const std::string of = fmt::format("/history/joint/{}/", layout.joints[i]);
        row(of + "force", FORCE,
            "on the body of the joint's first node, mean since the row before; 0 in the first",
            mean_force(s.joints[i].impulse, before.joints[i].impulse, span));
        row(of + "moment", MOMENT, "the same, about the joint's first place",
            mean_force(s.joints[i].turning, before.joints[i].turning, span));
    }
}

/// THE list of histories: row(path, quantity, description, value) for every one.
/// @param before  the sample of the row before; of the first row: itself
void visit(const RecordLayout& layout, const Sample& s, const Sample& before, auto&& row) {
    row("/history/time", Quantity::TIME, "time of the samples", s.time);
    energy(row, s.energy);
    for (std::size_t i = 0; i < layout.airbags.size(); ++i)
        airbag(row, layout.airbags[i], s.airbags[i]);
    bodies(row, layout, s);
    touching(row, layout, s, before);
    sensors(row, layout, s);
}

}  // namespace

std::set<std::string> vector_histories() {
    RecordLayout one;  // of each kind
    one.airbags.emplace_back().id = 1;
    one.parts = one.rigid_bodies = one.walls = one.moving_walls = one.contacts = one.joints =
        one.history_nodes = {1};
    one.sensors = 1;
    const Sample none = blank(one);
    std::set<std::string> names;
    visit(one, none, none,
          [&]<class Value>(const std::string& path, Quantity, const char*, const Value&) {
              if (std::is_same_v<Value, Vec3>) names.insert(path.substr(path.rfind('/') + 1));
          });
    return names;
}

HistoryTable::HistoryTable(const RecordLayout& layout) {
    std::set<std::string> taken;
    const Sample none = blank(layout);
    visit(layout, none, none,
          [&]<class Value>(const std::string& path, Quantity quantity, const char* description,
                           const Value&) {
              if (!taken.insert(path).second)
                  throw InputError(
                      fmt::format("two histories would be named {}: ids must differ", path));
              columns_.push_back({path, quantity, description, std::is_same_v<Value, Vec3>, {}});
          });
}

void HistoryTable::append(const RecordLayout& layout, const Sample& sample) {
    assert(has_sizes_of(layout, sample) && "a sample has the sizes of its layout");
    auto column = columns_.begin();
    visit(layout, sample, rows_ == 0 ? sample : last_,
          [&]<class Value>(const std::string&, Quantity, const char*, const Value& value) {
              std::vector<double>& values = (column++)->values;
              if constexpr (std::is_same_v<Value, Vec3>)
                  values.insert(values.end(), value.begin(), value.end());
              else
                  values.push_back(value);
          });
    expect_finite(sample.time);
    last_ = sample;
    ++rows_;
}

/// The new row, which is taken back if it is not finite.
void HistoryTable::expect_finite(double time) {
    for (const Column& c : columns_) {
        const std::size_t begin = (c.is_vector ? 3 : 1) * rows_;
        if (std::all_of(c.values.begin() + static_cast<std::ptrdiff_t>(begin), c.values.end(),
                        [](double value) { return std::isfinite(value); }))
            continue;
        const std::string path = c.path;
        for (Column& of : columns_) of.values.resize((of.is_vector ? 3 : 1) * rows_);
        throw PhysicsError(time, path + " is not finite");
    }
}

void HistoryTable::write(Hdf5Writer& file, const std::string& unit_system) const {
    for (const Column& c : columns_) {
        const Shape shape = c.is_vector ? Shape{rows_, 3} : Shape{rows_};
        file.dataset<double>(c.path, c.values, shape,
                             {unit_of(c.quantity, unit_system), c.description});
    }
}

}  // namespace corpuscle::io
