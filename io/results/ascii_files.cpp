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
    return reached.count * reached.interval * (1.0 - ROUNDING);
}

void AsciiFiles::File::write(std::string_view text) {
    const bool written = out && std::fwrite(text.data(), 1, text.size(), out.get()) == text.size();
    if (!written || std::fflush(out.get()) != 0)
        throw SystemError(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
    reached.size += text.size();
}

void AsciiFiles::File::begin() {
    out.reset(std::fopen(path.c_str(), "wb"));
    write(heading);
}

AsciiFiles::AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
                       const OutputIntervals& intervals, const std::string& title) {
    std::error_code ignored;  // what cannot be made cannot be opened below, and that says why
    std::filesystem::create_directories(folder, ignored);
    for (const char* name : NAMES)
        std::filesystem::remove(folder / name, ignored);  // of an earlier run
    list_files(folder, layout, intervals, title);
    for (File& file : files_) file.begin();
}

AsciiFiles::AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
                       const OutputIntervals& intervals, const std::string& title, double t,
                       StateReader& checkpoint) {
    list_files(folder, layout, intervals, title);
    for (File& file : files_)
        file.reached.count = std::ceil(t / file.reached.interval * (1.0 - ROUNDING));
    checkpoint(*this);
}

/// What a checkpoint says of the files, by their names.
void AsciiFiles::take(const std::vector<Reached>& all) {
    for (File& file : files_) {
        const auto is_it = [&](const Reached& one) { return one.name == file.reached.name; };
        const auto found = std::find_if(all.begin(), all.end(), is_it);
        if (found == all.end()) continue;
        const Reached own = std::exchange(file.reached, *found);
        if (own.interval == found->interval) continue;
        file.reached.interval = own.interval;
        file.reached.count = own.count;
    }
}

void AsciiFiles::go_on() {
    namespace fs = std::filesystem;
    std::error_code why;
    for (const File& file : files_)
        if (file.reached.size > 0 && (fs::file_size(file.path, why) < file.reached.size || why))
            throw SystemError(fmt::format(
                "{} is shorter than at the checkpoint; start the run anew", file.path.string()));
    for (File& file : files_) {
        if (file.reached.size == 0) {
            file.begin();
            continue;
        }
        fs::resize_file(file.path, file.reached.size, why);
        if (!why) file.out.reset(std::fopen(file.path.c_str(), "ab"));
        if (!file.out) throw SystemError(fmt::format("cannot write {}", file.path.string()));
    }
}

void AsciiFiles::list_files(const std::filesystem::path& folder, const RecordLayout& layout,
                            const OutputIntervals& intervals, const std::string& title) {
    const std::string titled = fmt::format(" {}\n{:25}{}\n", title, "", WRITER);
    const auto add = [&](const char* name, double interval, State state,
                         const std::string& heading = {}) {
        if (!(interval > 0.0)) return;  // NaN or 0: not asked for
        File& file = files_.emplace_back();
        file.path = folder / name;
        file.reached.name = name;
        file.reached.interval = interval;
        file.state = std::move(state);
        file.heading = heading.empty() ? titled : heading;
    };
    const auto who = std::make_shared<const RecordLayout>(layout);
    add("glstat", intervals.glstat,
        [](const Sample& s, const Sample& start, const Sample&) { return glstat_state(s, start); });
    const auto since = [who](auto&& text) {
        return [who, text](const Sample& s, const Sample&, const Sample& before) {
            return text(*who, s, before);
        };
    };
    add("abstat", intervals.abstat, since(abstat_state));
    add("abstat_cpm", intervals.abstat_cpm, since(abstat_cpm_state));
    add(
        "cpm_sensor", intervals.cpm_sensor,
        [](const Sample& s, const Sample&, const Sample&) { return cpm_sensor_state(s); },
        cpm_sensor_heading(layout));
    add("matsum", intervals.matsum,
        [who](const Sample& s, const Sample&, const Sample&) { return matsum_state(*who, s); });
    add("rcforc", intervals.rcforc, since(rcforc_state));
    add("rwforc", intervals.rwforc, since(rwforc_state));
    add("rbdout", intervals.rbdout, [who](const Sample& s, const Sample& start, const Sample&) {
        return rbdout_state(*who, s, start);
    });
    add("nodout", intervals.nodout, since(nodout_state));
}

bool AsciiFiles::is_own(std::string_view beginning) {
    return beginning.find(WRITER) != std::string_view::npos;
}

double AsciiFiles::next_time() const {
    double next = INF;
    for (const File& file : files_) next = std::min(next, file.next_time());
    return next;
}

void AsciiFiles::append(const Sample& sample) {
    for (File& file : files_) {
        if (sample.time < file.next_time()) continue;
        Reached& so_far = file.reached;
        if (!so_far.start) so_far.start = so_far.before = sample;
        file.write(file.state(sample, *so_far.start, *so_far.before));
        so_far.before = sample;
        so_far.count = std::floor(sample.time / so_far.interval * (1.0 + 2.0 * ROUNDING)) + 1.0;
    }
}

}  // namespace corpuscle::io
