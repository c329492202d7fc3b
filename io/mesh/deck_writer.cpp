// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/mesh/deck_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

constexpr std::size_t LARGEST_ID = 99999999;  // 8 columns
constexpr std::size_t TITLE_COLUMNS = 70;

/// A card of text: one line that is neither a keyword nor a comment.
std::string title_card(std::string_view title) {
    const bool is_text = !title.empty() && title.front() != '*' && title.front() != '$';
    std::string card = is_text ? "" : " ";
    card += title.substr(0, TITLE_COLUMNS);
    for (char& c : card)
        if (c == '\n' || c == '\r') c = ' ';
    return card;
}

}  // namespace

std::string in_16_columns(double value) {
    std::string text = fmt::format("{}", value);
    for (int digits = 16; text.size() > 16; --digits) text = fmt::format("{:.{}g}", value, digits);
    return fmt::format("{:>16}", text);
}

void write_deck(const std::filesystem::path& file, const ImportedMesh& mesh,
                std::string_view title) {
    if (std::max(mesh.x.size(), mesh.shells.size()) > LARGEST_ID)
        throw InputError(
            fmt::format("{}: more than {} nodes or shells do not fit the 8 columns of "
                        "their numbers",
                        file.string(), LARGEST_ID));
    std::string deck = fmt::format(
        "*KEYWORD\n*TITLE\n{}\n$ a mesh only: add *SECTION_SHELL and *MAT_ of the parts' numbers\n",
        title_card(title));
    deck += "*NODE\n$#   nid               x               y               z\n";
    for (std::size_t n = 0; n < mesh.x.size(); ++n)
        deck += fmt::format("{:8d}{}{}{}\n", n + 1, in_16_columns(mesh.x[n].x()),
                            in_16_columns(mesh.x[n].y()), in_16_columns(mesh.x[n].z()));
    deck += "*ELEMENT_SHELL\n$#   eid     pid      n1      n2      n3      n4\n";
    for (std::size_t e = 0; e < mesh.shells.size(); ++e) {
        const auto& n = mesh.shells[e];
        deck += fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", e + 1, mesh.part[e] + 1, n[0] + 1,
                            n[1] + 1, n[2] + 1, n[3] + 1);
    }
    for (std::size_t p = 0; p < mesh.part_names.size(); ++p)
        deck += fmt::format("*PART\n{}\n$#     pid     secid       mid\n{:10d}{:10d}{:10d}\n",
                            title_card(mesh.part_names[p]), p + 1, p + 1, p + 1);
    replace_text(file, deck + "*END\n");
}

}  // namespace corpuscle::io
