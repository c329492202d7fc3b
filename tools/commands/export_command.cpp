// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <filesystem>

#include "io/export/binout.hpp"
#include "io/export/d3plot.hpp"
#include "io/export/history_source.hpp"
#include "io/export/iso_mme.hpp"
#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"

namespace corpuscle::tools {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
    io::replace_text(file, text);
    fmt::print("{}\n", file.string());
}

void check(const ExportArguments& arguments) {
    std::vector<std::string> faults;
    if (!fs::exists(fs::path(arguments.folder) / "results.h5"))
        faults.push_back(fmt::format("{}: expected a folder with results.h5", arguments.folder));
    if (!arguments.csv && !arguments.binout && !arguments.d3plot && !arguments.iso_mme &&
        faults.empty())
        faults.emplace_back("export: expected --csv, --binout, --d3plot or --iso-mme");
    if (!faults.empty()) throw InputError(faults);
}

/// Of the folder: "oop_linear" of oop_linear.out.
std::string test_name(const fs::path& folder) {
    return fs::absolute(folder / ".").parent_path().filename().replace_extension("").string();
}

/// TO/NAME/NAME.mme and its channels; a run that has nothing for them is told so.
void export_iso_mme(const io::Hdf5Reader& results, const std::string& name, const fs::path& to) {
    try {
        io::write_iso_mme(results, name, [&](const std::string& file, const std::string& bytes) {
            fs::create_directories((to / name / file).parent_path());
            write(to / name / file, bytes);
        });
    } catch (const InputError& nothing) {
        for (const std::string& why : nothing.faults)
            fmt::print(stderr, "warning: skipped {}\n", why);
    }
}

}  // namespace

int export_results(const ExportArguments& arguments) {
    check(arguments);
    const fs::path from = arguments.folder;
    const fs::path to = arguments.output.empty() ? from : fs::path(arguments.output);
    fs::create_directories(to);
    const io::Hdf5Reader results(from / "results.h5");
    if (arguments.csv) {
        write(to / "history.csv", io::csv_text(io::read_histories(results, "/history")));
        if (results.has("/history_fast"))
            write(to / "history_fast.csv",
                  io::csv_text(io::read_histories(results, "/history_fast")));
    }
    if (arguments.binout) write(to / "binout", io::binout(results));
    if (arguments.d3plot)
        io::write_d3plot(
            results,
            [&](const std::string& name, const std::string& bytes) { write(to / name, bytes); },
            !arguments.no_particles);
    if (arguments.iso_mme) export_iso_mme(results, test_name(from), to);
    return 0;
}

}  // namespace corpuscle::tools
