// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/results_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "io/text/units.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

constexpr int FORMAT_VERSION = 1;

std::span<const double> flat(const Points& x) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return {x.empty() ? nullptr : x.front().data(), 3 * x.size()};
}

template <class T, std::size_t COLUMNS>
std::span<const T> flat(const std::vector<std::array<T, COLUMNS>>& rows) {
    return {rows.empty() ? nullptr : rows.front().data(), COLUMNS * rows.size()};
}

std::vector<float> single(const Points& x) {
    const std::span<const double> from = flat(x);
    std::vector<float> to(from.size());
    std::transform(from.begin(), from.end(), to.begin(),
                   [](double value) { return static_cast<float>(value); });
    return to;
}

void fill_particles(Hdf5Writer& file, const Frame::Particles& p, const std::string& units) {
    const std::uint64_t n = p.id.size();
    std::vector<std::int32_t> index(n);
    std::iota(index.begin(), index.end(), 0);
    const std::string energy = unit_of(Quantity::ENERGY, units);
    file.dataset<std::int64_t>("/particles/id", p.id, {n}, {"-", "a particle's name for life"});
    file.dataset<std::int32_t>("/particles/bag", p.bag, {n}, {"-", "id of its airbag"});
    file.dataset<std::int32_t>("/particles/species", p.species, {n},
                               {"-", "0 initial air, else the gas's number in the deck"});
    file.dataset("/particles/position", flat(p.position), {n, 3},
                 {unit_of(Quantity::LENGTH, units), "position"});
    file.dataset<float>("/particles/velocity", single(p.velocity), {n, 3},
                        {unit_of(Quantity::VELOCITY, units), "velocity"});
    file.dataset<double>("/particles/internal_energy", p.internal_energy, {n},
                         {energy, "spin and vibration energy of the particle"});
    file.dataset<double>("/particles/mass", p.mass, {n},
                         {unit_of(Quantity::MASS, units), "mass of the particle"});
    file.dataset<float>("/particles/temperature", p.temperature, {n},
                        {unit_of(Quantity::TEMPERATURE, units),
                         "at which the particle would hold its spin and vibration energy; of a gas "
                         "without any: its speed's"});
    file.dataset<std::int32_t>("/particles/xdmf_index", index, {n}, {"-", "for XDMF: 0, 1, 2 ..."});
}

}  // namespace

void fill_mesh(Hdf5Writer& file, const RecordLayout& layout, const std::string& units,
               std::span<const std::int32_t> topology) {
    const std::uint64_t n = layout.node_id.size(), e = layout.shell_id.size();
    const auto integers = [&](const char* name, std::span<const std::int32_t> values,
                              const Shape& shape, const char* text) {
        file.dataset(name, values, shape, {"-", text}, Packing::DEFLATE);
    };
    integers("/node_id", layout.node_id, {n}, "ids of the nodes in the deck");
    file.dataset("/coordinates", flat(layout.coordinates), {n, 3},
                 {unit_of(Quantity::LENGTH, units), "initial (folded) coordinates of the nodes"},
                 Packing::DEFLATE);
    integers("/shell_id", layout.shell_id, {e}, "ids of the shells in the deck");
    integers("/shell_part", layout.shell_part, {e}, "ids of the shells' parts");
    integers("/shell_nodes", flat(layout.shell_nodes), {e, 4},
             "rows in node_id; a triangle repeats its 3rd");
    integers("/xdmf_topology", topology, {topology.size()},
             "for XDMF: each shell as 4 (triangle) or 5 (quad) and its rows in node_id");
}

void fill_frame(Hdf5Writer& file, const Frame& frame, const std::string& units) {
    const std::uint64_t n = frame.coordinates.size(), e = frame.shell_active.size();
    const std::string pressure = unit_of(Quantity::PRESSURE, units);
    file.dataset("/coordinates", flat(frame.coordinates), {n, 3},
                 {unit_of(Quantity::LENGTH, units), "coordinates of the nodes"});
    file.dataset<float>("/velocity", single(frame.velocity), {n, 3},
                        {unit_of(Quantity::VELOCITY, units), "velocity of the nodes"});
    file.dataset<float>("/shell_pressure", frame.shell_pressure, {e},
                        {pressure, "gauge pressure on the shell"});
    if (!frame.shell_contact_pressure.empty())
        file.dataset<float>("/shell_contact_pressure", frame.shell_contact_pressure, {e},
                            {pressure,
                             "normal contact force on both sides over the shell's area, mean since "
                             "the frame before"});
    file.dataset("/shell_stress", flat(frame.shell_stress), {e, 3},
                 {pressure, "membrane stress: warp, weft, shear"});
    file.dataset("/shell_strain", flat(frame.shell_strain), {e, 3},
                 {"-", "membrane strain: warp, weft, shear"});
    file.dataset<std::uint8_t>("/shell_active", frame.shell_active, {e},
                               {"-", "1 alive, 0 eroded"});
    if (frame.particles) fill_particles(file, *frame.particles, units);
}

void expect_finite(const Frame& frame, const RecordLayout& layout) {
    // of numbers up to `most`, which their type in the file holds
    const auto expect = [&](const char* what, const char* whose, const auto& id, auto numbers,
                            double most = std::numeric_limits<double>::max()) {
        const auto bad = std::find_if(numbers.begin(), numbers.end(),
                                      [&](double value) { return !(std::abs(value) <= most); });
        if (bad == numbers.end()) return;
        const std::size_t row =
            static_cast<std::size_t>(bad - numbers.begin()) / (numbers.size() / id.size());
        throw PhysicsError(frame.time,
                           fmt::format("{} of {} {} is not finite{}", what, whose, id[row],
                                       std::isfinite(*bad) ? " in single precision" : ""));
    };
    constexpr double SINGLE = std::numeric_limits<float>::max();
    expect("position", "node", layout.node_id, flat(frame.coordinates));
    expect("velocity", "node", layout.node_id, flat(frame.velocity), SINGLE);
    expect("pressure", "shell", layout.shell_id, std::span(frame.shell_pressure));
    expect("contact pressure", "shell", layout.shell_id, std::span(frame.shell_contact_pressure));
    expect("stress", "shell", layout.shell_id, flat(frame.shell_stress));
    expect("strain", "shell", layout.shell_id, flat(frame.shell_strain));
    if (!frame.particles) return;
    const Frame::Particles& p = *frame.particles;
    expect("position", "particle", p.id, flat(p.position));
    expect("velocity", "particle", p.id, flat(p.velocity), SINGLE);
    expect("internal energy", "particle", p.id, std::span(p.internal_energy));
    expect("mass", "particle", p.id, std::span(p.mass));
    expect("temperature", "particle", p.id, std::span(p.temperature));
}

void fill_root(Hdf5Writer& file, const RunInfo& info, const std::string& termination) {
    file.attribute("/", "program", info.program);
    file.attribute("/", "version", info.version);
    file.attribute("/", "format", FORMAT_VERSION);
    file.attribute("/", "deck", info.deck);
    file.attribute("/", "unit_system", info.unit_system);
    file.attribute("/", "seed", info.seed);
    file.attribute("/", "scene", info.scene);
    file.attribute("/", "threads", info.threads);
    if (!info.mendings.empty()) file.attribute("/", "mendings", info.mendings);
    if (!info.up.empty()) file.attribute("/", "up", info.up);
    std::string titles;
    for (const auto& [id, title] : info.parts) titles += fmt::format("{} {}\n", id, title);
    if (!titles.empty()) file.attribute("/", "part_titles", titles);
    for (const auto& [id, pressure] : info.ambient)
        file.attribute("/", fmt::format("ambient_pressure_{}", id), pressure);
    file.attribute("/", "termination", termination);
}

std::vector<std::string> frame_groups(const Hdf5Reader& results) {
    std::vector<std::string> groups;
    for (const std::string& name : results.names("/frames"))
        if (name != "time") groups.push_back("/frames/" + name + "/");
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
        return a.size() < b.size();  // frame 100000 comes after 99999
    });
    return groups;
}

}  // namespace corpuscle::io
