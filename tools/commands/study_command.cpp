// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "io/system/atomic_file.hpp"
#include "io/system/folder_lock.hpp"
#include "io/text/progress.hpp"
#include "io/text/text.hpp"
#include "solver/base/cores.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/study/convergence.hpp"
#include "tools/study/known_names.hpp"
#include "tools/study/machine_share.hpp"
#include "tools/study/slurm.hpp"
#include "tools/study/table.hpp"
#include "tools/study/workers.hpp"

namespace corpuscle::tools {
namespace {

using Clock = std::chrono::steady_clock;

/// "3/40": the runs 3, 43, 83, ... from 0.
study::Share share_of(const std::string& text) {
    if (text.empty()) return {};
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto k = io::parse_integer(text.substr(0, slash));
    const auto n = slash < text.size() ? io::parse_integer(text.substr(slash + 1)) : std::nullopt;
    if (!k || !n || *k < 0 || *k >= *n)
        throw InputError(fmt::format("--share {}: expected K/N with 0 <= K < N", text));
    return {static_cast<std::size_t>(*k), static_cast<std::size_t>(*n)};
}

/// Runs of the share that are not there; failed ones too if they are to be made again.
std::vector<study::Row> missing(const study::Table& table, const study::Share& share,
                                bool retry_failed) {
    std::vector<study::Row> rows;
    for (std::size_t k = share.k; k < table.rows.size(); k += share.n) {
        const study::Outcome& outcome = table.outcomes[k];
        if (!outcome.is_finished || (retry_failed && outcome.status != 0))
            rows.push_back(table.rows[k]);
    }
    return rows;
}

void make(const study::Study& study, const std::vector<study::Row>& rows, bool keeps_table) {
    const auto begin = Clock::now();
    std::size_t done = 0, failed = 0;
    const auto ended = [&](const study::Row& row, int status) {
        ++done;
        failed += status != 0;
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        const auto left = static_cast<double>(rows.size() - done);
        fmt::print(stderr, "run {}: {}. {} of {} done, {} failed, ETA {}\n", row.number,
                   status == 0 ? "normal" : fmt::format("failed ({})", status), done, rows.size(),
                   failed, io::duration_text(seconds / static_cast<double>(done) * left));
        if (keeps_table) study::write_csv(study::gather(study));
    };
    study::make_runs(study, rows, study::this_program(), ended);
}

int tell(const study::Study& study) {
    const study::Table table = study::gather(study);
    study::write_csv(table);
    study::write_h5(table);
    fmt::print("{}", study::table_text(table));
    std::string files = fmt::format("{0}/study.csv, {0}/study.h5", study.folder.string());
    if (study.plan == study::Plan::STAR) {
        const std::string text = study::convergence_text(table);
        fmt::print("\n{}", text);
        io::replace_text(study.folder / "convergence.md", text);
        files += fmt::format(", {}/convergence.md", study.folder.string());
    }
    std::size_t bad = 0;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const study::Outcome& outcome = table.outcomes[k];
        if (outcome.is_finished && outcome.status == 0) continue;
        ++bad;
        fmt::print(stderr, "run {}: {}\n", table.rows[k].number,
                   outcome.is_finished ? outcome.reason : "missing");
    }
    fmt::print("{}\n", files);
    return bad == 0 ? 0 : 1;
}

}  // namespace

int study(const StudyArguments& arguments) {
    study::Study study = study::read_study(arguments.file);
    if (!arguments.folder.empty()) study.folder = arguments.folder;
    if (arguments.workers > 0) {
        study.workers = arguments.workers;
        study.says_workers = true;
    }
    if (!arguments.only_table) study::expect_known_names(study);
    std::filesystem::create_directories(study.folder);
    if (arguments.only_table) return tell(study);
    const bool is_all = arguments.share.empty();
    using Kind = io::FolderLock::Kind;
    std::optional<io::FolderLock> lock;  // a share works beside others
    lock.emplace(study.folder, is_all ? Kind::OWN : Kind::SHARED);
    if (arguments.slurm) lock.reset();  // for the shares
    const study::Share share = share_of(arguments.share);
    const std::vector<study::Row> rows =
        missing(study::gather(study), share, arguments.retry_failed);
    if (arguments.slurm) {
        const char* options = arguments.retry_failed ? " --retry-failed" : "";
        fmt::print("{}\n",
                   study::submit(study, study::rows(study).size(), study::this_program(), options));
        return 0;
    }
    if (is_all) {
        study::share_machine(study, rows.size(), {parallel::cores(), parallel::processors()});
        fmt::print(stderr, "{} runs, {} to make, {} at a time, {} thread{} each\n",
                   study::rows(study).size(), rows.size(), study.workers, study.threads,
                   study.threads == 1 ? "" : "s");
    } else {
        study.workers = 1;  // Slurm's array is what works in parallel
    }
    make(study, rows, is_all);
    return is_all ? tell(study) : 0;
}

}  // namespace corpuscle::tools
