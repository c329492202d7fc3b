// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

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

const Parameter* Parameters::define(std::string_view name, Parameter parameter, bool local) {
    auto& table = local ? files_[parameter.place.file].local : global_;
    const auto [at, is_new] = table.try_emplace(upper(name), std::move(parameter));
    return is_new ? nullptr : &at->second;
}

const Parameter* Parameters::find(std::string_view name, std::uint32_t from_file) const {
    const std::string key = upper(name);
    for (std::optional<std::uint32_t> file = from_file; file; file = files_[*file].parent)
        if (const auto at = files_[*file].local.find(key); at != files_[*file].local.end())
            return &at->second;
    const auto at = global_.find(key);
    return at == global_.end() ? nullptr : &at->second;
}

std::optional<Value> Parameters::value(std::string_view name, std::uint32_t from_file) const {
    const Parameter* parameter = find(name, from_file);
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
