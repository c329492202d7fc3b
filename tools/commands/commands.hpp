// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace corpuscle {
class Simulation;
}

/// The commands behind `corpuscle COMMAND`; each returns the program's exit status or throws.
namespace corpuscle::tools {

struct DeckArguments {
    std::string file;
    std::vector<std::string> definitions;  ///< NAME=VALUE
    std::uint64_t seed = 1;
    std::optional<double> until;  ///< end time        [s]
    int threads = 0;              ///< 0: one a core
};

struct RunArguments {
    DeckArguments deck;
    std::string folder;  ///< empty: the deck's name without its suffix + ".out"
    bool quiet = false;
    bool restart = false;
};

struct MeshArguments {
    std::string input, output;
};

struct NewArguments {
    std::string from;    ///< mesh, deck of a mesh, or recipe
    std::string output;  ///< empty: the name of `from` with .new.k
    bool head = false;   ///< with a headform and a study of its speed
};

struct FoldArguments {
    std::string recipe, output;
};

struct ResponsesArguments {
    std::string folder;
    std::optional<int> body;  ///< part id; none: all
    std::string units;        ///< empty: those of the results
    bool json = false;
};

struct StudyArguments {
    std::string file;
    std::string folder;         ///< empty: as the study says
    int workers = 0;            ///< 0: as the study says
    bool retry_failed = false;  ///< failed runs count as missing
    bool slurm = false;         ///< hand the runs to sbatch
    bool only_table = false;    ///< make no runs
    std::string share;          ///< "K/N": only every N-th run from the K-th on, no table
};

struct ExportArguments {
    std::string folder;
    std::string output;  ///< empty: the same folder
    bool csv = false, binout = false, d3plot = false, iso_mme = false;
    bool no_particles = false;  ///< in d3plot
};

struct ReportArguments {
    std::vector<std::string> folders;
    std::string output;  ///< empty: report.html in the first folder
    std::string png;     ///< folder for pictures; empty: none
};

struct VerifyArguments {
    std::vector<std::string> names;  ///< of cases; empty: all
    bool quick = false;              ///< as without either
    bool full = false;
    bool only_list = false;
    std::string output;              ///< page or Markdown; empty: verification.html
    std::string folder;              ///< of the runs; empty: the page's name with .runs
    std::string cases;               ///< empty: models/verification beside the program
    std::vector<std::string> known;  ///< CASE/QUANTITY that is known to miss its budget
    int workers = 0;                 ///< runs at a time; 0: one a core
};

int run(const RunArguments& arguments);
int check(const DeckArguments& arguments, bool as_json = false);
int mesh(const MeshArguments& arguments);
int new_deck(const NewArguments& arguments);
int fold(const FoldArguments& arguments);
int responses(const ResponsesArguments& arguments);
int study(const StudyArguments& arguments);
int export_results(const ExportArguments& arguments);
int report(const ReportArguments& arguments);
int verify_program(const VerifyArguments& arguments);

/// Nothing that a command reads is written over.
/// @throws InputError  where the output is one of the inputs, by whatever names
void expect_no_input(const std::filesystem::path& output,
                     const std::vector<std::filesystem::path>& inputs);

/// The deck's scene with its -D values and --until, on the threads that are asked for.
/// @throws InputError with file and line of each fault, also of those that only the scene shows.
Simulation load(const DeckArguments& arguments);

}  // namespace corpuscle::tools
