// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/responses/body_responses.hpp"
#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"

namespace corpuscle::tools {
namespace {

/// The file's own units, or those that the user says they are.
std::string units_for(const io::Hdf5Reader& file, const ResponsesArguments& arguments) {
    const std::string own = file.text("/", "unit_system");
    if (arguments.units.empty()) return own;
    const std::string said(io::unit_system_named(arguments.units));
    if (said.empty())
        throw InputError(
            fmt::format("--units {}: expected {}", arguments.units, io::unit_systems()));
    if (io::scale_of(own) && own != said)
        throw InputError(fmt::format("--units {}: the results are in {}", arguments.units, own));
    return said;
}

std::vector<int> asked_for(const io::Hdf5Reader& file, const ResponsesArguments& arguments) {
    const std::vector<int> all = io::tracked_bodies(file);
    if (all.empty() && file.read<double>("/history/time").empty())
        throw InputError(fmt::format(
            "{}: the run has no histories yet: expected one that has come to its first sample",
            arguments.folder));
    if (all.empty())
        throw InputError(fmt::format(
            "{}: the run had no rigid body that can move, so there is nothing to respond",
            arguments.folder));
    if (!arguments.body) return all;
    if (std::find(all.begin(), all.end(), *arguments.body) == all.end())
        throw InputError(
            fmt::format("--body {}: expected one of {}", *arguments.body, fmt::join(all, ", ")));
    return {*arguments.body};
}

}  // namespace

int responses(const ResponsesArguments& arguments) {
    const std::filesystem::path folder = arguments.folder;
    if (!std::filesystem::exists(folder / "results.h5"))
        throw InputError(fmt::format("{}: expected a folder with results.h5", arguments.folder));
    const io::Hdf5Reader file(folder / "results.h5");
    const std::string units = units_for(file, arguments);
    std::vector<io::BodyTable> tables;
    for (const int id : asked_for(file, arguments))
        tables.push_back({id, io::body_responses(io::read_motion(file, id), units)});
    const std::string json = io::responses_json(tables);
    io::replace_text(folder / "responses.json", json);
    if (arguments.json) {
        fmt::print("{}", json);
        return 0;
    }
    for (const io::BodyTable& table : tables) fmt::print("{}", io::responses_text(table));
    fmt::print("{}\n", (folder / "responses.json").string());
    return 0;
}

}  // namespace corpuscle::tools
