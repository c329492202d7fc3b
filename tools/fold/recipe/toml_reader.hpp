// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace corpuscle::fold {

/// Gathers what is wrong with a recipe, each with file and line.
struct RecipeFaults {
    std::string file;
    std::vector<std::string> all;

    void add(std::size_t line, const std::string& text);
};

/// One table of a recipe: asks for its keys by name, complains of those that nobody asked for.
class TableReader {
public:
    /// @param name  as messages call it: "[pattern]"
    TableReader(const toml::table& table, std::string name, RecipeFaults& faults)
        : table_(table), name_(std::move(name)), faults_(faults) {}

    [[nodiscard]] bool has(std::string_view key);
    [[nodiscard]] std::size_t line() const { return table_.source().begin.line; }

    /// A key without a fallback is required; a fault gives the fallback, or NaN, 0, "".
    double positive(std::string_view key);
    double positive_or(std::string_view key, double fallback);
    double not_negative_or(std::string_view key, double fallback);
    double real(std::string_view key);
    double real_or(std::string_view key, double fallback);
    int whole_or(std::string_view key, int fallback, int least, int most);
    bool truth_or(std::string_view key, bool fallback);
    std::string text_or(std::string_view key, std::string fallback);
    /// One of `choices`; without the key the first.
    std::string choice(std::string_view key, const std::vector<std::string_view>& choices);
    /// Positive numbers, or numbers: exactly `count` of them, or any if it is 0.
    std::vector<double> numbers(std::string_view key, std::size_t count, bool are_positive);

    /// The table under the key, or null.
    const toml::table* table(std::string_view key);
    /// The tables [[key]].
    std::vector<const toml::table*> tables(std::string_view key);

    /// file:line: [table] key = value, expected ...
    void fault(std::string_view key, const std::string& expected);
    /// Faults for every key that was not asked for.
    void finish();

private:
    const toml::node* find(std::string_view key);
    double number(std::string_view key, double fallback, bool is_required, double least,
                  bool is_open, const std::string& expected);

    const toml::table& table_;
    std::string name_;
    RecipeFaults& faults_;
    std::set<std::string, std::less<>> known_;
};

}  // namespace corpuscle::fold
