// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck_mesh.hpp"

#include <algorithm>

#include "io/deck/keyword_reader.hpp"
#include "io/keywords/keywords.hpp"
#include "io/model/draft.hpp"
#include "io/model/file_places.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

void read_shells(Cards& cards, Draft& draft, DeckMesh& mesh) {
    static const Layout layout("EID:8 PID:8 N1:8 N2:8 N3:8 N4:8 N5:8 N6:8 N7:8 N8:8");
    while (cards.rows()) {
        Card c = cards.next(layout);
        mesh.shell_id.push_back(c.new_id(std::size_t{0}, draft.shells, mesh.shells.size()));
        mesh.part_id.push_back(c.id(std::size_t{1}, IdKind::PART, {1.0}));
        std::array<Index, 4> nodes{};
        for (std::size_t k = 0; k < 3; ++k) nodes[k] = c.row(k + 2, draft.nodes);
        const Index fourth = c.raw(4) == c.raw(5) ? -1 : c.row_or_none("N4", draft.nodes);
        nodes[3] = fourth < 0 ? nodes[2] : fourth;
        mesh.shells.push_back(c.file().facet(nodes));
    }
}

/// Greatest id of the sets of a kind, whatever is in them; of one without an id 0.
int last_set(const DeckText& text, std::string_view kind, const Parameters& parameters) {
    static const Layout layout("SID");
    Faults of_the_scene;  // none of a mesh
    int last = 0;
    for (const Block& block : text.blocks) {
        if (!block.keyword.starts_with(kind)) continue;
        of_the_scene.begin_block();
        Cards cards(block, of_the_scene, parameters);
        if (block.keyword.find("_TITLE") != std::string::npos) cards.title();
        last = std::max(last, cards.next(layout).id("SID", IdKind::SET));
    }
    return last;
}

}  // namespace

DeckMesh read_deck_mesh(const std::filesystem::path& file) {
    Faults faults;
    Parameters parameters({});
    DeckText text = read_keywords(file, parameters, faults);
    Model model;
    Draft draft(model);
    DeckMesh mesh;
    const auto for_blocks = [&](std::string_view keyword, const auto& read) {
        for (const Block& block : text.blocks) {
            if (block.keyword != keyword) continue;
            faults.begin_block();
            Cards cards(block, faults, parameters, keywords::find(block.keyword).suffixes);
            read(cards);
            cards.finish();
            faults.end_block(block.place, block.keyword);
        }
    };
    for_blocks("NODE", [&](Cards& cards) { keywords::node(cards, draft); });
    if (!text.inclusions.empty()) {
        for (const char* keyword : {"DEFINE_TRANSFORMATION", "DEFINE_TRANSFORMATION_TITLE"})
            for_blocks(keyword,
                       [&](Cards& cards) { keywords::define_transformation(cards, draft); });
        place_files(text, parameters, faults, draft);
    }
    for_blocks("ELEMENT_SHELL", [&](Cards& cards) { read_shells(cards, draft, mesh); });
    if (!text.files.empty() && mesh.shells.empty())
        faults.fault(text.end, "*ELEMENT_SHELL is missing, expected a mesh");
    if (faults.any()) throw InputError(faults.faults());
    mesh.last_node_set = last_set(text, "SET_NODE", parameters);
    mesh.last_part_set = last_set(text, "SET_PART", parameters);
    mesh.x = std::move(model.x);
    mesh.node_id = std::move(model.node_id);
    return mesh;
}

}  // namespace corpuscle::io
