// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/workers.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <map>

#include "io/system/atomic_file.hpp"
#include "io/text/text.hpp"
#include "solver/base/error.hpp"
#include "tools/study/outcome.hpp"

namespace corpuscle::study {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

/// Was this very run begun before? From now on it was.
bool was_begun(const Study& study, const Row& row) {
    const fs::path file = folder_of(study, row) / "key";
    const std::string key = key_of(study, row);
    std::string before;
    std::ifstream in(file);
    if (std::getline(in, before) && before == key) return true;
    io::replace_text(file, key + "\n");
    return false;
}

/// @param goes_on  from its last checkpoint, if it left one
std::vector<std::string> command_of(const Study& study, const Row& row, const std::string& program,
                                    bool goes_on) {
    std::vector<std::string> words{program,
                                   "run",
                                   deck_of(study, row).string(),
                                   "-o",
                                   folder_of(study, row).string(),
                                   "--seed",
                                   fmt::format("{}", row.seed),
                                   "-j",
                                   fmt::format("{}", study.threads)};
    if (study.until) {
        words.emplace_back("--until");
        words.push_back(fmt::format("{}", *study.until));
    }
    if (goes_on) words.emplace_back("--restart");
    for (const std::string& definition : definitions_of(study, row)) {
        words.emplace_back("-D");
        words.push_back(definition);
    }
    return words;
}

/// Everything the child needs is made before the fork: after it only system calls are safe.
pid_t start(const std::vector<std::string>& words, const fs::path& log) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (out < 0)
        throw SystemError(fmt::format("cannot write {}: {}", log.string(), std::strerror(errno)));
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    ::close(out);
    if (child < 0) throw SystemError(fmt::format("cannot start a run: {}", std::strerror(errno)));
    return child;
}

/// Why a run failed, in its own words: what it said as `corpuscle: ...`, or the fault before "1
/// fault in the input"; else its last line.
std::string reason_of(const fs::path& log, int wait_status) {
    if (WIFSIGNALED(wait_status)) return fmt::format("killed by signal {}", WTERMSIG(wait_status));
    constexpr std::string_view MARK = "corpuscle: ";
    std::ifstream in(log);
    std::string line, before, verdict;
    while (std::getline(in, line)) {
        const std::string said(io::trim(line));
        if (said.starts_with(MARK)) {
            const bool is_count = said.find("in the input") != std::string::npos;
            verdict = is_count ? before : said.substr(MARK.size());
        }
        if (!said.empty()) before = said;
    }
    return verdict.empty() ? before : verdict;
}

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

class Workers {
public:
    using Ended = std::function<void(const Job&, int status)>;
    Workers(int most, const std::string& program, const Ended& ended)
        : most_(static_cast<std::size_t>(most)), program_(program), ended_(ended) {}
    ~Workers() { stop(); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] bool is_full() const { return at_work_.size() >= most_; }
    [[nodiscard]] bool is_idle() const { return at_work_.empty(); }

    void begin(const Job& job) {
        const auto& [study, row] = job;
        const fs::path folder = folder_of(*study, row);
        fs::create_directories(folder);
        // one that has an end is made anew, one that was broken off goes on
        const bool has_end = fs::remove(folder / "status");
        const bool goes_on = was_begun(*study, row) && !has_end;
        const pid_t child = start(command_of(*study, row, program_, goes_on), folder / "log.txt");
        at_work_.emplace(child, Begun{job, Clock::now()});
    }
    /// Waits for the end of one run.
    void wait() {
        int status = 0;
        rusage used{};
        const pid_t child = ::wait4(-1, &status, 0, &used);
        if (interrupted) throw SystemError("interrupted");
        const auto found = at_work_.find(child);
        if (found == at_work_.end()) return;
        const Job job = found->second.job;
        const auto& [study, row] = job;
        const Cost cost{std::chrono::duration<double>(Clock::now() - found->second.begun).count(),
                        seconds_of(used.ru_utime) + seconds_of(used.ru_stime)};
        at_work_.erase(found);
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        write_status(*study, row, code, cost,
                     code == 0 ? "" : reason_of(folder_of(*study, row) / "log.txt", status));
        ended_(job, code);
    }

private:
    struct Begun {
        Job job;
        Clock::time_point begun;
    };
    void stop() {
        for (const auto& [child, job] : at_work_) ::kill(child, SIGTERM);
        for (const auto& [child, job] : at_work_)
            while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
        at_work_.clear();
    }

    std::size_t most_;
    const std::string& program_;
    const Ended& ended_;
    std::map<pid_t, Begun> at_work_;
};

}  // namespace

void make_jobs(const std::vector<Job>& jobs, int workers, const std::string& program,
               const std::function<void(const Job&, int status)>& ended) {
    struct sigaction on_stop {};
    on_stop.sa_handler = [](int) { interrupted = 1; };  // no SA_RESTART: waitpid must return
    ::sigaction(SIGINT, &on_stop, nullptr);
    ::sigaction(SIGTERM, &on_stop, nullptr);
    Workers team(workers, program, ended);
    for (const Job& job : jobs) {
        while (team.is_full()) team.wait();
        if (interrupted) throw SystemError("interrupted");
        team.begin(job);
    }
    while (!team.is_idle()) team.wait();
}

void make_runs(const Study& study, const std::vector<Row>& rows, const std::string& program,
               const Ended& ended) {
    std::vector<Job> jobs;
    for (const Row& row : rows) jobs.push_back({&study, row});
    make_jobs(jobs, study.workers, program,
              [&](const Job& job, int status) { ended(job.row, status); });
}

std::string this_program() {
    std::error_code why;
    const fs::path program = fs::read_symlink("/proc/self/exe", why);
    if (why) throw SystemError(fmt::format("cannot tell my own path: {}", why.message()));
    return program.string();
}

}  // namespace corpuscle::study
