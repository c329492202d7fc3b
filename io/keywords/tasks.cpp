// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/deck/included/inclusion.hpp"
#include "io/keywords/mesh/set_order.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {

namespace {

/// Where ids of a keyword's family are kept, and the one that a keyword that is not read has on its
/// first card.
struct Defined {
    Registry* registry = nullptr;  ///< nullptr: ids of this keyword are not kept
    int id = 0;                    ///< 0: none
};

Defined defined_by(const Block& block, Draft& draft) {
    const std::pair<std::string_view, Registry*> families[] = {
        {"SET_NODE", &draft.node_sets},
        {"SET_PART", &draft.part_sets},
        {"SET_SHELL", &draft.shell_sets},
        {"SET_SEGMENT", &draft.segment_sets},
        {"SET_2D_SEGMENT", &draft.segment_sets},
        {"DEFINE_CURVE", &draft.curves},
        {"DEFINE_FUNCTION", &draft.curves},
        {"DEFINE_TABLE", &draft.curves},
        {"DEFINE_VECTOR", &draft.vectors},
        {"DEFINE_COORDINATE", &draft.coordinates},
        {"SECTION_", &draft.sections},
        {"MAT_", &draft.materials},
        {"DEFINE_CPM_VENT", &draft.cpm_vents},
        {"DEFINE_CPM_NPDATA", &draft.cpm_npdata},
        {"DEFINE_CPM_GAS_PROPERTIES", &draft.cpm_gases},
        {"DEFINE_TRANSFORMATION", &draft.transformations}};
    const bool has_title = block.keyword.find("_TITLE") != std::string::npos;
    if (block.lines.size() <= (has_title ? 1U : 0U)) return {};
    const std::size_t width = block.columns == Columns::LONG ? 20 : 10;
    std::string_view first = block.lines[has_title ? 1 : 0].text;
    first = first.substr(0, std::min(first.find(','), width));
    const auto id = parse_integer(trim(first));
    for (const auto& [family, registry] : families)
        if (id && block.keyword.starts_with(family))
            return {registry, shifted_id(block, registry->id_kind(), *id).value_or(0)};
    return {};
}

/// What would have been defined is spoilt by the fault of a keyword that is refused: others that
/// refer to it are no further faults.
void refuse(const Block& block, const Match& match, Faults& faults, Draft& draft) {
    faults.fault(block.place, fmt::format("*{} {}", block.keyword.substr(0, 80), match.remark));
    if (const Defined defined = defined_by(block, draft); defined.registry != nullptr)
        defined.registry->spoil(defined.id);
}

/// A definition on which nothing acts: what refers to it is a fault that names it.
void set_aside(const Block& block, Faults& faults, Draft& draft) {
    faults.note(block.place,
                fmt::format("*{} is not used: nothing that is read refers to it", block.keyword));
    if (const Defined defined = defined_by(block, draft); defined.registry != nullptr)
        defined.registry->set_aside(defined.id, {block.keyword, block.place});
}

/// Of keywords of which one holds.
void warn_of_repeats(const std::vector<Task>& tasks, Faults& faults) {
    std::map<const Keyword*, std::vector<const Block*>> blocks;
    for (const Task& task : tasks)
        if (task.match.keyword->holds_once) blocks[task.match.keyword].push_back(task.block);
    for (const auto& [keyword, all] : blocks) {
        if (all.size() < 2) continue;
        std::string others;
        for (std::size_t i = 0; i + 1 < all.size(); ++i)
            others.append(i == 0 ? "" : ", ").append(faults.where(all[i]->place));
        faults.warn(all.back()->place, fmt::format("*{} again: this one holds, not that of {}",
                                                   all.back()->keyword, others));
    }
}

}  // namespace

std::vector<Task> sort_out(const DeckText& text, const Parameters& parameters, Faults& faults,
                           Draft& draft) {
    draft.is_incomplete = text.is_incomplete;
    if (text.is_incomplete) draft.spoil_rest();
    std::vector<Task> tasks;
    for (const Block& block : text.blocks) {
        faults.begin_block();
        Match match = find(block.keyword);
        if (match.keyword != nullptr)
            tasks.push_back({&block, std::move(match)});
        else if (match.is_harmless)
            faults.note(block.place, fmt::format("*{} is not read, it cannot change the answer{}",
                                                 block.keyword.substr(0, 80), match.remark));
        else if (match.is_definition)
            set_aside(block, faults, draft);
        else
            refuse(block, match, faults, draft);
    }
    std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) {
        return a.match.keyword->phase < b.match.keyword->phase;
    });
    warn_of_repeats(tasks, faults);
    order_sets(tasks, parameters, faults, draft);
    return tasks;
}

}  // namespace corpuscle::io::keywords
