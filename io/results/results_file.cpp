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
#include "io/results/results_content.hpp"
#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Histories wait in memory for this long, and for 50 times what a version costs: 2 % of the run at
/// most.
constexpr auto PATIENCE = std::chrono::milliseconds(500);
constexpr int PATIENCE_PER_COST = 50;

/// A file that is written beside its place and then takes it.
template <class Fill>
void write_whole(const fs::path& file, Fill&& fill) {
    Hdf5Writer next(next_version(file));
    fill(next);
    next.close();
    take_its_name(file);
}

}  // namespace

std::optional<FinishedRun> finished_run(const fs::path& folder) {
    const fs::path file = folder / "results.h5";
    if (!fs::exists(file)) return std::nullopt;
    const Hdf5Reader results(file);
    if (results.text("/", "termination") != "normal" || results.is_link("/mesh"))
        return std::nullopt;
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
}

void ResultsFile::go_on() {
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
        // at any instant something there is of this program: a later run knows the folder as its own
        const fs::path parts = folder_ / "results.parts";
        fs::create_directories(parts);
        for (const char* old : {"results.h5", "results.xdmf"}) fs::remove_all(folder_ / old);
        const std::vector<fs::directory_entry> old(fs::directory_iterator{parts},
                                                   fs::directory_iterator{});
        for (const fs::directory_entry& part : old) fs::remove_all(part.path());
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
