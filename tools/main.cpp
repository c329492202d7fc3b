// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The command line: corpuscle run | check | fold | mesh | responses | study |
// export | report. Exit status 0 normal,
// 2 bad input, 3 the physics broke, 1 anything else.

#include <fmt/core.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>

#include "io/text.hpp"
#include "solver/base/error.hpp"
#include "tools/commands.hpp"

namespace {

using namespace corpuscle;

/// Threads that wait for each other spin for a tenth of a millisecond, then sleep. GNU's OpenMP has
/// them spin a hundred times as long, in which another program that wants a core makes every step
/// wait for it. It reads this before main, so the program starts once more with it; whoever has set
/// either variable is left alone, and so is a program that cannot tell where it lies.
void spin_briefly(char** argv) {
    if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr)
        return;
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error || setenv("GOMP_SPINCOUNT", "3000", 1) != 0) return;
    execv(self.c_str(), argv);  // does not return, unless it fails: then all goes on as it was
}

constexpr int MOST_THREADS = 1024;  ///< a team of very many overflows the stack of GNU's OpenMP

/// CLI11 reads -3 as an unsigned number close to 2^64, and whatever is above that as the greatest.
std::string whole_number(const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc{} && read.ptr == end
               ? std::string()
               : "expected a whole number, 0 to 18446744073709551615, not " + io::shown(text);
}

/// Common to all commands that read a deck.
void add_deck_options(CLI::App& command, tools::DeckArguments& deck) {
    command.add_option("DECK", deck.file, "LS-DYNA keyword deck")->required();
    command.add_option("-D", deck.definitions, "NAME=VALUE, overrides a *PARAMETER of the deck")
        ->allow_extra_args(false)
        ->take_all();
    command.add_option("--seed", deck.seed, "seed of the random numbers")
        ->capture_default_str()
        ->check(whole_number);
    command.add_option("--until", deck.until, "end time instead of ENDTIM, in the deck's unit");
    command.add_option("-j,--threads", deck.threads, "threads; default: one a core")
        ->check(CLI::Range(1, MOST_THREADS));
}

int run(int argc, char** argv) {
    CLI::App app{
        "corpuscle deploys airbags: membrane finite elements, gas by the corpuscular method and "
        "contact, from LS-DYNA keyword decks."};
    app.set_version_flag("--version", std::string(tools::VERSION));
    app.require_subcommand(1);
    app.footer(
        "Examples:\n"
        "  corpuscle run driver_bag_flat.k -D NP=20000\n"
        "  corpuscle check driver_bag_flat.k\n"
        "  corpuscle fold driver_bag.toml -o mesh.k\n"
        "  corpuscle mesh head.stl -o head.k\n"
        "  corpuscle new --from disc.stl -o bag.k\n"
        "  corpuscle study oop.toml\n"
        "  corpuscle report driver_bag_flat.out");

    tools::RunArguments to_run;
    CLI::App* run = app.add_subcommand("run", "run a deck; results go to DECK.out/results.h5");
    add_deck_options(*run, to_run.deck);
    run->add_option("-o,--output", to_run.folder, "folder for the results; default: DECK.out");
    run->add_flag("--restart", to_run.restart, "go on from the last checkpoint, to the same end");
    run->add_flag("-q,--quiet", to_run.quiet, "no progress, no summary");

    tools::DeckArguments to_check;
    bool check_as_json = false;
    CLI::App* check = app.add_subcommand(
        "check",
        "say what a deck holds, needs and leaves out, with an estimate of the cost; run nothing");
    add_deck_options(*check, to_check);
    check->add_flag("--json", check_as_json, "errors, warnings, notes and mendings, for scripts");

    tools::MeshArguments to_mesh;
    CLI::App* mesh = app.add_subcommand(
        "mesh", "turn a surface mesh (STL, OBJ, PLY, ...) into a welded, checked deck");
    mesh->add_option("IN", to_mesh.input, "mesh file")->required();
    mesh->add_option("-o,--output", to_mesh.output, "deck to write")->required();

    tools::NewArguments to_begin;
    CLI::App* begin = app.add_subcommand(
        "new", "a commented starting deck for a mesh or a folded bag, with guesses to think about");
    begin->add_option("--from", to_begin.from, "mesh (STL, OBJ, ...), deck of a mesh, or recipe")
        ->required();
    begin->add_option("-o,--output", to_begin.output, "deck to write; its mesh is beside it");
    begin->add_flag("--head", to_begin.head,
                    "with a headform over the bag, and a study of its speed");
    begin->footer(
        "Examples:\n"
        "  corpuscle new --from disc.stl --head -o bag.k\n"
        "  corpuscle new --from models/recipes/zigzag.toml -o folded.k");

    tools::FoldArguments to_fold;
    CLI::App* fold = app.add_subcommand(
        "fold",
        "cut, sew and fold a bag as a recipe says; the deck holds the folded mesh and its "
        "flat reference geometry, and a section of the pack is drawn beside it");
    fold->add_option("RECIPE", to_fold.recipe, "recipe in TOML")->required();
    fold->add_option("-o,--output", to_fold.output, "deck to write; the section is beside it, .svg")
        ->required();
    fold->footer(
        "Examples:\n"
        "  corpuscle fold models/recipes/zigzag.toml -o bag.k\n"
        "  corpuscle fold models/driver_bag_folded/fold.toml -o mesh.k\n"
        "tools/fold/README.md says what a recipe may hold.");

    tools::ResponsesArguments to_respond;
    CLI::App* responses = app.add_subcommand(
        "responses",
        "what rigid bodies felt: peak force and accelerations by CFC 60 to 1000, 3 ms clip, HIC, "
        "impulse, rebound, energy, intrusion; also to DIR/responses.json");
    responses->add_option("DIR", to_respond.folder, "folder of a run's results")->required();
    responses->add_option("--body", to_respond.body, "part id of one body; default: all");
    responses->add_option("--units", to_respond.units,
                          "SI, kg-mm-ms-K or ton-mm-s-K, where the results do not know");
    responses->add_flag("--json", to_respond.json, "print JSON instead of a table");
    responses->footer(
        "Examples:\n"
        "  corpuscle responses oop_linear.out\n"
        "  corpuscle responses oop_linear.out --body 100 --json");

    tools::StudyArguments to_study;
    CLI::App* study = app.add_subcommand(
        "study",
        "run a deck at many points and seeds into one table, study.csv and study.h5; started "
        "again, it makes only the runs that are missing");
    study->add_option("STUDY", to_study.file, "study in TOML")->required();
    study->add_option("-o,--output", to_study.folder, "folder; default: STUDY.study");
    study->add_option("-w,--workers", to_study.workers, "runs at a time; default: as it says")
        ->check(CLI::PositiveNumber);
    study->add_flag("--retry-failed", to_study.retry_failed, "make failed runs again");
    study->add_flag("--slurm", to_study.slurm, "an array of jobs by sbatch, and a table after it");
    study->add_flag("--table", to_study.only_table, "only the table of what is there");
    study->add_option("--share", to_study.share, "K/N: every N-th run from the K-th (0 to N-1)");
    study->footer(
        "Examples:\n"
        "  corpuscle study oop.toml\n"
        "  corpuscle study oop.toml -w 4 --retry-failed\n"
        "  corpuscle study oop.toml --slurm\n"
        "tools/study/README.md says what a study may hold.");

    tools::ExportArguments to_export;
    CLI::App* exports = app.add_subcommand(
        "export",
        "write a run for other tools: CSV, binout (LSDA), d3plot of the shells, ISO-MME of the "
        "rigid bodies");
    exports->add_option("DIR", to_export.folder, "folder of a run's results")->required();
    exports->add_option("-o,--output", to_export.output, "folder to write to; default: DIR");
    exports->add_flag("--csv", to_export.csv, "history.csv and history_fast.csv");
    exports->add_flag("--binout", to_export.binout, "binout, as LS-PrePost and others read it");
    exports->add_flag("--d3plot", to_export.d3plot, "d3plot, d3plot01, ...: the shells");
    exports->add_flag(
        "--iso-mme", to_export.iso_mme,
        "iso_mme: what rigid bodies that can move felt, as test data come (ISO/TS 13499)");
    exports->footer("Example:\n  corpuscle export driver_bag_flat.out --csv --binout");

    tools::ReportArguments to_report;
    CLI::App* report = app.add_subcommand(
        "report",
        "one page for the browser, whole in itself: the deployment in 3-D with its curves, "
        "responses, settings and energy books; of a study: its table");
    report->add_option("DIR", to_report.folders, "folders of runs, or of a study")->required();
    report->add_option("-o,--output", to_report.output, "page to write; default: DIR/report.html");
    report->add_option("--png", to_report.png,
                       "folder for pictures of the first run and a strip of them; needs Chromium");
    report->footer(
        "Examples:\n"
        "  corpuscle report driver_bag_flat.out\n"
        "  corpuscle report fine.out coarse.out -o compare.html\n"
        "  corpuscle report driver_bag_flat.out --png pictures");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (*run) return tools::run(to_run);
    if (*check) return tools::check(to_check, check_as_json);
    if (*begin) return tools::new_deck(to_begin);
    if (*fold) return tools::fold(to_fold);
    if (*exports) return tools::export_results(to_export);
    if (*report) return tools::report(to_report);
    if (*study) return tools::study(to_study);
    if (*responses) return tools::responses(to_respond);
    return tools::mesh(to_mesh);
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
    spin_briefly(argv);
    // a file that grows beyond what the system grants is an error of its write, with a reason
    std::signal(SIGXFSZ, SIG_IGN);
    const int status = guarded(argc, argv);
    return output_is_whole() || status != 0 ? status : 1;
}
