// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "io/export/binout.hpp"
#include "io/export/d3plot.hpp"
#include "io/export/history_source.hpp"
#include "io/results/ascii_files.hpp"
#include "io/results/hdf5.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::tools {
namespace {

namespace fs = std::filesystem;

std::vector<std::pair<int, std::string>> titles_of(const Model& model) {
    std::vector<std::pair<int, std::string>> titles;
    for (const Part& part : model.parts) titles.emplace_back(part.id, part.title);
    return titles;
}

/// Pressure outside of each airbag.
std::vector<std::pair<int, double>> ambient_of(const Model& model) {
    std::vector<std::pair<int, double>> all;
    for (const gas::BagCard& bag : model.bags) all.emplace_back(bag.id, bag.p_atm);
    for (const gas::UniformBagCard& bag : model.uniform_bags) all.emplace_back(bag.id, bag.p_atm);
    return all;
}

/// Against the first load that pulls on everything.
std::string up_of(const Model& model) {
    for (const BodyLoad& load : model.body_loads) {
        if (!load.parts.empty()) continue;
        const double pull = load.scale * (load.curve >= 0 ? model.curves[load.curve](0.0) : 1.0);
        if (pull != 0.0) return fmt::format("{}{}", pull > 0.0 ? "" : "-", "xyz"[load.axis]);
    }
    return "";
}

}  // namespace

io::RunInfo run_info(const Model& model, std::string_view version, std::uint64_t seed,
                     std::uint64_t scene) {
    return {"corpuscle",
            std::string(version),
            model.deck,
            model.unit_system,
            seed,
            parallel::threads(),
            fmt::format("{}", fmt::join(model.mendings, "\n")),
            scene,
            titles_of(model),
            ambient_of(model),
            up_of(model)};
}

namespace {

template <class Names>
bool is_among(const Names& names, const std::string& name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// d3plot, d3plot01 ...
bool is_d3plot(const std::string& name) {
    return name.starts_with("d3plot") &&
           name.find_first_not_of("0123456789", 6) == std::string::npos;
}

/// Of exports, responses and the summary.
bool is_export(const std::string& name) {
    constexpr std::array<std::string_view, 5> NAMES = {"binout", "history.csv", "history_fast.csv",
                                                       "responses.json", "run.json"};
    return is_d3plot(name) || is_among(NAMES, name);
}

/// Of the run itself.
bool is_result(const std::string& name) {
    constexpr std::array<std::string_view, 4> NAMES = {"results.h5", "results.xdmf",
                                                       "results.parts", "checkpoint"};
    return is_among(NAMES, name) || is_among(io::AsciiFiles::NAMES, name);
}

/// Longer than any path of a deck, which exports tell near their beginning.
constexpr std::size_t BEGINNING = 10000;

std::string beginning_of(const fs::path& file) {
    std::string text(BEGINNING, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
}

bool is_of_this_program(const fs::path& results) {
    try {
        return io::Hdf5Reader(results).text("/", "program") == "corpuscle";
    } catch (const SystemError&) {
        return false;  // damaged, or somebody else's
    }
}

bool is_own_summary(std::string_view text) {
    return text.starts_with("{\"wall\": ") && text.find("\"parallel\": ") != std::string_view::npos;
}

bool holds_own_results(const fs::path& folder) {
    return fs::is_directory(folder / "results.parts") ||
           beginning_of(folder / "checkpoint").starts_with("corpuscle checkpoint") ||
           is_own_summary(beginning_of(folder / "run.json")) ||
           (fs::exists(folder / "results.h5") && is_of_this_program(folder / "results.h5"));
}

/// By the beginning of a file that is not empty and has one of the names of is_export().
bool is_own_export(const std::string& name, std::string_view text) {
    if (is_d3plot(name)) return io::is_own_d3plot(text);
    if (name == "binout") return io::is_own_binout(text);
    if (name == "run.json") return is_own_summary(text);
    if (name == "responses.json") return text.starts_with("{\"bodies\": {");
    return io::is_own_csv(text);
}

/// Of another program, whatever lies beside it: exports, and text files that name another one.
bool is_foreign(const fs::path& file) {
    const std::string name = file.filename().string();
    const std::string text = beginning_of(is_d3plot(name) ? file.parent_path() / "d3plot" : file);
    if (is_among(io::AsciiFiles::NAMES, name))
        return std::count(text.begin(), text.end(), '\n') >= 2 && !io::AsciiFiles::is_own(text);
    return is_export(name) && !text.empty() && !is_own_export(name, text);
}

/// "a, b, ..." in alphabetical order, eight at most.
std::string names_listed(std::vector<std::string> names) {
    constexpr std::ptrdiff_t MOST = 8;
    std::sort(names.begin(), names.end());
    const auto end = names.begin() + std::min(MOST, std::ssize(names));
    return fmt::format(
        "{}{}", fmt::join(names.begin(), end, ", "),
        std::ssize(names) > MOST ? fmt::format(" and {} more", std::ssize(names) - MOST) : "");
}

/// NAME/NAME.mme that this program wrote.
bool is_own_test(const fs::path& folder) {
    const fs::path about = folder / (folder.filename().string() + ".mme");
    if (!fs::is_regular_file(about)) return false;
    const std::string text = beginning_of(about);
    const std::size_t at = text.find("Laboratory name"), value = text.find(':', at);
    return at != std::string::npos && text.compare(value + 1, 10, "corpuscle ") == 0;
}

/// Its channels and its head; folders that then hold nothing.
void remove_test(const fs::path& folder) {
    const std::string name = folder.filename().string();
    const fs::path channels = folder / "Channel";
    std::vector<fs::path> files = {folder / (name + ".mme")};
    if (fs::is_directory(channels))
        for (const fs::directory_entry& entry : fs::directory_iterator(channels))
            if (entry.path().stem() == name) files.push_back(entry.path());
    for (const fs::path& file : files) fs::remove(file);
    std::error_code holds_more;
    for (const fs::path& emptied : {channels, folder}) fs::remove(emptied, holds_more);
}

}  // namespace

void expect_own_results(const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    std::vector<std::string> found, foreign;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!is_export(name) && !is_result(name)) continue;
        found.push_back(name);
        if (is_foreign(entry.path())) foreign.push_back(name);
    }
    const auto refuse = [&](std::string_view what, std::vector<std::string> names) {
        throw InputError(
            fmt::format("{} holds {} {}: a run would replace them; expected another folder, -o DIR",
                        folder.string(), what, names_listed(std::move(names))));
    };
    if (found.empty()) return;
    if (!holds_own_results(folder)) refuse("no results of corpuscle, but", std::move(found));
    if (!foreign.empty()) refuse("results of another program,", std::move(foreign));
}

void remove_old_exports(const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> files, tests;
    std::vector<std::string> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool is_test = entry.is_directory() && is_own_test(entry.path());
        if (!is_test && (entry.is_directory() || !is_export(name))) continue;
        (is_test ? tests : files).push_back(entry.path());
        old.push_back(name);
    }
    if (old.empty()) return;
    for (const fs::path& test : tests) remove_test(test);
    for (const fs::path& file : files) fs::remove(file);
    fmt::print("{}: of an earlier run, removed: {}\n", folder.string(),
               names_listed(std::move(old)));
}

}  // namespace corpuscle::tools
