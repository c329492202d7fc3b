// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/command_line.hpp"

#include <charconv>
#include <cstdint>

#include "io/text/text.hpp"
#include "io/text/units.hpp"
#include "tools/version.hpp"

namespace corpuscle::tools {
namespace {

constexpr int MOST_THREADS = 1024;  ///< of any machine that this is meant for

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
void add_deck_options(CLI::App& command, DeckArguments& deck) {
    command.add_option("DECK", deck.file, "LS-DYNA keyword deck")->required();
    command.add_option("-D", deck.definitions, "NAME=VALUE, overrides a *PARAMETER of the deck")
        ->allow_extra_args(false)
        ->take_all();
    command.add_option("--seed", deck.seed, "seed of the random numbers")
        ->capture_default_str()
        ->check(whole_number);
    command.add_option("--until", deck.until, "end time instead of ENDTIM, in the deck's unit");
    command
        .add_option("-j,--threads", deck.threads,
                    "threads; default: one a core (OMP_NUM_THREADS if set)")
        ->check(CLI::Range(1, MOST_THREADS));
}

void add_run(CLI::App& app, RunArguments& to) {
    CLI::App& command = *app.add_subcommand("run", "run a deck; results go to DECK.out/results.h5");
    add_deck_options(command, to.deck);
    command.add_option("-o,--output", to.folder, "folder for the results; default: DECK.out");
    command.add_flag("--restart", to.restart, "go on from the last checkpoint, to the same end");
    command.add_flag("-q,--quiet", to.quiet, "no progress, no summary");
    command.footer(
        "Examples:\n"
        "  corpuscle run driver_bag_flat.k\n"
        "  corpuscle run driver_bag_flat.k -D NP=20000 -o coarse.out -j 2\n"
        "  corpuscle run driver_bag_flat.k --restart");
}

void add_check(CLI::App& app, DeckArguments& to, bool& as_json) {
    CLI::App& command = *app.add_subcommand(
        "check",
        "say what a deck holds, needs and leaves out, with an estimate of the cost; run nothing");
    add_deck_options(command, to);
    command.add_flag("--json", as_json, "errors, warnings, notes and mendings, for scripts");
    command.footer(
        "Examples:\n"
        "  corpuscle check driver_bag_flat.k\n"
        "  corpuscle check driver_bag_flat.k -D NP=20000 --json");
}

void add_mesh(CLI::App& app, MeshArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "mesh", "turn a surface mesh (STL, OBJ, PLY, ...) into a welded, checked deck");
    command.add_option("IN", to.input, "mesh file")->required();
    command.add_option("-o,--output", to.output, "deck to write")->required();
    command.footer("Example:\n  corpuscle mesh head.stl -o head.k");
}

void add_new(CLI::App& app, NewArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "new", "a commented starting deck for a mesh or a folded bag, with guesses to think about");
    command.add_option("--from", to.from, "mesh (STL, OBJ, ...), deck of a mesh, or recipe")
        ->required();
    command.add_option("-o,--output", to.output, "deck to write; its mesh is beside it");
    command.add_flag("--head", to.head, "with a headform over the bag, and a study of its speed");
    command.footer(
        "Examples:\n"
        "  corpuscle new --from disc.stl --head -o bag.k\n"
        "  corpuscle new --from models/recipes/zigzag.toml -o folded.k");
}

void add_fold(CLI::App& app, FoldArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "fold",
        "cut, sew and fold a bag as a recipe says; the deck holds the folded mesh and its "
        "flat reference geometry, and a section of the pack is drawn beside it");
    command.add_option("RECIPE", to.recipe, "recipe in TOML")->required();
    command.add_option("-o,--output", to.output, "deck to write; the section is beside it, .svg")
        ->required();
    command.footer(
        "Examples:\n"
        "  corpuscle fold models/recipes/zigzag.toml -o bag.k\n"
        "  corpuscle fold models/driver_bag_folded/fold.toml -o mesh.k\n"
        "tools/fold/README.md says what a recipe may hold.");
}

void add_responses(CLI::App& app, ResponsesArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "responses",
        "what rigid bodies felt: peak force and accelerations by CFC 60 to 1000, 3 ms clip, HIC, "
        "impulse, rebound, energy, intrusion; also to DIR/responses.json");
    command.add_option("DIR", to.folder, "folder of a run's results")->required();
    command.add_option("--body", to.body, "part id of one body; default: all");
    command.add_option("--units", to.units, io::unit_systems() + ", where the results do not know");
    command.add_flag("--json", to.json, "print JSON instead of a table");
    command.footer(
        "Examples:\n"
        "  corpuscle responses oop_linear.out\n"
        "  corpuscle responses oop_linear.out --body 100 --json");
}

void add_study(CLI::App& app, StudyArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "study",
        "run a deck at many points and seeds into one table, study.csv and study.h5; started "
        "again, it makes only the runs that are missing");
    command.add_option("STUDY", to.file, "study in TOML")->required();
    command.add_option("-o,--output", to.folder, "folder; default: STUDY.study");
    command
        .add_option(
            "-w,--workers", to.workers,
            "runs at a time; default: as it says, else one a hardware thread, or fewer with "
            "several threads each where there are fewer runs than cores")
        ->check(CLI::PositiveNumber);
    command.add_flag("--retry-failed", to.retry_failed, "make failed runs again");
    command.add_flag("--slurm", to.slurm, "an array of jobs by sbatch, and a table after it");
    command.add_flag("--table", to.only_table, "only the table of what is there");
    command.add_option("--share", to.share, "K/N: every N-th run from the K-th (0 to N-1)");
    command.footer(
        "Examples:\n"
        "  corpuscle study oop.toml\n"
        "  corpuscle study oop.toml -w 4 --retry-failed\n"
        "  corpuscle study oop.toml --slurm\n"
        "tools/study/README.md says what a study may hold.");
}

void add_export(CLI::App& app, ExportArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "export",
        "write a run for other tools: CSV, binout (LSDA), d3plot, ISO-MME of the rigid bodies");
    command.add_option("DIR", to.folder, "folder of a run's results")->required();
    command.add_option("-o,--output", to.output, "folder to write to; default: DIR");
    command.add_flag("--csv", to.csv, "history.csv and history_fast.csv");
    command.add_flag("--binout", to.binout, "binout, as LS-PrePost and others read it");
    command.add_flag("--d3plot", to.d3plot, "d3plot, d3plot01, ...: shells and particles");
    command.add_flag("--no-particles", to.no_particles,
                     "d3plot of the shells alone, for readers that do not know the particles (VTK, "
                     "ParaView)");
    command.add_flag(
        "--iso-mme", to.iso_mme,
        "iso_mme: what rigid bodies that can move felt, as test data come (ISO/TS 13499)");
    command.footer("Example:\n  corpuscle export driver_bag_flat.out --csv --binout");
}

void add_report(CLI::App& app, ReportArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "report",
        "one page for the browser, whole in itself: the deployment in 3-D with its curves, "
        "responses, settings and energy books; of a study: its table");
    command.add_option("DIR", to.folders, "folders of runs, or of a study")->required();
    command.add_option("-o,--output", to.output, "page to write; default: DIR/report.html");
    command.add_option("--png", to.png,
                       "folder for pictures of the first run and a strip of them; needs Chromium");
    command.footer(
        "Examples:\n"
        "  corpuscle report driver_bag_flat.out\n"
        "  corpuscle report fine.out coarse.out -o compare.html\n"
        "  corpuscle report driver_bag_flat.out --png pictures");
}

void add_verify(CLI::App& app, VerifyArguments& to) {
    CLI::App& command = *app.add_subcommand(
        "verify",
        "run the cases of models/verification and hold them to what is known exactly: one table, "
        "and one page with errors, their uncertainty, orders of convergence, costs and verdicts");
    command.add_option("CASE", to.names, "cases to run; default: all");
    auto* const quick = command.add_flag("--quick", to.quick, "some minutes; the default");
    command.add_flag("--full", to.full, "more particles, finer meshes, more seeds: some hours")
        ->excludes(quick);
    command.add_flag("--list", to.only_list, "say which cases there are; run nothing");
    command.add_option("-o,--output", to.output,
                       "page to write (.html), or a table in Markdown (.md); default: "
                       "verification.html");
    command.add_option("-j,--workers", to.workers, "runs at a time; default: one a core")
        ->check(CLI::PositiveNumber);
    command.add_option("--runs", to.folder,
                       "folder for the runs; those that it has are not made again; default: the "
                       "page's name with .runs");
    command.add_option("--cases", to.cases,
                       "folder of cases; default: models/verification of the source tree or "
                       "installation that the program is in");
    command
        .add_option("--known", to.known,
                    "CASE/QUANTITY that is known to miss its budget: it stays red, but the "
                    "exit status does not count it")
        ->allow_extra_args(false)
        ->take_all();
    command.footer(
        "Examples:\n"
        "  corpuscle verify --quick\n"
        "  corpuscle verify --full -o full.html -j 8\n"
        "  corpuscle verify sod fast_piston -o tubes.html\n"
        "  corpuscle verify --list\n"
        "Exit status 0 when every budget holds, 1 when one is missed or a run failed.");
}

}  // namespace

CommandLine::CommandLine()
    : app("corpuscle deploys airbags: membrane finite elements, gas by the corpuscular method and "
          "contact, from LS-DYNA keyword decks.") {
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    app.footer(
        "Examples:\n"
        "  corpuscle run driver_bag_flat.k -D NP=20000\n"
        "  corpuscle check driver_bag_flat.k\n"
        "  corpuscle fold driver_bag.toml -o mesh.k\n"
        "  corpuscle mesh head.stl -o head.k\n"
        "  corpuscle new --from disc.stl -o bag.k\n"
        "  corpuscle study oop.toml\n"
        "  corpuscle report driver_bag_flat.out\n"
        "  corpuscle verify --quick");

    add_run(app, run);
    add_check(app, check, check_as_json);
    add_mesh(app, mesh);
    add_new(app, begin);
    add_fold(app, fold);
    add_responses(app, responses);
    add_study(app, study);
    add_export(app, exports);
    add_report(app, report);
    add_verify(app, verify);
}

}  // namespace corpuscle::tools
