// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "io/results/checkpoint.hpp"
#include "io/results/hdf5.hpp"
#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int FORMAT_VERSION = 1;

/// Histories wait in memory for this long, and for 50 times what a version costs: 2 % of the run at
/// most.
constexpr auto PATIENCE = std::chrono::milliseconds(500);
constexpr int PATIENCE_PER_COST = 50;

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

/// A file that is written beside its place and then takes it.
template <class Fill>
void write_whole(const fs::path& file, Fill&& fill) {
    Hdf5Writer next(next_version(file));
    fill(next);
    next.close();
    take_its_name(file);
}

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

/// @throws PhysicsError that names the first number of a frame that is not finite
void expect_finite(const Frame& frame, const RecordLayout& layout) {
    const auto expect = [&](const char* what, const char* whose, const auto& id, auto numbers) {
        const auto bad = std::find_if(numbers.begin(), numbers.end(),
                                      [](double value) { return !std::isfinite(value); });
        if (bad == numbers.end()) return;
        const std::size_t row =
            static_cast<std::size_t>(bad - numbers.begin()) / (numbers.size() / id.size());
        throw PhysicsError(frame.time,
                           fmt::format("{} of {} {} is not finite", what, whose, id[row]));
    };
    expect("position", "node", layout.node_id, flat(frame.coordinates));
    expect("velocity", "node", layout.node_id, flat(frame.velocity));
    expect("pressure", "shell", layout.shell_id, std::span(frame.shell_pressure));
    expect("contact pressure", "shell", layout.shell_id, std::span(frame.shell_contact_pressure));
    expect("stress", "shell", layout.shell_id, flat(frame.shell_stress));
    expect("strain", "shell", layout.shell_id, flat(frame.shell_strain));
    if (!frame.particles) return;
    const Frame::Particles& p = *frame.particles;
    expect("position", "particle", p.id, flat(p.position));
    expect("velocity", "particle", p.id, flat(p.velocity));
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

}  // namespace

std::optional<FinishedRun> finished_run(const fs::path& folder) {
    const fs::path file = folder / "results.h5";
    if (!fs::exists(file)) return std::nullopt;
    const Hdf5Reader results(file);
    if (results.text("/", "termination") != "normal") return std::nullopt;
    FinishedRun run;
    if (results.has_attribute("/", "scene"))
        run.scene = results.number<std::uint64_t>("/", "scene");
    const auto frames = results.read<double>("/frames/time");
    if (!frames.empty()) run.end = frames.back();
    std::error_code ignored;
    fs::remove_all(folder / "results.parts", ignored);
    remove_checkpoint(folder);
    return run;
}

ResultsFile::ResultsFile(fs::path folder, RunInfo info, const RecordLayout& layout)
    : folder_(std::move(folder)),
      info_(std::move(info)),
      layout_(layout),
      history_(layout),
      reserve_(folder_ / "results.parts/reserve") {
    xdmf_.has_contact = !layout_.contacts.empty();
    clear_away();
    write_mesh();
    flush();
    list_frames();
}

ResultsFile::ResultsFile(fs::path folder, RunInfo info, const RecordLayout& layout,
                         StateReader& checkpoint)
    : folder_(std::move(folder)),
      info_(std::move(info)),
      layout_(layout),
      history_(layout),
      reserve_(folder_ / "results.parts/reserve") {
    xdmf_.has_contact = !layout_.contacts.empty();
    checkpoint(*this);
    find_parts();
    flush();
    list_frames();
}

/// Makes sure that mesh and frames lie in results.parts, also when an end has gathered them.
void ResultsFile::find_parts() const {
    std::error_code ignored;
    fs::create_directories(folder_ / "results.parts", ignored);
    const auto find = [&](const std::string& path, std::string_view name) {
        const fs::path part = part_file(name);
        if (fs::exists(part)) return;
        write_whole(part, [&](Hdf5Writer& file) { file.take_over(folder_ / "results.h5", path); });
    };
    find("/mesh", "mesh");
    for (std::size_t i = 0; i < frame_times_.size(); ++i)
        find(fmt::format("/frames/{}", frame_name(i)), frame_name(i));
    for (std::size_t i = frame_times_.size(); fs::remove(part_file(frame_name(i)), ignored); ++i) {
    }
}

fs::path ResultsFile::part_file(std::string_view name) const {
    return folder_ / "results.parts" / fmt::format("{}.h5", name);
}

void ResultsFile::clear_away() const {
    try {
        for (const char* old : {"results.h5", "results.xdmf", "results.parts"})
            fs::remove_all(folder_ / old);
        fs::create_directories(folder_ / "results.parts");
    } catch (const fs::filesystem_error& why) {
        throw SystemError(fmt::format("cannot make the results folder {}: {}", folder_.string(),
                                      why.code().message()));
    }
}

void ResultsFile::write_mesh() {
    const std::vector<std::int32_t> topology = xdmf_topology(layout_.shell_nodes);
    write_whole(part_file("mesh"),
                [&](Hdf5Writer& file) { fill_mesh(file, layout_, info_.unit_system, topology); });
    xdmf_.nodes = layout_.node_id.size();
    xdmf_.shells = layout_.shell_id.size();
    xdmf_.topology_size = topology.size();
}

void ResultsFile::follow(double interval, const std::vector<RigidTrack>& tracks) {
    rigid_ = RigidHistory(interval, tracks);
}

void ResultsFile::observe(double t, const std::vector<RigidState>& states, bool at_end) {
    for (std::size_t b = 0; b < states.size(); ++b)
        if (const RigidState& now = states[b];
            !(now.position + now.velocity + now.force).allFinite())
            throw PhysicsError(
                t, fmt::format("the state of followed rigid body {} is not finite", b + 1));
    rigid_.observe(t, states, at_end);
}

std::vector<BodyTable> ResultsFile::responses() const {
    std::vector<BodyTable> all;
    for (const BodyMotion& motion : rigid_.motions())
        all.push_back({motion.id, body_responses(motion, info_.unit_system)});
    return all;
}

void ResultsFile::append(const Sample& sample) {
    history_.append(layout_, sample);
    if (is_due()) flush();
}

/// Whether the last version is old enough for another one.
bool ResultsFile::is_due() const {
    const auto patience = std::max<Clock::duration>(PATIENCE, PATIENCE_PER_COST * cost_);
    return Clock::now() - written_at_ >= patience;
}

void ResultsFile::write(Frame frame) {
    assert(frame.coordinates.size() == xdmf_.nodes && frame.shell_active.size() == xdmf_.shells &&
           "a frame has the mesh's sizes");
    assert(frame.shell_contact_pressure.size() == (xdmf_.has_contact ? xdmf_.shells : 0) &&
           "a frame has contact pressure where there is contact");
    expect_finite(frame, layout_);
    settle();
    if (is_due()) flush();
    coming_.emplace().time = frame.time;
    if (frame.particles) coming_->particles = frame.particles->id.size();
    writing_ =
        std::async(std::launch::async, [part = part_file(frame_name(frame_times_.size())),
                                        frame = std::move(frame), units = info_.unit_system] {
            write_whole(part, [&](Hdf5Writer& file) { fill_frame(file, frame, units); });
        });
}

void ResultsFile::settle() {
    if (!writing_.valid()) return;
    const XdmfScene::State state = *std::exchange(coming_, std::nullopt);
    writing_.get();
    frame_times_.push_back(state.time);
    xdmf_.states.push_back(state);
}

void ResultsFile::flush() {
    settle();
    const auto begin = Clock::now();
    write_version(Parts::LINKED);
    if (listed_ != frame_times_.size()) list_frames();
    std::error_code unknown;
    if (const auto size = fs::file_size(folder_ / "results.h5", unknown); !unknown)
        reserve_.hold_for(size);
    written_at_ = Clock::now();
    cost_ = written_at_ - begin;
}

/// Brings results.xdmf in line with the frames.
void ResultsFile::list_frames() {
    replace_text(folder_ / "results.xdmf", xdmf_text(xdmf_));
    listed_ = frame_times_.size();
}

void ResultsFile::finish(std::string_view termination) {
    settle();
    termination_ = termination;
    reserve_.release();
    write_version(Parts::LINKED);  // should gathering fail for want of space, this version stands
    list_frames();
    expect_room_to_gather();
    write_version(Parts::COPIED);
    fs::remove_all(folder_ / "results.parts");
}

/// HDF5 1.10 does not survive copying on to a disk that fills up meanwhile.
void ResultsFile::expect_room_to_gather() const {
    constexpr std::uint64_t SPARE = std::uint64_t{1} << 18;  // responses, and groups of its own
    std::uint64_t size = fs::file_size(folder_ / "results.h5") + SPARE;
    for (const fs::directory_entry& part : fs::directory_iterator(folder_ / "results.parts"))
        size += part.file_size();
    expect_room(folder_, size);
}

void ResultsFile::write_version(Parts parts) {
    write_whole(folder_ / "results.h5", [&](Hdf5Writer& file) {
        const auto include = [&](const std::string& path, std::string_view name) {
            if (parts == Parts::LINKED)
                file.link(path, fmt::format("results.parts/{}.h5", name));
            else
                file.copy(path, part_file(name));
        };
        fill_root(file, info_, termination_);
        include("/mesh", "mesh");
        history_.write(file, info_.unit_system);
        rigid_.write(file, info_.unit_system);
        if (parts == Parts::COPIED) write_responses(file, responses());
        file.dataset<double>("/frames/time", frame_times_, {frame_times_.size()},
                             {unit_of(Quantity::TIME, info_.unit_system), "time of the frames"});
        for (std::size_t i = 0; i < frame_times_.size(); ++i)
            include(fmt::format("/frames/{}", frame_name(i)), frame_name(i));
    });
}

}  // namespace corpuscle::io
