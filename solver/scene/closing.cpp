// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/closing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "solver/base/error.hpp"
#include "solver/scene/held_ties.hpp"
#include "solver/scene/rims.hpp"

namespace corpuscle {
namespace {

/// A bag of either kind: the shells that close it, and how more of them join.
class Bag {
public:
    Bag(Model& model, gas::BagCard& card) : model_(model), particles_(&card) {}
    Bag(Model& model, gas::UniformBagCard& card) : model_(model), uniform_(&card) {}

    [[nodiscard]] std::string name() const {
        return particles_ != nullptr ? particles_->name()
                                     : fmt::format("{} {}", uniform_->keyword, uniform_->id);
    }
    [[nodiscard]] std::vector<Index> shells() const {
        if (uniform_ != nullptr) return uniform_->shells;
        std::vector<Index> shells;
        for (std::size_t s = 0; s < model_.shells.size(); ++s)
            if (holds(particles_->external_parts, model_.shells[s].part))
                shells.push_back(static_cast<Index>(s));
        return shells;
    }
    /// Parts that are of the bag, closing or inside.
    [[nodiscard]] bool has(Index part) const {
        if (particles_ != nullptr)
            return holds(particles_->external_parts, part) ||
                   holds(particles_->internal_parts, part);
        return std::any_of(uniform_->shells.begin(), uniform_->shells.end(),
                           [&](Index s) { return model_.shells[s].part == part; });
    }
    void add(Index part) {
        if (particles_ != nullptr) particles_->external_parts.push_back(part);
        for (std::size_t s = 0; uniform_ != nullptr && s < model_.shells.size(); ++s)
            if (model_.shells[s].part == part) uniform_->shells.push_back(static_cast<Index>(s));
    }

private:
    static bool holds(const std::vector<Index>& rows, Index row) {
        return std::find(rows.begin(), rows.end(), row) != rows.end();
    }

    Model& model_;
    gas::BagCard* particles_ = nullptr;
    gas::UniformBagCard* uniform_ = nullptr;
};

std::string name_of(const Model& model, Index part) {
    const Part& p = model.parts[part];
    return p.title.empty() ? fmt::format("part {}", p.id)
                           : fmt::format("part {} \"{}\"", p.id, p.title);
}

/// Supports and motions that tied nodes have and their edges' ends have not do not count.
void let_go(Model& model, const Bag& bag, const std::vector<TiedNode>& ties) {
    const HeldTies holds(model);
    std::vector<TiedNode> lost;
    std::copy_if(ties.begin(), ties.end(), std::back_inserter(lost),
                 [&](const TiedNode& tie) { return holds.is_lost(tie); });
    for (const TiedNode& tie : lost) {
        release(model, tie.node);
        model.warnings.push_back(fmt::format(
            "{}: node {} hangs on edge {}-{} and is tied to it: the support or motion that it has "
            "and nodes {} and {} have not does not count; give them the same, or join the meshes",
            bag.name(), model.node_id[tie.node], model.node_id[tie.ends[0]],
            model.node_id[tie.ends[1]], model.node_id[tie.ends[0]], model.node_id[tie.ends[1]]));
    }
}

/// Nodes that hang on free edges of the bag, tied from now on.
void tie_hanging_nodes(Model& model, const Bag& bag) {
    const std::vector<TiedNode> ties = hanging_nodes(model, free_edges(model, bag.shells()));
    if (ties.empty()) return;
    model.tied_nodes.insert(model.tied_nodes.end(), ties.begin(), ties.end());
    let_go(model, bag, ties);
    std::string which;
    constexpr std::size_t FEW = 5;
    for (std::size_t k = 0; k < std::min(FEW, ties.size()); ++k)
        which += fmt::format("{}{} on edge {}-{}", k == 0 ? "" : ", ", model.node_id[ties[k].node],
                             model.node_id[ties[k].ends[0]], model.node_id[ties[k].ends[1]]);
    model.mendings.push_back(fmt::format(
        "{}: {} hanging node{} tied to the ends of the edge {} lie{} on: {}{}", bag.name(),
        ties.size(), ties.size() == 1 ? "" : "s", ties.size() == 1 ? "it" : "they",
        ties.size() == 1 ? "s" : "", which, ties.size() > FEW ? ", ..." : ""));
}

/// A part all of whose free edges are free edges of the bag closes holes of it; with several such
/// at the same hole nobody can say which.
void join_parts(Model& model, Bag& bag) {
    for (;;) {
        const EdgeSet open = free_edges(model, bag.shells());
        if (open.empty()) return;
        std::vector<Index> fits;
        for (std::size_t p = 0; p < model.parts.size(); ++p) {
            const auto part = static_cast<Index>(p);
            if (bag.has(part)) continue;
            const EdgeSet rim = free_edges(model, shells_of(model, part));
            if (!rim.empty() && std::includes(open.begin(), open.end(), rim.begin(), rim.end()))
                fits.push_back(part);
        }
        // parts at one hole exclude each other
        std::erase_if(fits, [&](Index part) {
            const EdgeSet rim = free_edges(model, shells_of(model, part));
            return std::any_of(fits.begin(), fits.end(), [&](Index other) {
                const EdgeSet others = free_edges(model, shells_of(model, other));
                return other != part &&
                       std::any_of(others.begin(), others.end(),
                                   [&](const auto& edge) { return rim.contains(edge); });
            });
        });
        if (fits.empty()) return;
        for (const Index part : fits) {
            bag.add(part);
            model.mendings.push_back(
                fmt::format("{}: {} joins it: its {} shells close a hole of {} edges", bag.name(),
                            name_of(model, part), shells_of(model, part).size(),
                            free_edges(model, shells_of(model, part)).size()));
        }
    }
}

/// A part without mass that nothing but the gas knows.
Index add_lid_part(Model& model, const std::string& title) {
    Part lid;
    for (const Part& part : model.parts) lid.id = std::max(lid.id, part.id + 1);
    lid.title = title;
    lid.thickness = 0.0;
    lid.material = static_cast<Index>(model.materials.size());
    model.materials.push_back({0, "lid", fabric::NullCard{0.0}});
    model.parts.push_back(lid);
    return static_cast<Index>(model.parts.size()) - 1;
}

void put_lid(Model& model, Bag& bag, const Hole& hole) {
    const Index part = add_lid_part(model, fmt::format("lid of {}", bag.name()));
    int id = 0;
    for (const Shell& shell : model.shells) id = std::max(id, shell.id);
    for (const Triangle& t : lid_over(hole.rim, model.x))
        model.shells.push_back({++id, part, {t[0], t[1], t[2], t[2]}});
    bag.add(part);
    const std::string what =
        fmt::format("{}: {} is closed by a lid without mass, part {}, that no gas passes",
                    bag.name(), hole.text(model), model.parts[part].id);
    model.mendings.push_back(what);
    model.warnings.push_back(what);
}

/// The parts that touch the rim, in the words of what would close the hole.
std::string advice(const Model& model, const Bag& bag, const Hole& hole) {
    std::map<Index, std::size_t> touching;
    const std::set<Index> rim(hole.rim.begin(), hole.rim.end());
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (bag.has(static_cast<Index>(p))) continue;
        std::set<Index> shared;
        for (const Index s : shells_of(model, static_cast<Index>(p)))
            for (const Index n : model.shells[s].nodes)
                if (rim.contains(n)) shared.insert(n);
        if (shared.size() == rim.size())
            return fmt::format("; {} has all nodes of its rim: add it to the bag's set",
                               name_of(model, static_cast<Index>(p)));
        if (!shared.empty()) touching[static_cast<Index>(p)] = shared.size();
    }
    std::string text;
    for (const auto& [part, nodes] : touching)
        text += fmt::format("{} {} ({} of {} nodes)", text.empty() ? "; at its rim:" : ",",
                            name_of(model, part), nodes, rim.size());
    return text;
}

void close_bag(Model& model, Bag bag, std::vector<Fault>& faults) {
    if (free_edges(model, bag.shells()).empty()) return;
    if (model.closes_bags) {
        tie_hanging_nodes(model, bag);
        join_parts(model, bag);
    }
    const double area = area_of(model, bag.shells());
    for (const Hole& hole : holes(model, bag.shells())) {
        if (model.closes_bags && hole.is_loop && hole.area <= model.lid_share * area) {
            put_lid(model, bag, hole);
            continue;
        }
        const std::string what = "is not closed: " + hole.text(model) + advice(model, bag, hole);
        Fault fault{.of = bag.name(), .why = what};
        if (model.closes_bags && hole.is_loop)
            fault = {.of = bag.name() + ": " + what,
                     .property = Property::HOLE_SHARE,
                     .value = hole.area / area,
                     .why = fmt::format("lids close up to {:.3g}", model.lid_share)};
        faults.push_back(std::move(fault));
    }
}

}  // namespace

void close_bags(Model& model) {
    std::vector<Fault> faults;
    for (std::size_t b = 0; b < model.bags.size(); ++b)
        close_bag(model, Bag(model, model.bags[b]), faults);
    for (std::size_t b = 0; b < model.uniform_bags.size(); ++b)
        close_bag(model, Bag(model, model.uniform_bags[b]), faults);
    if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace corpuscle
