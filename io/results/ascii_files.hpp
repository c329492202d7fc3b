// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/model.hpp"
#include "solver/records.hpp"

namespace corpuscle::io {

/// FOLDER/abstat, abstat_cpm, cpm_sensor, glstat, matsum, rcforc, rwforc, rbdout, nodout: each only
/// when the deck asks for it, each at its own interval, from time 0 on.
///
///     if (files.due(t)) files.append(simulation.sample());
class AsciiFiles {
public:
    /// Names of all that there may be.
    static constexpr std::array<const char*, 9> NAMES = {"glstat",     "abstat", "abstat_cpm",
                                                         "cpm_sensor", "matsum", "rcforc",
                                                         "rwforc",     "rbdout", "nodout"};

    /// Is this the beginning of a text file that this program wrote?
    [[nodiscard]] static bool is_own(std::string_view beginning);

    /// Creates the folder and the files asked for. @throws SystemError if that fails
    AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
               const OutputIntervals& intervals, const std::string& title);

    /// The same files, to go on with from a checkpoint of time t: nothing is touched before
    /// go_on(). One that the checkpoint does not know begins at t; one with another interval goes on
    /// at the multiples of the new one.
    AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
               const OutputIntervals& intervals, const std::string& title, double t,
               StateReader& checkpoint);

    /// Once, after the constructor from a checkpoint: what was written after it is cut off.
    /// @throws SystemError if a file is shorter than it was then, before any is cut
    void go_on();

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        std::vector<Reached> all;
        for (const File& file : files_) all.push_back(file.reached);
        archive(all);
        take(all);
    }

    /// Does any file want the state at this time?
    [[nodiscard]] bool due(double time) const { return time >= next_time(); }
    /// When the next state is wanted; infinite if never.                                       [s]
    [[nodiscard]] double next_time() const;

    /// Writes the sample to the files that want one by now. @throws SystemError, e.g. on a full
    /// disk
    void append(const Sample& sample);

private:
    /// Text of a state, given also the first one and the one before it (of the first: itself).
    using State =
        std::function<std::string(const Sample& now, const Sample& start, const Sample& before)>;
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    /// How far a file has come.
    struct Reached {
        std::string name;        ///< of the file
        double interval = 0;     ///< [s]
        double count = 0;        ///< intervals until the next state
        std::uint64_t size = 0;  ///< bytes written; 0: not begun
        std::optional<Sample> start = {}, before = {};

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(name, interval, count, size, start, before);
        }
    };
    struct File {
        std::filesystem::path path;
        std::unique_ptr<std::FILE, Close> out;
        std::string heading;
        State state;
        Reached reached;

        [[nodiscard]] double next_time() const;
        void write(std::string_view text);
        void begin();
    };
    void list_files(const std::filesystem::path& folder, const RecordLayout& layout,
                    const OutputIntervals& intervals, const std::string& title);
    void take(const std::vector<Reached>& all);

    std::vector<File> files_;
};

}  // namespace corpuscle::io
