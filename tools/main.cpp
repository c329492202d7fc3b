// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The command line's main. Exit status: 0 normal, 2 bad input, 3 the physics broke, 1 anything else.

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>

#include "io/text/text.hpp"
#include "solver/base/error.hpp"
#include "tools/command_line.hpp"
#include "tools/commands/commands.hpp"

namespace {

using namespace corpuscle;

/// A package has the program twice: for any x86-64-v2, and beside it for processors with AVX2.
/// @returns  the faster one for this processor, or `self`
std::filesystem::path best_program(const std::filesystem::path& self) {
    const auto fast = self.parent_path().parent_path() / "libexec/corpuscle/corpuscle-x86-64-v3";
    std::error_code error;
    const bool fits = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi2");
    return fits && std::filesystem::exists(fast, error) ? fast : self;
}

/// Starts the program once more where that makes it faster; one that cannot tell where it lies, or
/// does not start, goes on as it is.
void start_well(char** argv) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) return;
    const auto best = best_program(self);
    if (best != self) execv(best.c_str(), argv);
}

int run(int argc, char** argv) {
    tools::CommandLine line;
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return line.app.exit(error) == 0 ? 0 : 2;
    }
    const std::string command = line.app.get_subcommands().front()->get_name();
    if (command == "run") return tools::run(line.run);
    if (command == "check") return tools::check(line.check, line.check_as_json);
    if (command == "new") return tools::new_deck(line.begin);
    if (command == "fold") return tools::fold(line.fold);
    if (command == "export") return tools::export_results(line.exports);
    if (command == "report") return tools::report(line.report);
    if (command == "study") return tools::study(line.study);
    if (command == "responses") return tools::responses(line.responses);
    if (command == "verify") return tools::verify_program(line.verify);
    return tools::mesh(line.mesh);
}

/// Standard output has taken all that was printed: a full disk shows only when buffers are emptied.
bool output_is_whole() {
    std::cout.flush();
    const bool is_whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
    if (!is_whole)
        fmt::print(stderr, "corpuscle: cannot write to standard output: {}\n",
                   errno != 0 ? std::strerror(errno) : "an error earlier on");
    return is_whole;
}

int guarded(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        for (const std::string& fault : error.faults) fmt::print(stderr, "{}\n", io::shown(fault));
        fmt::print(stderr, "corpuscle: {} fault{} in the input\n", error.faults.size(),
                   error.faults.size() == 1 ? "" : "s");
        return 2;
    } catch (const PhysicsError& error) {
        fmt::print(stderr, "corpuscle: the physics broke {}\n", error.what());
        return 3;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "corpuscle: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "corpuscle: {}\n", error.what());
    }
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    start_well(argv);
    // a file that grows beyond what the system grants is an error of its write, with a reason
    std::signal(SIGXFSZ, SIG_IGN);
    const int status = guarded(argc, argv);
    return output_is_whole() || status != 0 ? status : 1;
}
