// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/results/hdf5.hpp"
#include "io/system/atomic_file.hpp"
#include "tools/study/estimate.hpp"

namespace corpuscle::study {
namespace {

/// For a comma-separated file.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string cell(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

void add(std::string& line, const std::string& next) {
    line += ',';
    line += next;
}

std::string state_of(const Outcome& outcome) {
    if (!outcome.is_finished) return "missing";
    return outcome.status == 0 ? "normal" : fmt::format("failed ({})", outcome.status);
}

std::vector<double> column(const Table& table, std::size_t response) {
    std::vector<double> values;
    for (const Outcome& outcome : table.outcomes) values.push_back(outcome.responses[response]);
    return values;
}

/// Half of the 95 % interval of the mean.
double interval(const Spread& s) {
    return student_95(s.count - 1) * s.deviation / std::sqrt(static_cast<double>(s.count));
}

/// A response's name as a name in HDF5.
std::string flat_name(std::string name) {
    for (char& c : name)
        if (c == '/') c = '.';
    return name;
}

}  // namespace

std::string unit_of(const Table& table, std::size_t response) {
    for (const Outcome& outcome : table.outcomes)
        if (!outcome.units.empty() && !outcome.units[response].empty())
            return outcome.units[response];
    return "";
}

Table gather(const Study& study) {
    Table table{study, rows(study), {}};
    for (const Row& row : table.rows) table.outcomes.push_back(read_outcome(study, row));
    return table;
}

void write_csv(const Table& table) {
    std::string text = "run,point";
    for (const Factor& factor : table.study.factors) add(text, cell(factor.name));
    text += ",seed,status,seconds";
    for (std::size_t r = 0; r < table.study.responses.size(); ++r)
        add(text, cell(fmt::format("{} [{}]", table.study.responses[r], unit_of(table, r))));
    text += ",reason\n";
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const Row& row = table.rows[k];
        const Outcome& outcome = table.outcomes[k];
        text += fmt::format("{},{}", row.number, row.point + 1);
        for (const double value : row.values) add(text, cell(value));
        text += fmt::format(",{},{},{}", row.seed, state_of(outcome),
                            outcome.is_finished ? cell(outcome.cost.seconds) : "");
        for (const double value : outcome.responses) add(text, cell(value));
        add(text, cell(outcome.reason));
        text += "\n";
    }
    io::replace_text(table.study.folder / "study.csv", text);
}

void write_h5(const Table& table) {
    const std::filesystem::path file = table.study.folder / "study.h5";
    const std::uint64_t n = table.rows.size();
    {
        io::Hdf5Writer to(io::next_version(file));
        to.attribute("/", "program", "corpuscle");
        to.attribute("/", "deck", table.study.deck.string());
        to.attribute("/", "study", table.study.file.string());
        std::vector<double> seconds(n);
        std::vector<std::int32_t> status(n), point(n);
        std::vector<std::uint64_t> seed(n);
        for (std::size_t k = 0; k < n; ++k) {
            const Outcome& outcome = table.outcomes[k];
            status[k] = outcome.is_finished ? outcome.status : -1;
            seconds[k] = outcome.cost.seconds;
            point[k] = static_cast<std::int32_t>(table.rows[k].point + 1);
            seed[k] = table.rows[k].seed;
        }
        to.dataset<std::int32_t>("/point", point, {n}, {"-", "of the run; from 1"});
        to.dataset<std::uint64_t>("/seed", seed, {n}, {"-", "of the random numbers"});
        to.dataset<std::int32_t>("/status", status, {n}, {"-", "exit status; -1: missing"});
        to.dataset<double>("/seconds", seconds, {n}, {"s", "wall time of the run"});
        for (std::size_t f = 0; f < table.study.factors.size(); ++f) {
            std::vector<double> values;
            for (const Row& row : table.rows) values.push_back(row.values[f]);
            to.dataset<double>(fmt::format("/factors/{}", flat_name(table.study.factors[f].name)),
                               values, {n}, {"deck", "value of this parameter of the deck"});
        }
        for (std::size_t r = 0; r < table.study.responses.size(); ++r)
            to.dataset<double>(fmt::format("/responses/{}", flat_name(table.study.responses[r])),
                               column(table, r), {n},
                               {unit_of(table, r), "response; NaN: there is none"});
        to.close();
    }
    io::take_its_name(file);
}

Spread spread_of(const std::vector<double>& values) {
    Spread s;
    for (const double value : values)
        if (!std::isnan(value)) {
            ++s.count;
            s.mean += value;
        }
    if (s.count == 0) return s;
    s.mean /= static_cast<double>(s.count);
    for (const double value : values)
        if (!std::isnan(value)) s.deviation += (value - s.mean) * (value - s.mean);
    s.deviation = s.count > 1 ? std::sqrt(s.deviation / static_cast<double>(s.count - 1)) : 0.0;
    return s;
}

std::vector<Effect> main_effect(const Table& table, std::size_t factor, std::size_t response) {
    std::map<double, std::vector<double>> at;
    for (std::size_t k = 0; k < table.rows.size(); ++k)
        at[table.rows[k].values[factor]].push_back(table.outcomes[k].responses[response]);
    std::vector<Effect> effect;
    for (const auto& [value, all] : at) {
        const Spread s = spread_of(all);
        if (s.count > 0) effect.push_back({value, s.mean});
    }
    return effect;
}

std::string table_text(const Table& table) {
    const Study& study = table.study;
    std::string text = fmt::format("{:>6}", "point");
    for (const Factor& factor : study.factors) text += fmt::format(" {:>12}", factor.name);
    text += fmt::format(" {:>6}", "runs");
    for (std::size_t r = 0; r < study.responses.size(); ++r)
        text += fmt::format("  {}", fmt::format("{} [{}]", study.responses[r], unit_of(table, r)));
    text += '\n';
    for (std::size_t first = 0; first < table.rows.size();) {
        std::size_t last = first;
        while (last < table.rows.size() && table.rows[last].point == table.rows[first].point)
            ++last;
        text += fmt::format("{:>6}", table.rows[first].point + 1);
        for (const double value : table.rows[first].values)
            text += fmt::format(" {:>12.6g}", value);
        std::size_t normal = 0;
        for (std::size_t k = first; k < last; ++k)
            normal += table.outcomes[k].is_finished && table.outcomes[k].status == 0;
        text += fmt::format(" {:>2} / {}", normal, last - first);
        for (std::size_t r = 0; r < study.responses.size(); ++r) {
            std::vector<double> values;
            for (std::size_t k = first; k < last; ++k)
                values.push_back(table.outcomes[k].responses[r]);
            const Spread s = spread_of(values);
            const std::size_t width =
                study.responses[r].size() + unit_of(table, r).size() + 3;  // of the heading
            std::string shown = s.count == 0 ? "-" : fmt::format("{:.5g}", s.mean);
            if (s.count > 1 && s.mean != 0.0)
                shown += fmt::format(" +- {:.2g} ({:.2g} %)", interval(s),
                                     100.0 * s.deviation / std::abs(s.mean));
            text += fmt::format("  {:>{}}", shown, width);
        }
        text += '\n';
        first = last;
    }
    return text;
}

}  // namespace corpuscle::study
