// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/deck_fingerprint.hpp"

#include <cctype>
#include <cstring>
#include <string_view>

namespace corpuscle::io {
namespace {

/// FNV-1a, 64 bits, of texts in turn.
class Hash {
public:
    void take(std::string_view text) {
        for (const char c : text) take_byte(static_cast<unsigned char>(c));
        take_byte(0);  // where a text ends
    }
    void take(double number) {
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        for (const char byte : bytes) take_byte(static_cast<unsigned char>(byte));
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    void take_byte(unsigned char c) { hash_ = (hash_ ^ c) * 1099511628211ULL; }

    std::uint64_t hash_ = 14695981039346656037ULL;
};

/// Says the block when the run ends, or how often something is written?
bool is_of_output(const Block& block) {
    const std::string_view keyword = block.keyword;
    return keyword == "CONTROL_TERMINATION" || keyword == "TITLE" ||
           (keyword.starts_with("DATABASE_") && !keyword.starts_with("DATABASE_HISTORY") &&
            !keyword.starts_with("DATABASE_CPM_SENSOR"));
}

bool is_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// A parameter by its name, where there is one.
void take_parameter(std::string_view name, Viewpoint from, const Parameters& parameters,
                    Hash& hash) {
    const Parameter* p = name.empty() ? nullptr : parameters.find(name, from);
    if (p == nullptr) return;
    if (p->type == 'C')
        hash.take(p->text);
    else
        hash.take(p->value.number);
}

/// The parameters that a line names, wherever it does: &name, <name * 2>.
void take_parameters(std::string_view line, Viewpoint from, const Parameters& parameters,
                     Hash& hash) {
    if (line.find_first_of("&<") == std::string_view::npos) return;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && is_of_name(line[end])) ++end;
        take_parameter(line.substr(at, end - at), from, parameters, hash);
        at = end + 1;
    }
}

/// Cards from line `first` on, with the parameters that they name.
void take_cards(const Block& block, std::size_t first, const Parameters& parameters, Hash& hash) {
    hash.take(block.keyword);
    for (const Line& line : block.lines.subspan(first)) {
        hash.take(line.text.substr(0, line.text.find_last_not_of(" \r") + 1));
        take_parameters(line.text, block.viewpoint(), parameters, hash);
    }
}

}  // namespace

std::uint64_t deck_fingerprint(const std::filesystem::path& deck) {
    Faults ignored;  // whoever runs the deck hears of them
    Parameters parameters({});
    const DeckText text = read_keywords(deck, parameters, ignored);
    Hash hash;
    for (const DeckText::File& file : text.files) hash.take(file.text);
    return hash.value();
}

std::uint64_t scene_fingerprint(const DeckText& text, Parameters& parameters) {
    Hash hash;
    for (const Block& block : text.blocks)
        if (!is_of_output(block)) take_cards(block, 0, parameters, hash);
    for (const Inclusion& inclusion :
         text.inclusions)  // how their files are placed, not their names
        take_cards(inclusion.block, inclusion.name_lines, parameters, hash);
    // what no card but a parameter or -D says
    for (const std::string_view name : OWN_NAMES) {
        take_parameter(name, {}, parameters, hash);
        hash.take(parameters.take_override(name).value_or(""));
    }
    return hash.value();
}

}  // namespace corpuscle::io
