// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corpuscle::verify {
namespace {

std::string coloured(const Row& row, bool has_colour) {
    const std::string word = shown_verdict(row);
    if (!has_colour) return word;
    return fmt::format("\033[{}m{}\033[0m", row.holds() ? 32 : 31, word);
}

std::string seeds_text(const Row& row) {
    const Point& p = row.finest();
    const std::string seeds = fmt::format("{} seed{}", p.seeds, p.seeds == 1 ? "" : "s");
    return p.size > 0.0 ? fmt::format("{:g} {}, {}", p.size, row.card->size, seeds) : seeds;
}

}  // namespace

std::vector<std::string> families(const std::vector<Row>& rows) {
    std::vector<std::string> all;
    for (const Row& row : rows)
        if (std::find(all.begin(), all.end(), row.card->family) == all.end())
            all.push_back(row.card->family);
    return all;
}

std::string count_text(const std::vector<Row>& rows) {
    std::vector<std::string> bad;
    for (const Row& row : rows)
        if (!row.holds()) bad.push_back(row.name());
    std::string text =
        fmt::format("{} of {} quantities hold", rows.size() - bad.size(), rows.size());
    if (!bad.empty()) text += fmt::format(", {} do not: {}", bad.size(), fmt::join(bad, ", "));
    return text;
}

std::string cost_text(const Point& point) {
    std::string text = fmt::format("{:.3g} s", point.cpu_seconds);
    if (point.particle_steps > 0.0)
        text += fmt::format(", {:.3g} M particle-steps", 1e-6 * point.particle_steps);
    else if (point.steps > 0.0)
        text += fmt::format(", {:g} steps", point.steps);
    return text;
}

double total_cpu(const std::vector<Row>& rows) {
    double sum = 0.0;
    const Card* before = nullptr;
    for (const Row& row : rows) {
        if (row.card == before) continue;  // its quantities share their runs
        before = row.card;
        for (const Point& p : row.points) sum += p.cpu_seconds * static_cast<double>(p.seeds);
    }
    return sum;
}

std::string table_text(const std::vector<Row>& rows, bool has_colour) {
    std::string text = fmt::format("{:<34} {:>20} {:>10} {:>12} {:>8}  {}\n", "case/quantity",
                                   "error (95 %)", "budget", "order", "cpu", "verdict");
    for (const Row& row : rows) {
        // ± takes two bytes and one column
        const std::string error = shown(*row.quantity, row.finest().error);
        const std::size_t wide = error.find("±") != std::string::npos ? 21 : 20;
        text += fmt::format("{:<34} {:>{}} {:>10} {:>12} {:>6.1f} s  {}\n", row.name(), error, wide,
                            shown(*row.quantity, row.budget), shown_order(row),
                            row.finest().cpu_seconds, coloured(row, has_colour));
        if (!row.fault.empty()) text += fmt::format("    {}\n", row.fault);
    }
    return text + count_text(rows) + "\n";
}

std::string table_markdown(const std::vector<Row>& rows, const std::string& settings) {
    std::string text =
        "# Verification\n\n" + settings + "\n\n" + count_text(rows) +
        ".\n\nAn error is that of the finest level, with half of its 95 % interval between seeds; "
        "the "
        "order is that of\nthe error against what refines. `?`: the interval reaches across the "
        "budget. A budget is never moved to where\na result is.\n";
    for (const std::string& family : families(rows)) {
        text += fmt::format(
            "\n## {}\n\n| case | exact answer | quantity | finest level | error | "
            "budget | order | cost of a run | |\n|---|---|---|---|---|---|---|---|---|\n",
            family);
        const Card* before = nullptr;
        for (const Row& row : rows) {
            if (row.card->family != family) continue;
            const bool is_new = row.card != before;
            before = row.card;
            text += fmt::format(
                "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", is_new ? row.card->title : "",
                is_new ? row.card->source : "", row.quantity->what, seeds_text(row),
                shown(*row.quantity, row.finest().error), shown(*row.quantity, row.budget),
                shown_order(row), cost_text(row.finest()),
                row.holds() ? shown_verdict(row) : "**" + shown_verdict(row) + "**");
        }
    }
    return text;
}

}  // namespace corpuscle::verify
