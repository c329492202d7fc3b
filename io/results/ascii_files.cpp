// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/ascii_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/results/ascii_tables.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// Times are sums of many steps: what is this close to a multiple of the interval has reached it.
constexpr double ROUNDING = 1e-12;

}  // namespace

double AsciiFiles::File::next_time() const {
    return count * interval * (1.0 - ROUNDING);
}

void AsciiFiles::File::write(std::string_view text) {
    const bool written = out && std::fwrite(text.data(), 1, text.size(), out.get()) == text.size();
    if (!written || std::fflush(out.get()) != 0)
        throw SystemError(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
    size += text.size();
}

/// Opens the file as it was when it had `size` bytes.
void AsciiFiles::File::go_on() {
    std::error_code why;
    if (std::filesystem::file_size(path, why) < size || why)
        throw SystemError(
            fmt::format("{} is shorter than at the checkpoint; start the run anew", path.string()));
    std::filesystem::resize_file(path, size, why);
    if (!why) out.reset(std::fopen(path.c_str(), "ab"));
    if (!out) throw SystemError(fmt::format("cannot write {}", path.string()));
}

AsciiFiles::AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
                       const OutputIntervals& intervals, const std::string& title) {
    std::error_code ignored;  // what cannot be made cannot be opened below, and that says why
    std::filesystem::create_directories(folder, ignored);
    for (const char* name : {"glstat", "abstat", "abstat_cpm", "cpm_sensor", "matsum", "rcforc",
                             "rwforc", "rbdout", "nodout"})
        std::filesystem::remove(folder / name, ignored);  // of an earlier run
    list_files(folder, layout, intervals);
    for (File& file : files_) {
        file.out.reset(std::fopen(file.path.c_str(), "wb"));
        file.write(
            !file.heading.empty()
                ? file.heading
                : fmt::format(" {}\n{:25}corpuscle, in the columns of ls-dyna\n", title, ""));
    }
}

AsciiFiles::AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
                       const OutputIntervals& intervals, const std::string& /*title*/,
                       StateReader& checkpoint) {
    list_files(folder, layout, intervals);
    checkpoint(*this);
    for (File& file : files_) file.go_on();
}

void AsciiFiles::list_files(const std::filesystem::path& folder, const RecordLayout& layout,
                            const OutputIntervals& intervals) {
    const auto add = [&](const char* name, double interval, State state, std::string heading = {}) {
        if (!(interval > 0.0)) return;  // NaN or 0: not asked for
        File& file = files_.emplace_back();
        file.path = folder / name;
        file.interval = interval;
        file.state = std::move(state);
        file.heading = std::move(heading);
    };
    const auto who = std::make_shared<const RecordLayout>(layout);
    const auto now = [who](auto&& text) {
        return [who, text](const Sample& s, const Sample&, const Sample&) { return text(*who, s); };
    };
    add("glstat", intervals.glstat,
        [](const Sample& s, const Sample& start, const Sample&) { return glstat_state(s, start); });
    add("abstat", intervals.abstat, now(abstat_state));
    add("abstat_cpm", intervals.abstat_cpm, now(abstat_cpm_state));
    add(
        "cpm_sensor", intervals.cpm_sensor,
        [](const Sample& s, const Sample&, const Sample&) { return cpm_sensor_state(s); },
        cpm_sensor_heading(layout));
    add("matsum", intervals.matsum, now(matsum_state));
    const auto since = [who](auto&& text) {
        return [who, text](const Sample& s, const Sample&, const Sample& before) {
            return text(*who, s, before);
        };
    };
    add("rcforc", intervals.rcforc, since(rcforc_state));
    add("rwforc", intervals.rwforc, since(rwforc_state));
    add("rbdout", intervals.rbdout, [who](const Sample& s, const Sample& start, const Sample&) {
        return rbdout_state(*who, s, start);
    });
    add("nodout", intervals.nodout, since(nodout_state));
}

double AsciiFiles::next_time() const {
    double next = INF;
    for (const File& file : files_) next = std::min(next, file.next_time());
    return next;
}

void AsciiFiles::append(const Sample& sample) {
    for (File& file : files_) {
        if (sample.time < file.next_time()) continue;
        if (!file.start) file.start = file.before = sample;
        file.write(file.state(sample, *file.start, *file.before));
        file.before = sample;
        file.count = std::floor(sample.time / file.interval * (1.0 + 2.0 * ROUNDING)) + 1.0;
    }
}

}  // namespace corpuscle::io
