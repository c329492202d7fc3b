// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/page.hpp"

#include <fmt/format.h>

#include "tools/verify/plot.hpp"
#include "tools/verify/table.hpp"

namespace corpuscle::verify {
namespace {

constexpr const char* STYLE = R"(
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1200px; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th, td { text-align: left; vertical-align: top; padding: .3em .6em; border-bottom: 1px solid #ddd; }
td.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.holds { color: #1b6e20; font-weight: 600; } .missed { color: #fff; background: #c62828; font-weight: 600; }
.levels { color: #666; font-size: 12px; } svg text { font-size: 12px; fill: #333; }
.grid { stroke: #e4e4e4; } .budget { stroke: #c62828; stroke-dasharray: 6 4; }
)";

constexpr const char* HOW_TO_READ =
    "<p>Every number comes from decks that <code>corpuscle run</code> has run with default "
    "settings, "
    "read back from the results files that any user gets. The <b>error</b> is that of the finest "
    "level, with half of its 95 % interval between seeds (Student's t); coarser levels are "
    "below it. <b>?</b> says that the interval reaches across the budget: with other seeds the "
    "verdict "
    "might be another. The <b>order</b> is the slope of the error against what refines, in "
    "logarithms. "
    "The <b>cost</b> is CPU time of one run. In plots the dashed line is the budget. Budgets "
    "are requirements: where one is missed, it is red, and it is not moved.</p>\n";

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

/// The coarser levels, one a line.
std::string coarser(const Row& row) {
    std::string text;
    for (std::size_t k = 0; k + 1 < row.points.size(); ++k) {
        const Point& p = row.points[k];
        text += fmt::format("<br>{:g}: {}", p.size, shown(*row.quantity, p.error));
    }
    return text.empty() ? "" : "<span class='levels'>" + text + "</span>";
}

std::string level_text(const Row& row) {
    const Point& p = row.finest();
    const std::string size = p.size > 0.0 ? fmt::format("{:g} {}<br>", p.size, row.card->size) : "";
    return size + fmt::format("{} seed{}", p.seeds, p.seeds == 1 ? "" : "s");
}

std::string table_row(const Row& row, std::size_t quantities) {
    std::string html = "<tr>";
    if (quantities > 0)
        html += fmt::format(
            "<td rowspan='{0}'><b>{1}</b><br><span class='levels'>{2}</span></td>"
            "<td rowspan='{0}'>{3}</td>",
            quantities, escaped(row.card->title), row.card->name, escaped(row.card->source));
    html += fmt::format(
        "<td>{}{}</td><td>{}</td><td class='n'>{}{}</td><td class='n'>{}</td><td class='n'>{}</td>"
        "<td class='n'>{}</td><td class='{}'>{}</td></tr>\n",
        escaped(row.quantity->what),
        row.fault.empty() ? "" : "<br><span class='levels'>" + escaped(row.fault) + "</span>",
        level_text(row), shown(*row.quantity, row.finest().error), coarser(row),
        shown(*row.quantity, row.budget), shown_order(row), cost_text(row.finest()),
        row.holds() ? "holds" : "missed", shown_verdict(row));
    return html;
}

std::string family_part(const std::string& family, const std::vector<Row>& rows) {
    std::string html = fmt::format(
        "<h2>{}</h2>\n<table><tr><th>case<th>exact answer<th>quantity<th>finest level<th>error"
        "<th>budget<th>order<th>cost of a run<th>verdict</tr>\n",
        escaped(family));
    std::vector<Row> mine;
    for (const Row& row : rows)
        if (row.card->family == family) mine.push_back(row);
    const Card* before = nullptr;
    for (const Row& row : mine) {
        html += table_row(row, row.card != before ? row.card->quantities.size() : 0);
        before = row.card;
    }
    return html + "</table>\n" + error_plot(mine);
}

}  // namespace

std::string page(const std::vector<Row>& rows, const std::string& settings) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>corpuscle: "
        "verification"
        "</title><style>{}</style></head><body>\n<h1>Verification</h1>\n<p>{}</p>\n<p><b>{}</b>. "
        "{:.0f} s of CPU time in all.</p>\n",
        STYLE, escaped(settings), escaped(count_text(rows)), total_cpu(rows));
    html += HOW_TO_READ;
    for (const std::string& family : families(rows)) html += family_part(family, rows);
    return html + "</body></html>\n";
}

}  // namespace corpuscle::verify
