// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/confined.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// Exit status of the child: its bytes, or what it threw, are in the pipe; or memory ran out.
enum Outcome : int { DONE = 0, THREW = 1, NO_MEMORY = 2 };

/// Sanitizers reserve more addresses than anybody would allow.
#ifndef __has_feature
#define __has_feature(what) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool CAN_LIMIT_MEMORY = false;
#else
constexpr bool CAN_LIMIT_MEMORY = true;
#endif

void set_limit(decltype(RLIMIT_AS) what, rlim_t value) {
    rlimit limit{};
    getrlimit(what, &limit);
    limit.rlim_cur = std::min(value, limit.rlim_max);
    setrlimit(what, &limit);
}

/// Addresses that this process has now. [byte]
std::uint64_t memory_now() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void write_all(int to, const char* from, std::size_t size) {
    while (size > 0) {
        const ssize_t n = write(to, from, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) _exit(THREW);  // nobody listens any more
        from += n;
        size -= static_cast<std::size_t>(n);
    }
}

[[noreturn]] void be_child(const std::function<std::vector<char>()>& reader, const Limits& limits,
                           int to) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM})
        std::signal(number, SIG_DFL);
    set_limit(RLIMIT_CORE, 0);
    if (limits.is_mute)
        if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
            dup2(nowhere, STDERR_FILENO);
    std::signal(SIGXCPU, SIG_DFL);
    set_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
    if (CAN_LIMIT_MEMORY) set_limit(RLIMIT_AS, memory_now() + limits.memory);
    try {
        const std::vector<char> bytes = reader();
        write_all(to, bytes.data(), bytes.size());
        _exit(DONE);
    } catch (const std::bad_alloc&) {
        _exit(NO_MEMORY);
    } catch (const std::exception& error) {
        write_all(to, error.what(), std::strlen(error.what()));
    } catch (...) {
    }
    _exit(THREW);
}

/// All that comes through the pipe until its end; false when time is up before that.
bool read_all(int from, double seconds, std::vector<char>& bytes) {
    using SteadyClock = std::chrono::steady_clock;
    const auto end = SteadyClock::now() + std::chrono::duration<double>(seconds);
    std::array<char, 65536> part;
    for (;;) {
        const double left = std::chrono::duration<double>(end - SteadyClock::now()).count();
        pollfd ready{from, POLLIN, 0};
        if (left <= 0.0) return false;
        if (poll(&ready, 1, 1 + static_cast<int>(1e3 * std::min(left, 1e3))) <= 0) continue;
        const ssize_t n = read(from, part.data(), part.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return true;
        bytes.insert(bytes.end(), part.data(), part.data() + n);
    }
}

}  // namespace

Confined confined(const std::function<std::vector<char>()>& reader, const Limits& limits) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw SystemError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    const pid_t child = fork();
    if (child < 0) {
        const int why = errno;
        close(ends[0]);
        close(ends[1]);
        throw SystemError(fmt::format("cannot start a process: {}", std::strerror(why)));
    }
    if (child == 0) be_child(reader, limits, ends[1]);
    close(ends[1]);
    std::vector<char> bytes;
    bool is_in_time = read_all(ends[0], Limits::WAIT * limits.seconds, bytes);
    close(ends[0]);
    if (!is_in_time) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    is_in_time = is_in_time && !(WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU);
    if (!is_in_time)
        return {{}, fmt::format("reading took more than {} s, given up", limits.seconds)};
    if (WIFSIGNALED(status))
        return {{},
                fmt::format("its reader crashed ({}), expected a file that is whole",
                            strsignal(WTERMSIG(status)))};
    if (WEXITSTATUS(status) == NO_MEMORY)
        return {{},
                fmt::format("reading asked for more than {:.3g} MB, given up",
                            1e-6 * static_cast<double>(limits.memory))};
    if (WEXITSTATUS(status) != DONE) return {{}, std::string(bytes.begin(), bytes.end())};
    return {std::move(bytes), {}};
}

}  // namespace corpuscle::io
