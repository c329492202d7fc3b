// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/deck_places.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "io/deck/deck_words.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

void DeckPlaces::add(std::string_view kind, int id, Place at, const std::string& keyword) {
    things_.insert_or_assign({std::string(kind), id}, KeywordPlace{at, "*" + keyword});
}

void DeckPlaces::add(std::string_view kind, Registry registry) {
    registries_.insert_or_assign(std::string(kind), std::move(registry));
}

bool DeckPlaces::find(std::string_view kind, int id, KeywordPlace& found) const {
    if (kind.starts_with("*AIRBAG_")) kind = "bag";
    if (const auto at = things_.find({std::string(kind), id}); at != things_.end()) {
        found = at->second;
        return true;
    }
    const auto registry = registries_.find(kind);
    if (registry == registries_.end()) return false;
    const Registry::Entry* entry = registry->second.find(id);
    if (entry == nullptr) return false;
    found = {entry->place, std::string(registry->second.kind())};
    return true;
}

std::string DeckPlaces::told(const std::string& fault) const {
    std::vector<std::string_view> words;
    for_each_word(fault, [&](std::string_view word) { words.push_back(word); });
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        std::string_view number = words[i + 1];
        while (number.ends_with(':') || number.ends_with(',')) number.remove_suffix(1);
        const std::optional<int> id = parse_integer(number);
        if (KeywordPlace found; id && find(words[i], *id, found)) {
            const std::string where = faults_.where(found.place);
            return fault.starts_with('*') ? fmt::format("{}: {}", where, fault)
                                          : fmt::format("{}: {}: {}", where, found.keyword, fault);
        }
    }
    return fault;
}

InputError DeckPlaces::told(const InputError& error) const {
    std::vector<std::string> faults;
    for (const Fault& fault : error.typed)
        faults.push_back(fault.text(deck_word(fault.property, fault.of)));
    return InputError(told(faults));
}

std::vector<std::string> DeckPlaces::told(const std::vector<std::string>& faults) const {
    std::vector<std::string> lines;
    std::map<std::string, std::pair<std::size_t, std::size_t>> alike;  // line and count, by cause
    for (const std::string& fault : faults) {
        std::string cause = fault;
        for (const std::string_view kind : {"shell ", "node "})
            if (fault.starts_with(kind))
                cause.erase(kind.size(),
                            fault.find_first_not_of("0123456789", kind.size()) - kind.size());
        const auto [at, is_new] = alike.try_emplace(cause, lines.size(), 0);
        if (is_new)
            lines.push_back(told(fault));
        else
            ++at->second.second;
    }
    for (const auto& [cause, found] : alike)
        if (found.second > 0)
            lines[found.first] += fmt::format(" (and {} more like it)", found.second);
    return lines;
}

}  // namespace corpuscle::io
