// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/model.hpp"
#include "solver/records.hpp"

namespace corpuscle::io {

/// FOLDER/abstat, glstat, rcforc, rwforc, rbdout, nodout: each only when the deck asks for it, each
/// at its own interval, from time 0 on.
///
///     if (files.due(t)) files.append(simulation.sample());
class AsciiFiles {
public:
    /// Creates the folder and the files asked for. @throws SystemError if that fails
    AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
               const OutputIntervals& intervals, const std::string& title);

    /// Does any file want the state at this time?
    [[nodiscard]] bool due(double time) const { return time >= next_time(); }
    /// When the next state is wanted; infinite if never.                                       [s]
    [[nodiscard]] double next_time() const;

    /// Writes the sample to the files that want one by now. @throws SystemError, e.g. on a full
    /// disk
    void append(const Sample& sample);

private:
    using State = std::function<std::string(const Sample&)>;
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    struct File {
        std::filesystem::path path;
        std::unique_ptr<std::FILE, Close> out;
        double interval;  ///< [s]
        State state;
        double count = 0;  ///< intervals until the next state

        [[nodiscard]] double next_time() const;
        void write(std::string_view text);
    };

    std::vector<File> files_;
};

}  // namespace corpuscle::io
