// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

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

void remove_old_exports(const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    std::vector<std::string> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool is_d3plot = name.starts_with("d3plot") &&
                               name.find_first_not_of("0123456789", 6) == std::string::npos;
        const bool is_mme = entry.is_directory() && fs::exists(entry.path() / (name + ".mme"));
        if (is_d3plot || is_mme || name == "binout" || name == "history.csv" ||
            name == "history_fast.csv" || name == "responses.json" || name == "run.json")
            old.push_back(name);
    }
    if (old.empty()) return;
    std::sort(old.begin(), old.end());
    for (const std::string& name : old) fs::remove_all(folder / name);
    fmt::print(
        "{}: of an earlier run, removed: {}{}\n", folder.string(),
        fmt::join(old.begin(), old.begin() + std::min<std::ptrdiff_t>(8, std::ssize(old)), ", "),
        old.size() > 8 ? fmt::format(" and {} more", old.size() - 8) : "");
}

}  // namespace corpuscle::tools
