// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/results/history_table.hpp"
#include "io/results/rigid_history.hpp"
#include "io/results/xdmf.hpp"
#include "io/system/reserve.hpp"
#include "solver/base/archive.hpp"
#include "solver/records.hpp"

namespace corpuscle::io {

/// Root attributes of the results: program, deck, seed.
struct RunInfo {
    std::string program,        ///< "corpuscle"
        version;                ///< of the program
    std::string deck;           ///< path of the deck
    std::string unit_system;    ///< as Model::unit_system
    std::uint64_t seed = 0;     ///< of the run's random numbers
    int threads = 1;            ///< that the run uses
    std::string mendings = {};  ///< what was done to close bags, a line each
    std::uint64_t scene = 0;    ///< fingerprint of the scene, as in its checkpoints
    std::vector<std::pair<int, std::string>> parts = {};  ///< ids and titles
    std::vector<std::pair<int, double>> ambient = {};  ///< by airbag id: pressure outside     [Pa]
    std::string up = {};  ///< "z", "-y", ...: against gravity; empty: there is none
};

/// What a run that came to its normal end has left.
struct FinishedRun {
    std::uint64_t scene = 0;  ///< 0: not known
    double end = 0.0;         ///< time of its last frame                                     [s]
};

/// Of FOLDER/results.h5; none if there is none, its run did not come to its normal end, or what it
/// wrote is not gathered in it yet. What such a run needs no more is cleared away, should a kill
/// have come before that.
/// @throws SystemError if the file cannot be read
[[nodiscard]] std::optional<FinishedRun> finished_run(const std::filesystem::path& folder);

/// FOLDER/results.h5 and FOLDER/results.xdmf, as io/FORMAT.md promises them.
///
/// At any instant results.h5 is a complete HDF5 file without a writer: each version is
/// written beside it and renamed. So it opens, whenever the run is killed, and may be looked at
/// meanwhile. To keep versions small, mesh and frames lie in FOLDER/results.parts while the run
/// lasts, each written once, behind external links; finish() gathers all in the one file. Libhdf5
/// is used by one thread at a time: whoever writes settles the frame first.
///
/// Numbers that are not finite are refused, so that none is ever in the results: observe(), append()
/// and write() throw PhysicsError, which names the first, and leave it out. (Responses are NaN where
/// there are none.)
class ResultsFile {
public:
    /// Creates the folder, clears away the results of an earlier run, writes the mesh.
    /// @throws SystemError if that cannot be written, InputError if ids of one kind collide
    ResultsFile(std::filesystem::path folder, RunInfo info, const RecordLayout& layout);

    /// To go on with from a checkpoint: nothing is touched before go_on().
    ResultsFile(std::filesystem::path folder, RunInfo info, const RecordLayout& layout,
                StateReader& checkpoint);

    /// Once, after the constructor from a checkpoint: what was written after it is taken back.
    /// @throws SystemError if what was written before it is not there any more
    void go_on();

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        settle();
        archive(history_, frame_times_, xdmf_.nodes, xdmf_.shells, xdmf_.topology_size,
                xdmf_.states);
    }

    /// From now on these bodies are followed at a rate of their own. Once, before the first step.
    /// @param interval  between rows, rigid_interval()                                          [s]
    void follow(double interval, const std::vector<RigidTrack>& tracks);
    /// Once in every step: the followed bodies at t; `at_end`: the last time.
    void observe(double t, const std::vector<RigidState>& states, bool at_end);
    /// Their part of a checkpoint, after follow().
    template <class Archive>
    void visit_bodies(Archive& archive) {
        archive(rigid_);
    }
    /// What the followed bodies felt so far.
    [[nodiscard]] std::vector<BodyTable> responses() const;

    /// One row in every history. On the disk within a second, or 50 times what a version costs.
    /// @throws PhysicsError  if a number is not finite; the row is left out
    void append(const Sample& sample);
    /// One state for pictures. A thread of its own writes it while the run goes on; it is found in
    /// results.h5 with the next version.
    /// @throws SystemError if the frame before could not be written, PhysicsError if a number is not
    ///         finite; the frame is left out
    void write(Frame frame);
    /// Waits until the last frame is on the disk.
    /// @throws SystemError if it could not be written; it is left out then
    void settle();
    /// Is the last frame one of this time?                                                    [s]
    [[nodiscard]] bool has_frame_at(double t) const {
        return coming_ ? coming_->time == t : !frame_times_.empty() && frame_times_.back() == t;
    }
    /// What was appended and written survives a kill from now on.
    void flush();
    /// The last version, all in one file; on a full disk, before this throws, in the room that was
    /// held for it: all histories and the reason, mesh and frames still in FOLDER/results.parts.
    /// @param termination  "normal" or "error: ..."
    void finish(std::string_view termination);

private:
    enum class Parts { LINKED, COPIED };

    void clear_away() const;
    void find_parts() const;
    void write_mesh();
    void write_version(Parts parts);
    void list_frames();
    [[nodiscard]] bool is_due() const;
    void expect_room_to_gather() const;
    [[nodiscard]] std::filesystem::path part_file(std::string_view name) const;

    std::filesystem::path folder_;
    RunInfo info_;
    RecordLayout layout_;
    std::string termination_ = "running";
    HistoryTable history_;
    RigidHistory rigid_;
    std::vector<double> frame_times_;
    XdmfScene xdmf_;
    std::size_t listed_ = 0;                  ///< frames in results.xdmf
    std::optional<XdmfScene::State> coming_;  ///< the frame that is being written
    std::future<void> writing_;               ///< of it
    std::chrono::steady_clock::time_point written_at_;
    std::chrono::steady_clock::duration cost_{};  ///< of the last version
    Reserve reserve_;
};

}  // namespace corpuscle::io
