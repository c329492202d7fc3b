// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/text/text.hpp"

namespace corpuscle::io {

Parameters::Parameters(std::vector<std::pair<std::string, std::string>> overrides) {
    for (auto& [name, value] : overrides)
        overrides_.push_back({upper(trim(name)), std::move(value), false});
}

void Parameters::add_file(std::uint32_t file, std::optional<std::uint32_t> parent) {
    files_.resize(std::max<std::size_t>(files_.size(), file + 1));
    files_[file].parent = parent;
}

std::optional<std::string> Parameters::take_override(std::string_view name) {
    std::optional<std::string> value;
    for (Override& o : overrides_)
        if (o.name == upper(name)) {
            o.used = true;
            value = o.value;  // of two -D for one name the last counts
        }
    return value;
}

const Parameter* Parameters::last(std::string_view name, std::uint32_t file, bool local) const {
    const Table& table = local ? files_[file].local : global_;
    const auto at = table.find(upper(name));
    return at == table.end() ? nullptr : &at->second.back();
}

void Parameters::define(std::string_view name, Parameter parameter, bool local) {
    Table& table = local ? files_[parameter.place.file].local : global_;
    parameter.order = definitions_++;
    table[upper(name)].push_back(std::move(parameter));
}

const Parameter* Parameters::find(std::string_view name, Viewpoint from) const {
    const std::string key = upper(name);
    const auto seen = [&](const Table& table) -> const Parameter* {
        const auto at = table.find(key);
        if (at == table.end()) return nullptr;
        const std::vector<Parameter>& all = at->second;
        const auto behind = std::find_if(all.begin() + 1, all.end(), [&](const Parameter& p) {
            return p.order >= from.defined;
        });
        return &*std::prev(behind);
    };
    for (std::optional<std::uint32_t> file = from.file; file; file = files_[*file].parent)
        if (const Parameter* local = seen(files_[*file].local)) return local;
    return seen(global_);
}

std::optional<Value> Parameters::value(std::string_view name, Viewpoint from) const {
    const Parameter* parameter = find(name, from);
    if (parameter == nullptr || parameter->type == 'C') return {};
    return parameter->value;
}

std::string Parameters::nearest_name(std::string_view name) const {
    std::vector<std::string_view> known;
    for (const auto& [key, parameter] : global_) known.push_back(key);
    for (const File& file : files_)
        for (const auto& [key, parameter] : file.local) known.push_back(key);
    return std::string(nearest(upper(name), known));
}

std::vector<std::string> Parameters::names() const {
    std::vector<std::string> all;
    for (const auto& [key, parameter] : global_) all.push_back(key);
    for (const File& file : files_)
        for (const auto& [key, parameter] : file.local) all.push_back(key);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<std::string> Parameters::unused_overrides() const {
    std::vector<std::string> faults;
    for (const Override& o : overrides_) {
        if (o.used) continue;
        const std::string meant = nearest_name(o.name);
        faults.push_back(
            fmt::format("-D {}={}: the deck has no *PARAMETER of that name{}", o.name, o.value,
                        meant.empty() ? "" : fmt::format("; did you mean {}?", meant)));
    }
    return faults;
}

}  // namespace corpuscle::io
