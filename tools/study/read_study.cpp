// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// STUDY.toml -> Study.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "io/deck/deck_fingerprint.hpp"
#include "io/text/text.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "tools/fold/recipe/toml_reader.hpp"
#include "tools/study/study.hpp"

namespace corpuscle::study {
namespace {

namespace fs = std::filesystem;
using fold::RecipeFaults;
using fold::TableReader;

constexpr int MOST_RUNS = 100000;

toml::table parse(const fs::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError(fmt::format("{}: expected a study in TOML", file.string()));
    std::stringstream text;
    text << in.rdbuf();
    try {
        return toml::parse(text.str(), file.string());
    } catch (const toml::parse_error& why) {
        throw InputError(
            fmt::format("{}:{}: {}", file.string(), why.source().begin.line, why.description()));
    }
}

/// toml++ sorts keys by name.
std::vector<std::string> in_file_order(const toml::table& table) {
    std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::string>> keys;
    for (const auto& [key, node] : table) {
        const toml::source_position at = key.source().begin;
        keys.push_back({{at.line, at.column}, std::string(key.str())});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::string> names;
    for (auto& [at, name] : keys) names.push_back(std::move(name));
    return names;
}

void spread(Factor& factor, int count) {
    for (int k = 0; k < count; ++k)
        factor.values.push_back(
            count == 1 ? factor.from : factor.from + (factor.to - factor.from) * k / (count - 1));
}

Factor read_factor(const std::string& name, const toml::node& node, TableReader& all, Plan plan,
                   RecipeFaults& faults) {
    Factor factor{name, {}, 0.0, 0.0, false};
    if (const toml::table* range = all.has(name) && node.is_table() ? node.as_table() : nullptr) {
        TableReader at(*range, fmt::format("[factors] {}", name), faults);
        factor.is_range = true;
        factor.from = at.real("from");
        factor.to = at.real("to");
        if (!(factor.from < factor.to)) at.fault("to", "a number above from");
        if (plan != Plan::LATIN && !at.has("count"))
            at.fault("count", "how many values of the range are taken");
        spread(factor, at.whole_or("count", 1, 1, MOST_RUNS));
        at.finish();
    } else {
        factor.values = all.numbers(name, 0, false);
    }
    return factor;
}

/// A header of names, then rows of numbers.
void read_points(Study& study, const fs::path& file, RecipeFaults& faults) {
    std::ifstream in(file);
    std::string line;
    const auto cells = [](std::string_view text) {
        std::vector<std::string_view> out;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t comma = std::min(text.find(',', at), text.size());
            out.push_back(io::trim(text.substr(at, comma - at)));
            at = comma + 1;
        }
        return out;
    };
    const auto fault = [&](std::size_t number, const std::string& text) {
        faults.all.push_back(fmt::format("{}:{}: {}", file.string(), number, text));
    };
    if (!in || !std::getline(in, line))
        return fault(1, "expected points: a line of names, then a line of numbers each");
    const auto strip = [&] {
        if (!line.empty() && line.back() == '\r') line.pop_back();
    };
    strip();
    if (line.starts_with(io::BYTE_ORDER_MARK)) line.erase(0, io::BYTE_ORDER_MARK.size());
    for (const std::string_view name : cells(line))
        study.factors.push_back({std::string(name), {}, 0.0, 0.0, false});
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        strip();
        if (io::trim(line).empty()) continue;
        std::vector<double> point;
        for (const std::string_view cell : cells(line)) {
            const auto value = io::parse_real(cell);
            if (!value) fault(number, fmt::format("{}, expected a number", cell));
            point.push_back(value.value_or(0.0));
        }
        if (point.size() != study.factors.size())
            fault(number,
                  fmt::format("{} numbers, expected {}", point.size(), study.factors.size()));
        study.listed.push_back(std::move(point));
    }
    if (study.listed.empty()) fault(2, "no points, expected a line of numbers each");
}

/// The deck, or [[mesh]]: decks in its place, as values of the factor MESH.
void read_decks(Study& study, TableReader& top, RecipeFaults& faults) {
    const fs::path here = fs::absolute(study.file).parent_path();
    const auto deck_of = [&](TableReader& at) {
        const std::string name = at.text_or("deck", "");
        if (name.empty() || !fs::exists(here / name)) at.fault("deck", "a deck beside the study");
        return here / name;
    };
    const std::vector<const toml::table*> meshes = top.tables("mesh");
    if (meshes.empty()) {
        study.deck = deck_of(top);
        return;
    }
    if (top.has("deck")) top.fault("deck", "none beside [[mesh]]: each has its own");
    if (study.plan == Plan::POINTS) top.fault("mesh", "none: the points name what varies");
    Factor sizes;
    sizes.name = "MESH";
    sizes.is_mesh = true;
    for (const toml::table* const one : meshes) {
        TableReader at(*one, "[[mesh]]", faults);
        const Mesh mesh{deck_of(at), 0, at.positive("size")};
        if (std::count(sizes.values.begin(), sizes.values.end(), mesh.size) > 0)
            at.fault("size", "a size that no other mesh has");
        at.finish();
        study.meshes.push_back(mesh);
        sizes.values.push_back(mesh.size);
    }
    study.deck = study.meshes.front().deck;
    study.factors.push_back(std::move(sizes));
}

/// [orders]: how the error falls with a factor of a star.
void read_orders(Study& study, TableReader& top, RecipeFaults& faults) {
    const toml::table* table = top.table("orders");
    if (!table) return;
    if (study.plan != Plan::STAR) top.fault("orders", "none but for plan = \"star\"");
    TableReader at(*table, "[orders]", faults);
    for (Factor& factor : study.factors) {
        if (!at.has(factor.name)) continue;
        factor.order = at.real(factor.name);
        if (factor.order == 0.0) at.fault(factor.name, "an order that is not 0");
        for (const double value : factor.values)
            if (!(value > 0.0)) at.fault(factor.name, "an order of a factor that is above 0");
    }
    at.finish();
}

void read_factors(Study& study, TableReader& top, RecipeFaults& faults) {
    const toml::table* table = top.table("factors");
    if (study.plan == Plan::POINTS) {
        const fs::path file = top.text_or("points", "");
        if (file.empty()) top.fault("points", "a CSV file of points");
        if (table) top.fault("factors", "none: the points name their own");
        if (!file.empty()) read_points(study, study.file.parent_path() / file, faults);
        return;
    }
    if (!table && !study.meshes.empty()) return;
    if (!table || table->empty()) return top.fault("factors", "a table [factors] of what varies");
    TableReader at(*table, "[factors]", faults);
    for (const std::string& name : in_file_order(*table)) {
        if (name == "MESH" && !study.meshes.empty()) at.fault(name, "another name: it is [[mesh]]");
        study.factors.push_back(read_factor(name, *table->get(name), at, study.plan, faults));
    }
}

void read_fixed(Study& study, TableReader& top, RecipeFaults& faults) {
    const toml::table* table = top.table("fixed");
    if (!table) return;
    TableReader at(*table, "[fixed]", faults);
    for (const std::string& name : in_file_order(*table)) {
        study.fixed.emplace_back(name, at.real(name));
        for (const Factor& factor : study.factors)
            if (factor.name == name) at.fault(name, "a value that does not vary: it is a factor");
    }
}

void read_responses(Study& study, const toml::table& table, TableReader& top) {
    const toml::array* all = top.has("responses") ? table["responses"].as_array() : nullptr;
    bool is_good = all && !all->empty();
    if (is_good)
        for (const toml::node& one : *all) {
            is_good = is_good && one.is_string();
            study.responses.push_back(one.value_or(std::string()));
        }
    if (!is_good)
        top.fault("responses",
                  "a list of names: \"100.hic15\" (body.response) or "
                  "\"max:/history/airbag/1/pressure\" (max, min or end of a history)");
}

}  // namespace

Study read_study(const fs::path& file) {
    const toml::table table = parse(file);
    RecipeFaults faults{file.string(), {}};
    TableReader top(table, "the study", faults);
    Study s;
    s.file = file;
    s.folder = top.text_or("output", "");
    if (s.folder.empty()) s.folder = file.filename().replace_extension("").string() + ".study";
    const std::string plan = top.choice("plan", {"full", "latin", "points", "star"});
    s.plan = plan == "full"    ? Plan::FULL
             : plan == "latin" ? Plan::LATIN
             : plan == "star"  ? Plan::STAR
                               : Plan::POINTS;
    read_decks(s, top, faults);
    if (s.plan == Plan::LATIN) {
        if (!top.has("samples")) top.fault("samples", "how many points a Latin hypercube has");
        s.samples = top.whole_or("samples", 1, 1, MOST_RUNS);
        s.plan_seed = static_cast<std::uint64_t>(top.whole_or("plan_seed", 1, 0, 2147483647));
    }
    s.repeats = top.whole_or("repeats", 1, 1, MOST_RUNS);
    s.first_seed = static_cast<std::uint64_t>(top.whole_or("first_seed", 1, 0, 2147483647));
    s.says_threads = top.has("threads");
    s.says_workers = top.has("workers");
    s.threads = top.whole_or("threads", 1, 1, 1024);
    // (A run of one thread gains more from a processor of its own than another from a second one.)
    s.workers = top.whole_or("workers", std::max(1, parallel::processors() / s.threads), 1, 1024);
    if (top.has("until")) s.until = top.positive("until");
    read_factors(s, top, faults);
    read_orders(s, top, faults);
    read_fixed(s, top, faults);
    read_responses(s, table, top);
    top.finish();
    if (faults.all.empty()) {
        double runs = s.repeats;
        if (s.plan == Plan::FULL)
            for (const Factor& factor : s.factors)
                runs *= static_cast<double>(factor.values.size());
        if (runs > MOST_RUNS)
            faults.add(
                1, fmt::format("the study has {:g} runs, expected {} or fewer", runs, MOST_RUNS));
    }
    if (!faults.all.empty()) throw InputError(faults.all);
    s.deck_fingerprint = io::deck_fingerprint(s.deck);
    for (Mesh& mesh : s.meshes) mesh.fingerprint = io::deck_fingerprint(mesh.deck);
    return s;
}

}  // namespace corpuscle::study
