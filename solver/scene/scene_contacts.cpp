// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a scene's contacts and rigid walls need, worked out once; and how its contacts begin.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/broad_phase/coinciding.hpp"
#include "fabric/materials/law.hpp"
#include "solver/scene/scene_state.hpp"
#include "solver/scene/scene_surface.hpp"

namespace corpuscle {
namespace {

double contact_thickness(const Part& part) {
    return std::isnan(part.contact_thickness) ? part.thickness : part.contact_thickness;
}

/// Speed at which gaps that start below the contact thickness grow to it, in speeds of sound along
/// the cloth: nothing is thrown, and a fold of 0.33 mm has its thickness after a few milliseconds.
constexpr double GROWTH_SPEED = 4e-4;

/// Way by which cloth that lies exactly on other cloth is moved off it, in contact thicknesses.
constexpr double LIFT = 3e-3;

/// Modulus through the thickness over the lesser one in the plane: of woven fabric of 300 MPa it is
/// 10 MPa, which gives way by 1 % at 1 bar and by 4 % at 4.
constexpr double THROUGH_THICKNESS = 1.0 / 30.0;

/// Modulus of each material; of those that have none the greatest of the others.            [Pa]
std::vector<double> contact_moduli(const std::vector<fabric::Material>& materials) {
    struct Modulus {
        double operator()(const fabric::FabricCard& card) const {
            return std::min(card.E_warp, card.E_weft);
        }
        double operator()(const fabric::ElasticCard& card) const { return card.E; }
        double operator()(const fabric::NullCard&) const { return 0.0; }
        double operator()(const fabric::OwnCard& card) const {
            if (card.law == nullptr) return 0.0;
            const fabric::PlaneModuli moduli = card.law->moduli();
            return std::min(moduli.warp, moduli.weft);
        }
        double operator()(const fabric::RigidCard& card) const { return card.E; }
    };
    constexpr double OF_NONE = 3e8;  ///< where no material has a modulus
    std::vector<double> out;
    double greatest = 0.0;
    for (const fabric::Material& material : materials) {
        const double E = std::visit(Modulus{}, material.card);
        out.push_back(E > 0.0 ? E : 0.0);
        greatest = std::max(greatest, out.back());
    }
    for (double& E : out)
        if (E == 0.0) E = greatest > 0.0 ? greatest : OF_NONE;
    return out;
}

/// Time in which gaps that start below the contact thickness grow to it, but for 1/e: the longest of
/// all cloth's; without cloth ten times the longest of the rigid parts', for nothing hurries. [s]
double growth_time(const Model& model, const std::vector<double>& modulus) {
    double of_cloth = 0.0, of_bodies = 0.0;
    for (const Part& part : model.parts) {
        const fabric::MaterialCard& card = model.materials[part.material].card;
        const double thickness = contact_thickness(part);
        if (!(thickness > 0.0)) continue;
        const double sound = std::sqrt(modulus[part.material] / fabric::density(card));
        double& longest = std::holds_alternative<fabric::RigidCard>(card) ? of_bodies : of_cloth;
        longest = std::max(longest, thickness / (GROWTH_SPEED * sound));
    }
    if (of_cloth > 0.0) return of_cloth;
    return of_bodies > 0.0 ? 10.0 * of_bodies : 0.01 * model.end_time;
}

/// Parts as contact knows them: a part of which a card means some shells alone is several.
class ContactParts {
public:
    explicit ContactParts(const Model& model)
        : model_(model),
          count_(model.parts.size()),
          group_(model.shells.size(), -1),
          groups_of_(model.parts.size()) {
        for (const ContactShells& shells : model.contact_shells)
            for (const auto* some : {&shells.first, &shells.second}) {
                if (some->empty()) continue;
                std::vector<bool>& is_on = is_on_.emplace_back(model.shells.size(), false);
                for (const Index shell : *some) is_on[shell] = true;
            }
        for (std::size_t s = 0; s < group_.size(); ++s) group_[s] = find(s);
    }

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] Index of_shell(Index shell) const { return group_[shell]; }

    /// The card in terms of them.
    [[nodiscard]] contact::ContactCard told(std::size_t row) const {
        contact::ContactCard card = model_.contacts[row];
        const bool has_some = row < model_.contact_shells.size();
        const ContactShells some = has_some ? model_.contact_shells[row] : ContactShells{};
        card.parts = groups(card.parts, some.first);
        card.other_parts = groups(card.other_parts, some.second);
        return card;
    }

private:
    /// Shells of one part that the same sides of cards mean are a group.
    Index find(std::size_t shell) {
        auto& groups = groups_of_[model_.shells[shell].part];
        std::vector<bool> meant;
        for (const std::vector<bool>& is_on : is_on_) meant.push_back(is_on[shell]);
        for (const auto& [known, group] : groups)
            if (known == meant) return group;
        // whole parts keep their rows
        const Index group =
            groups.empty() ? model_.shells[shell].part : static_cast<Index>(count_++);
        groups.emplace_back(std::move(meant), group);
        return group;
    }

    [[nodiscard]] std::vector<Index> groups(const std::vector<Index>& parts,
                                            const std::vector<Index>& some) const {
        std::vector<bool> is_parted(model_.parts.size(), false);
        std::vector<Index> out;
        for (const Index shell : some) {
            is_parted[model_.shells[shell].part] = true;
            out.push_back(group_[shell]);
        }
        for (const Index part : parts)
            if (!is_parted[part])
                for (const auto& [unused, group] : groups_of_[part]) out.push_back(group);
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    const Model& model_;
    std::size_t count_;
    std::vector<std::vector<bool>> is_on_;  ///< sides that mean some shells × shells
    std::vector<Index> group_;              ///< by shell
    std::vector<std::vector<std::pair<std::vector<bool>, Index>>> groups_of_;  ///< by part
};

/// Parts that contact cards mean.
std::vector<bool> parts_in_contact(const Model& model) {
    std::vector<bool> wanted(model.parts.size(), false);
    for (const contact::ContactCard& card : model.contacts)
        for (const auto* parts : {&card.parts, &card.other_parts})
            for (const Index part : *parts) wanted[part] = true;
    return wanted;
}

}  // namespace

/// Cloth that lies exactly on other cloth has no sides: it is moved apart by less than shows.
void SceneState::part_coinciding_cloth() {
    if (model.contacts.empty()) return;
    std::vector<bool> wanted = parts_in_contact(model);
    double thickness = INF;
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        const auto& card = model.materials[model.parts[p].material].card;
        wanted[p] = wanted[p] && !std::holds_alternative<fabric::RigidCard>(card);
        if (wanted[p] && contact_thickness(model.parts[p]) > 0.0)
            thickness = std::min(thickness, contact_thickness(model.parts[p]));
    }
    if (!(thickness < INF)) return;
    const double lift = LIFT * thickness;
    const Points lifts =
        contact::lifts_of_coinciding(triangles_of(model, wanted).triangles, model.x, lift);
    std::size_t moved = 0;
    for (std::size_t n = 0; n < lifts.size(); ++n) {
        if (lifts[n].isZero(0.0)) continue;
        model.x[n] += lifts[n];
        ++moved;
    }
    if (moved > 0)
        model.warnings.push_back(
            fmt::format("{} nodes lie exactly on other cloth: moved off it by up to {:.3g}, along "
                        "the shells' normals, so that contact knows the sides",
                        moved, lift));
}

/// One contact for all cards: what may touch by any of them.
void SceneState::build_contacts() {
    if (model.contacts.empty()) return;
    std::vector<std::uint8_t> held = held_nodes();
    std::vector<Index> body(model.x.size(), -1);
    for (std::size_t b = 0; b < bodies.all.size(); ++b)
        for (const Index n : bodies.all[b].nodes()) {
            body[n] = static_cast<Index>(b);
            held[n] = 0;
        }
    for (const TiedNode& tie : ties.all()) held[tie.node] = 0;
    SceneTriangles facets = triangles_of(model, parts_in_contact(model));
    Points reference = model.x;
    for (std::size_t s = 0; s < cloth.reference.size(); ++s)
        for (int c = 0; c < 4; ++c) reference[model.shells[s].nodes[c]] = cloth.reference[s][c];

    const std::vector<double> modulus = contact_moduli(model.materials);
    const ContactParts parts(model);
    std::vector<std::uint8_t> held_axes = supports.held();
    for (const TiedNode& tie : ties.all()) held_axes[tie.node] = 0;
    contact::ContactSetup setup;
    for (std::size_t c = 0; c < model.contacts.size(); ++c) setup.cards.push_back(parts.told(c));
    setup.triangles = std::move(facets.triangles);
    for (const Index shell : facets.shell) {
        const Index part = model.shells[shell].part;
        setup.part.push_back(parts.of_shell(shell));
        setup.thickness.push_back(contact_thickness(model.parts[part]));
        setup.modulus.push_back(THROUGH_THICKNESS * modulus[model.parts[part].material]);
    }
    setup.parts = parts.size();
    setup.growth_time = growth_time(model, modulus);
    setup.held_axes = held_axes;
    setup.node_mass = mass_met();
    setup.reference_x = reference;
    setup.x0 = model.x;
    setup.curves = model.curves;
    setup.held = held;
    setup.body = body;
    obstacles.contact_shell = std::move(facets.shell);
    obstacles.contact.emplace(setup);
    impulses.contacts = ImpulseBook(model.contacts.size());
}

void SceneState::build_walls() {
    std::vector<std::uint8_t> held = held_nodes();
    for (const TiedNode& tie : ties.all()) held[tie.node] = 0;
    for (contact::WallCard card : model.walls) {
        const std::size_t listed = card.nodes.size();
        const auto has_body = [&](Index n) {
            return !bodies.of_node.empty() && bodies.of_node[n] >= 0;
        };
        std::erase_if(card.nodes, [&](Index n) { return held[n] && !has_body(n); });
        if (card.nodes.size() < listed)
            model.warnings.push_back(
                fmt::format("rigid wall {}: {} of its nodes are held and pass it freely", card.id,
                            listed - card.nodes.size()));
        std::erase_if(card.nodes, [&](Index n) { return !(mass_met()[n] > 0.0) && !has_body(n); });
        const Index curve = card.motion.curve;
        obstacles.walls.emplace_back(card, curve >= 0 ? &model.curves[curve] : nullptr,
                                     model.end_time);
        const auto inside = obstacles.walls.back().inside(model.x);
        if (card.birth <= 0.0 && inside.nodes > 0)
            model.warnings.push_back(fmt::format(
                "rigid wall {}: {} of its {} nodes lie inside it, node {} deepest, by {:.3g}: they "
                "pass it freely until they have come out",
                card.id, inside.nodes, card.nodes.size(), model.node_id[inside.deepest],
                inside.depth));
    }
    impulses.walls = ImpulseBook(obstacles.walls.size());
}

BadStarts SceneState::bad_starts() const {
    BadStarts out;
    const auto ids = [&](const auto& pairs, auto& to) {
        for (const auto& [a, b] : pairs) {
            const int first = model.shells[obstacles.contact_shell[a]].id,
                      second = model.shells[obstacles.contact_shell[b]].id;
            if (first != second) to.emplace_back(std::minmax(first, second));
        }
        std::sort(to.begin(), to.end());
        to.erase(std::unique(to.begin(), to.end()), to.end());
    };
    if (obstacles.contact) {
        ids(obstacles.contact->crossing(), out.crossing);
        ids(obstacles.contact->close_starts(), out.close);
    }
    return out;
}

}  // namespace corpuscle
