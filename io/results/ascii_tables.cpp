// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/ascii_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace corpuscle::io {
namespace {

std::string fields(std::initializer_list<double> values, int width, int precision) {
    std::string text;
    for (const double value : values) text += field(value, width, precision);
    return text;
}

std::string fields(const Vec3& v, int width, int precision) {
    return fields({v.x(), v.y(), v.z()}, width, precision);
}

/// Label and dots fill 32 columns, then the number.
std::string glstat_line(std::string_view label, double value) {
    return fmt::format("{:.<32}{}\n", fmt::format(" {}", label), field(value, 14, 5));
}

/// What the scene holds or has spent: all but what went to the atmosphere and out of the vents.
double energy_inside(const EnergyBooks& e) {
    return e.total - e.ambient - e.outflow;
}

std::string rbdout_line(std::string_view label, const Vec3& v) {
    return fmt::format("{:>16}{}\n", label, fields(v, 12, 4));
}

}  // namespace

std::string field(double value, int width, int precision) {
    std::string text = fmt::format("{:{}.{}E}", value, width, precision);
    while (text.size() > static_cast<std::size_t>(width) && precision > 0)
        text = fmt::format("{:{}.{}E}", value, width, --precision);
    return text;
}

std::string glstat_state(const Sample& sample, const Sample& start) {
    const EnergyBooks& e = sample.energy;
    const double work =
        e.external + e.inflow - e.outflow - e.ambient -
        (start.energy.external + start.energy.inflow - start.energy.outflow - start.energy.ambient);
    const double total = energy_inside(e);
    const double expected = energy_inside(start.energy) + work;
    std::string text = fmt::format("\n\n dt of cycle{:9d}\n\n", sample.step);
    text += glstat_line("time", sample.time);
    text += glstat_line("time step", sample.dt);
    text += glstat_line("kinetic energy", e.kinetic);
    text += glstat_line("internal energy", e.strain + e.gas + e.smoothing);
    text += glstat_line("system damping energy", e.damping);
    text += glstat_line("sliding interface energy", e.contact + e.friction);
    text += glstat_line("external work", work);
    text += glstat_line("total energy", total);
    // of nothing at all, nothing is missing
    text += glstat_line("total energy / initial energy", expected == 0.0 ? 1.0 : total / expected);
    return text;
}

namespace {

constexpr std::string_view ABSTAT_HEADING =
    "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in"
    "      density dm/dt out  total mass gas temp. surface area   reaction\n";

/// Mean mass flow of a bag in and out since `before`; of a bag of uniform pressure as it is.  [kg/s]
std::array<double, 2> mass_rates(const RecordLayout::Airbag& layout, const AirbagSample& bag,
                                 const AirbagSample& before, double span) {
    if (!layout.has_particles) return {bag.mass_rate_in, bag.mass_rate_out};
    if (!(span > 0.0)) return {0.0, 0.0};
    return {(bag.mass_in - before.mass_in) / span, (bag.mass_out_vent + bag.mass_out_fabric -
                                                    before.mass_out_vent - before.mass_out_fabric) /
                                                       span};
}

std::string abstat_row(const RecordLayout& layout, const Sample& sample, const Sample& before,
                       std::size_t i) {
    const AirbagSample& bag = sample.airbags[i];
    const auto [rate_in, rate_out] =
        mass_rates(layout.airbags[i], bag, before.airbags[i], sample.time - before.time);
    const double density = bag.volume > 0.0 ? bag.mass / bag.volume : 0.0;
    const double reaction = 0.0;  // a bag of particles rests on its fabric and on nothing else
    return fmt::format(
        "{}{:8d}{}{}\n", field(sample.time, 12, 5), layout.airbags[i].id,
        fields({bag.volume, bag.pressure, bag.energy, rate_in, density}, 15, 4),
        fields({rate_out, bag.mass, bag.temperature, bag.surface_area, reaction}, 11, 3));
}

}  // namespace

std::string abstat_state(const RecordLayout& layout, const Sample& sample, const Sample& before) {
    std::string text(ABSTAT_HEADING);
    for (std::size_t i = 0; i < layout.airbags.size(); ++i)
        text += abstat_row(layout, sample, before, i);
    return text;
}

std::string abstat_cpm_state(const RecordLayout& layout, const Sample& sample,
                             const Sample& before) {
    std::string text(ABSTAT_HEADING);
    for (std::size_t i = 0; i < layout.airbags.size(); ++i)
        if (layout.airbags[i].has_particles) text += abstat_row(layout, sample, before, i);
    return text;
}

std::string cpm_sensor_heading(const RecordLayout& layout) {
    constexpr int NUMBERS = 16;  // as LS-DYNA writes, whatever it counts
    return fmt::format(
        "Airbag Particle sensor file, "
        "{}\n{:5d}{:5d}\n{:>13}\n{:>13}{:>13}{:>13}\n{:>13}{:>13}{:>13}\n"
        "{:>13}{:>13}{:>13}{:>13}\n\n\n",
        WRITER, layout.sensors, NUMBERS, "time", "x", "y", "z", "vx", "vy", "vz", "pres", "dens",
        "temp", "npart");
}

std::string cpm_sensor_state(const Sample& sample) {
    std::string text = field(sample.time, 13, 5) + '\n';
    for (const Sample::Sensor& s : sample.sensors)
        text += fmt::format("{}\n{}{}\n{}{:13d}\n", fields(s.centre, 13, 5),
                            fields(s.velocity, 13, 5), field(s.velocity.norm(), 13, 5),
                            fields({s.pressure, s.density, s.temperature}, 13, 5),
                            static_cast<long long>(s.particles));
    return text;
}

std::string matsum_state(const RecordLayout& layout, const Sample& sample) {
    std::string text = fmt::format("\n\n time ={}\n", field(sample.time, 13, 4));
    const auto along = [](std::string_view name, const Vec3& v) {
        return fmt::format(" x-{0}={1}     y-{0}={2}     z-{0}={3}\n", name, field(v.x(), 13, 4),
                           field(v.y(), 13, 4), field(v.z(), 13, 4));
    };
    for (std::size_t p = 0; p < layout.parts.size(); ++p) {
        const Sample::Part& part = sample.parts[p];
        const double mass = layout.part_mass[p];
        const Vec3 velocity = mass > 0.0 ? Vec3(part.momentum / mass) : Vec3(Vec3::Zero());
        text += fmt::format(" mat.#={:<8}          inten={}     kinen={}\n",
                            fmt::format("{:5d}", layout.parts[p]), field(part.strain_energy, 13, 4),
                            field(part.kinetic_energy, 13, 4));
        text += along("mom", part.momentum) + along("rbv", velocity);
        text += fmt::format("{:25}hgeng={}\n", "", field(0.0, 13, 4));  // membranes: none
    }
    return text;
}

std::string rcforc_state(const RecordLayout& layout, const Sample& sample, const Sample& before) {
    std::string text;
    for (std::size_t i = 0; i < layout.contacts.size(); ++i) {
        const auto side = [&](std::string_view name, const Vec3& force) {
            text += fmt::format("  {}{:11d} time{}  x {}  y {}  z {}\n", name, layout.contacts[i],
                                field(sample.time, 12, 5), field(force.x(), 12, 5),
                                field(force.y(), 12, 5), field(force.z(), 12, 5));
        };
        const Vec3 force = mean_force(sample.contacts[i].impulse, before.contacts[i].impulse,
                                      sample.time - before.time);
        side("slave ", force);
        side("master", -force);
    }
    return text;
}

std::string rwforc_state(const RecordLayout& layout, const Sample& sample, const Sample& before) {
    std::string text =
        "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n";
    const bool has_normals = layout.wall_normals.size() == layout.walls.size();
    for (std::size_t i = 0; i < layout.walls.size(); ++i) {
        const Vec3 force =
            mean_force(sample.wall_impulse[i], before.wall_impulse[i], sample.time - before.time);
        const bool is_plane = has_normals && !layout.wall_normals[i].isZero(0.0);
        const double normal = is_plane ? std::abs(force.dot(layout.wall_normals[i])) : force.norm();
        text += fmt::format("{}{:8d}{}{}\n", field(sample.time, 12, 5), layout.walls[i],
                            field(normal, 15, 6), fields(force, 15, 6));
    }
    return text;
}

std::string rbdout_state(const RecordLayout& layout, const Sample& sample, const Sample& start) {
    std::string text =
        fmt::format("\n\n  r i g i d   b o d y   m o t i o n   a t  cycle={:8d}     time={}\n",
                    sample.step, field(sample.time, 15, 6));
    for (std::size_t i = 0; i < layout.rigid_bodies.size(); ++i) {
        const Sample::Rigid& body = sample.rigid_bodies[i];
        text += fmt::format("\n rigid body{:9d}\n", layout.rigid_bodies[i]);
        text += "   global             x           y           z\n";
        text += rbdout_line("coordinates:", body.position);
        text += rbdout_line("displacements:", body.position - start.rigid_bodies[i].position);
        text += rbdout_line("velocities:", body.velocity);
        text += rbdout_line("accelerations:", body.acceleration);
    }
    return text;
}

std::string nodout_state(const RecordLayout& layout, const Sample& sample, const Sample& before) {
    std::string text = fmt::format(
        "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p{:8d}{:30}( at time{} "
        ")\n\n",
        sample.step, "", field(sample.time, 12, 5));
    text +=
        " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel"
        "      x-accl      y-accl      z-accl      x-coor      y-coor      z-coor\n";
    const double span = sample.time - before.time;
    for (std::size_t i = 0; i < layout.history_nodes.size(); ++i) {
        const Vec3& x = sample.node_coordinates[i];
        const Vec3 moved =
            x - layout.coordinates[static_cast<std::size_t>(layout.history_node_rows[i])];
        const Vec3 gained = sample.node_velocity[i] - before.node_velocity[i];
        const Vec3 acceleration = span > 0.0 ? Vec3(gained / span) : Vec3(Vec3::Zero());
        text += fmt::format("{:9d}{}{}{}{}{}\n", layout.history_nodes[i], field(moved.x(), 13, 4),
                            fields({moved.y(), moved.z()}, 12, 4),
                            fields(sample.node_velocity[i], 12, 4), fields(acceleration, 12, 4),
                            fields(x, 12, 4));
    }
    return text;
}

}  // namespace corpuscle::io
