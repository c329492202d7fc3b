// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/recipe/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/text/text.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fold {
namespace {

std::string print(const toml::node& node) {
    std::ostringstream text;
    node.visit([&](const auto& n) { text << n; });
    std::string one_line = text.str();
    std::replace(one_line.begin(), one_line.end(), '\n', ' ');
    return one_line;
}

}  // namespace

void RecipeFaults::add(std::size_t line, const std::string& text) {
    all.push_back(fmt::format("{}:{}: {}", file, line, text));
}

bool TableReader::has(std::string_view key) {
    return find(key) != nullptr;
}

const toml::node* TableReader::find(std::string_view key) {
    known_.emplace(key);
    return table_.get(key);
}

void TableReader::fault(std::string_view key, const std::string& expected) {
    const toml::node* node = find(key);
    if (node)
        faults_.add(node->source().begin.line,
                    fmt::format("{} {} = {}, expected {}", name_, key, print(*node), expected));
    else
        faults_.add(line(), fmt::format("{} has no {}, expected {}", name_, key, expected));
}

double TableReader::number(std::string_view key, double fallback, bool is_required, double least,
                           bool is_open, const std::string& expected) {
    const toml::node* node = find(key);
    if (!node && !is_required) return fallback;
    const auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value) || *value < least || (is_open && *value == least)) {
        fault(key, expected);
        return fallback;
    }
    return *value;
}

double TableReader::positive(std::string_view key) {
    return number(key, NaN, true, 0.0, true, "a positive number");
}

double TableReader::positive_or(std::string_view key, double fallback) {
    return number(key, fallback, false, 0.0, true, "a positive number");
}

double TableReader::not_negative_or(std::string_view key, double fallback) {
    return number(key, fallback, false, 0.0, false, "a number that is not negative");
}

double TableReader::real(std::string_view key) {
    return number(key, NaN, true, -INF, false, "a number");
}

double TableReader::real_or(std::string_view key, double fallback) {
    return number(key, fallback, false, -INF, false, "a number");
}

int TableReader::whole_or(std::string_view key, int fallback, int least, int most) {
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (!value || *value < least || *value > most) {
        fault(key, fmt::format("a whole number from {} to {}", least, most));
        return fallback;
    }
    return static_cast<int>(*value);
}

bool TableReader::truth_or(std::string_view key, bool fallback) {
    const toml::node* node = find(key);
    if (!node) return fallback;
    if (!node->is_boolean()) fault(key, "true or false");
    return node->value_or(fallback);
}

std::string TableReader::text_or(std::string_view key, std::string fallback) {
    const toml::node* node = find(key);
    if (!node) return fallback;
    if (!node->is_string()) fault(key, "a text");
    return node->value_or(fallback);
}

std::string TableReader::choice(std::string_view key,
                                const std::vector<std::string_view>& choices) {
    const toml::node* node = find(key);
    if (!node) return std::string(choices.front());
    const std::string value = node->value_or(std::string());
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
    fault(key, fmt::format("one of \"{}\"", fmt::join(choices, "\", \"")));
    return std::string(choices.front());
}

std::vector<double> TableReader::numbers(std::string_view key, std::size_t count,
                                         bool are_positive) {
    const toml::node* node = find(key);
    std::vector<double> all;
    bool is_good = node && node->is_array();
    if (is_good)
        for (const toml::node& one : *node->as_array()) {
            const auto value = one.is_number() ? one.value<double>() : std::nullopt;
            is_good = is_good && value && std::isfinite(*value) && (!are_positive || *value > 0.0);
            all.push_back(value.value_or(NaN));
        }
    if (is_good && (count == 0 ? !all.empty() : all.size() == count)) return all;
    fault(key, fmt::format("a list of {}{}numbers", count ? fmt::format("{} ", count) : "",
                           are_positive ? "positive " : ""));
    return std::vector<double>(count, NaN);
}

const toml::table* TableReader::table(std::string_view key) {
    const toml::node* node = find(key);
    if (node && !node->is_table()) fault(key, fmt::format("a table [{}]", key));
    return node ? node->as_table() : nullptr;
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) {
    const toml::node* node = find(key);
    std::vector<const toml::table*> all;
    if (!node) return all;
    if (!node->is_array_of_tables()) {
        fault(key, fmt::format("tables [[{}]]", key));
        return all;
    }
    for (const toml::node& one : *node->as_array()) all.push_back(one.as_table());
    return all;
}

void TableReader::finish() {
    const std::vector<std::string_view> known(known_.begin(), known_.end());
    for (const auto& [key, node] : table_) {
        if (known_.contains(key.str())) continue;
        const std::string_view meant = io::nearest(key.str(), known);
        faults_.add(key.source().begin.line,
                    fmt::format("{} has no key {}{}", name_, key.str(),
                                meant.empty() ? "" : fmt::format(", did you mean {}?", meant)));
    }
}

}  // namespace corpuscle::fold
