// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/slurm.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "io/system/atomic_file.hpp"
#include "io/text/text.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::study {
namespace {

namespace fs = std::filesystem;

/// 'text' as a shell reads it back.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

bool is_on_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::stringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
    return false;
}

/// What sbatch --parsable prints: the job's number. @throws SystemError
std::string job_of(const std::string& command) {
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw SystemError("cannot start sbatch");
    std::string said;
    char part[256];
    while (std::fgets(part, sizeof(part), pipe) != nullptr) said += part;
    const int status = ::pclose(pipe);
    const std::string job(io::trim(said.substr(0, said.find_first_of(";\n"))));
    if (status != 0 || !io::parse_integer(job))
        throw SystemError(fmt::format("sbatch refused: {}", io::trim(said)));
    return job;
}

std::string script(const std::string& what) {
    return fmt::format("#!/bin/sh\ncd {}\nexec {}\n", quoted(fs::current_path().string()), what);
}

}  // namespace

std::string submit(const Study& study, std::size_t runs, const std::string& program,
                   const std::string& options) {
    if (!is_on_path("sbatch"))
        throw SystemError(
            "--slurm: there is no sbatch on the PATH; without --slurm the study runs on this "
            "machine");
    const std::size_t jobs = std::min(runs, MOST_JOBS);
    const fs::path folder = fs::absolute(study.folder);
    fs::create_directories(folder / "slurm");
    const std::string again =
        fmt::format("{} study {} -o {}", quoted(program), quoted(fs::absolute(study.file).string()),
                    quoted(folder.string()));
    io::replace_text(
        folder / "slurm" / "runs.sh",
        script(fmt::format("{}{} --share \"$SLURM_ARRAY_TASK_ID/{}\"", again, options, jobs)));
    io::replace_text(folder / "slurm" / "table.sh", script(fmt::format("{} --table", again)));
    const std::string array = job_of(fmt::format(
        "sbatch --parsable --job-name=corpuscle --array=0-{}%{} --cpus-per-task={} --output={} {}",
        jobs - 1, study.workers, study.threads, quoted((folder / "slurm" / "%A_%a.txt").string()),
        quoted((folder / "slurm" / "runs.sh").string())));
    const std::string table = job_of(fmt::format(
        "sbatch --parsable --job-name=corpuscle_table --dependency=afterany:{} --output={} {}",
        array, quoted((folder / "slurm" / "table.txt").string()),
        quoted((folder / "slurm" / "table.sh").string())));
    return fmt::format("{} runs in Slurm's array {} ({} at a time); job {} makes {} after it", runs,
                       array, study.workers, table, (folder / "study.csv").string());
}

}  // namespace corpuscle::study
