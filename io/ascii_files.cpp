// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/ascii_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "io/ascii_tables.hpp"
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
}

AsciiFiles::AsciiFiles(const std::filesystem::path& folder, const RecordLayout& layout,
                       const OutputIntervals& intervals, const std::string& title) {
    std::error_code ignored;  // what cannot be made cannot be opened below, and that says why
    std::filesystem::create_directories(folder, ignored);
    const auto add = [&](const char* name, double interval, State state) {
        std::filesystem::remove(folder / name, ignored);  // of an earlier run
        if (!(interval > 0.0)) return;                    // NaN or 0: not asked for
        File& file = files_.emplace_back();
        file.path = folder / name;
        file.out.reset(std::fopen(file.path.c_str(), "wb"));
        file.interval = interval;
        file.state = std::move(state);
        file.write(fmt::format(" {}\n{:25}corpuscle, in the columns of ls-dyna\n", title, ""));
    };
    const auto since_start = [](auto&& text) {
        return [text, start = std::optional<Sample>()](const Sample& s) mutable {
            if (!start) start = s;
            return text(s, *start);
        };
    };
    const auto who = std::make_shared<const RecordLayout>(layout);
    add("glstat", intervals.glstat, since_start(glstat_state));
    add("abstat", intervals.abstat, [who](const Sample& s) { return abstat_state(*who, s); });
    add("rcforc", intervals.rcforc, [who](const Sample& s) { return rcforc_state(*who, s); });
    add("rwforc", intervals.rwforc, [who](const Sample& s) { return rwforc_state(*who, s); });
    add("rbdout", intervals.rbdout, since_start([who](const Sample& s, const Sample& start) {
            return rbdout_state(*who, s, start);
        }));
    add("nodout", intervals.nodout,
        [who, before = std::optional<Sample>()](const Sample& s) mutable {
            const std::string text = nodout_state(*who, s, before.value_or(s));
            before = s;
            return text;
        });
}

double AsciiFiles::next_time() const {
    double next = INF;
    for (const File& file : files_) next = std::min(next, file.next_time());
    return next;
}

void AsciiFiles::append(const Sample& sample) {
    for (File& file : files_) {
        if (sample.time < file.next_time()) continue;
        file.write(file.state(sample));
        file.count = std::floor(sample.time / file.interval * (1.0 + 2.0 * ROUNDING)) + 1.0;
    }
}

}  // namespace corpuscle::io
