// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/card.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "tools/fold/recipe/toml_reader.hpp"

namespace corpuscle::verify {
namespace {

namespace fs = std::filesystem;
using fold::RecipeFaults;
using fold::TableReader;

constexpr int MOST_SEEDS = 10000;

std::string required_text(TableReader& table, std::string_view key) {
    std::string text = table.text_or(key, "");
    if (text.empty()) table.fault(key, "a text");
    return text;
}

Quantity read_quantity(const toml::table& node, RecipeFaults& faults) {
    TableReader table(node, "[[quantity]]", faults);
    Quantity q;
    q.name = required_text(table, "name");
    q.what = required_text(table, "what");
    q.unit = table.text_or("unit", "");
    q.budget_full = table.positive("budget");
    q.budget_quick = table.positive_or("budget_quick", q.budget_full);
    q.order = table.not_negative_or("order", 0.0);
    q.refines = table.truth_or("refines", true);
    table.finish();
    return q;
}

LevelCard read_level(const toml::table& node, const std::string& name, const fs::path& folder,
                     RecipeFaults& faults) {
    TableReader table(node, name, faults);
    LevelCard level;
    level.deck = folder / table.text_or("deck", "case.k");
    if (!fs::exists(level.deck)) table.fault("deck", "a deck, from this folder on");
    level.size = table.not_negative_or("size", 0.0);
    level.seeds = table.whole_or("seeds", 1, 1, MOST_SEEDS);
    if (const toml::table* set = table.table("set"))
        for (const auto& [key, value] : *set) {
            const auto number = value.value<double>();
            if (number)
                level.parameters.emplace_back(key.str(), *number);
            else
                table.fault("set", "a number for each *PARAMETER");
        }
    table.finish();
    return level;
}

std::vector<LevelCard> read_levels(TableReader& all, const std::string& mode,
                                   const fs::path& folder, RecipeFaults& faults) {
    std::vector<LevelCard> levels;
    for (const toml::table* node : all.tables(mode))
        levels.push_back(read_level(*node, "[[" + mode + "]]", folder, faults));
    if (levels.empty()) all.fault(mode, "a table [[" + mode + "]] for each level");
    return levels;
}

toml::table parse(const fs::path& file) {
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& why) {
        throw InputError(
            fmt::format("{}:{}: {}", file.string(), why.source().begin.line, why.description()));
    }
}

}  // namespace

Card read_card(const fs::path& file) {
    const toml::table toml = parse(file);
    RecipeFaults faults{file.string(), {}};
    TableReader all(toml, "the card", faults);
    Card card;
    card.name = file.parent_path().filename().string();
    card.title = required_text(all, "title");
    card.family = required_text(all, "family");
    card.source = required_text(all, "source");
    card.method = all.text_or("method", card.name);
    card.size = all.text_or("size", "particles");
    for (const toml::table* node : all.tables("quantity"))
        card.quantities.push_back(read_quantity(*node, faults));
    if (card.quantities.empty()) all.fault("quantity", "a table [[quantity]] for each");
    card.quick = read_levels(all, "quick", file.parent_path(), faults);
    card.full = read_levels(all, "full", file.parent_path(), faults);
    all.finish();
    if (!faults.all.empty()) throw InputError(std::move(faults.all));
    return card;
}

std::vector<Card> read_cards(const fs::path& folder, const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (fs::exists(entry.path() / "case.toml")) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    std::vector<std::string> faults;
    for (const std::string& name : names)
        if (std::find(found.begin(), found.end(), name) == found.end())
            faults.push_back(
                fmt::format("no case {}, expected one of {}", name, fmt::join(found, ", ")));
    std::vector<Card> cards;
    for (const std::string& name : found) {
        if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
        try {
            cards.push_back(read_card(folder / name / "case.toml"));
        } catch (const InputError& error) {
            faults.insert(faults.end(), error.faults.begin(), error.faults.end());
        }
    }
    if (!faults.empty()) throw InputError(std::move(faults));
    return cards;
}

fs::path find_cases(const fs::path& program) {
    for (fs::path at = program.parent_path(); at != at.parent_path(); at = at.parent_path())
        for (const char* place : {"share/corpuscle/models/verification", "models/verification"})
            if (fs::is_directory(at / place)) return at / place;
    throw InputError(
        fmt::format("no models/verification beside {}; --cases DIR names it", program.string()));
}

}  // namespace corpuscle::verify
