// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/keyword_table.hpp"

#include <fmt/format.h>

#include <fstream>

#include "io/deck.hpp"
#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// What cards may refer to by the ids 1 and 2.
constexpr const char* SCENE = R"(*KEYWORD
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
*ELEMENT_SHELL
1,1,1,2,3,4
*PART
cloth
1,1,1
*PART
rigid
2,1,2
*SECTION_SHELL
1,5
0.3
*MAT_ELASTIC
1,700.,1.e8,0.3
*MAT_RIGID
2,700.,1.e8,0.3



*DEFINE_CURVE
1
0,1
1,3
*SET_NODE
1
1,2,3
*SET_PART
1
1
*SET_SHELL
1
1
*SET_SEGMENT
1
1,2,3,4
*DEFINE_VECTOR
1,0,0,0,1
*DEFINE_BOX
1,-9,9,-9,9,-9,9
*DEFINE_COORDINATE_SYSTEM
1,0,0,0,1
0,1
*DEFINE_CPM_VENT
1,1
*DEFINE_CPM_NPDATA
1,1
*DEFINE_CPM_GAS_PROPERTIES
1,0.028,29
)";

/// Cards that bring readers to all their fields.
constexpr const char* ROWS[] = {"1,1,1,1,1,1,1,1,1,1",
                                "1,0,0,0,0,0,0,0,0,0",
                                "2,2,2,2,2,2,2,2",
                                "1,0.5,0.5,0.5,0.5,0.5,0.5,0.5",
                                "7,1,1,1,1,1,1,1,1,1",
                                "0,0,0,0,0,0,0,0",
                                "1,1,0,0",
                                "1,1,1,1",
                                "1,1,2,2",
                                "1,1,3,3",
                                "1,1,4,2",
                                "1,2,0,-1"};

/// Longer examples, of keywords whose cards depend on each other.
const std::pair<const char*, const char*> EXAMPLES[] = {
    {"AIRBAG_PARTICLE",
     "1,0,2,0,0,1,0.1\n1000,1,1,293,1e5,1,1,1\n+1,1,1,1,1,1,1,1\n+1,1,1,1,1,1,1,1\n"
     "2,1,1,1,2,3,0,0\n1,0,1,0.1,1,1,1,1\n1,0,0.7,1,1,1,1\n1e5,293,0.028,29,0,0,100,1\n"
     "1,1,0.028,29,0,0,1\n1,1.0,-3,30,1,1,1,1\n0.1\n"},
    {"AIRBAG_PARTICLE",
     "1,1,1,1,0,3,-1\n1000,1,1,293,1e5,2\n0,1,1\n1,0,-1,-1\n1,1,-1,-1\n1,2,1\n"
     "1,0,-1\n1,1,1,1,1\n1,1,0.028,29,0,0,1\n1,1.0,1,30,1\n"},
    {"AIRBAG_PARTICLE", "1\n1000,1,1\n1,1,1\n1e5,293,-1\n1,1,-1\n1,1.0\n"},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL", "1,1\n0,0,1,1,1,1,1,1\n1,1,1,1,1,1\n"},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL", "1,1\n1,1.4,300,1,-1,-1,1e5,1.2\n"},
    {"AIRBAG_WANG_NEFSKE", "1,1\n1,1.4,300,1,1\n1,1,-1,1,1,1,-1,1\n1e5,1.2\n\n"},
    {"AIRBAG_HYBRID", "1,1\n293,1e5,1.2,8.3\n1,1,-1,1,1,1,-1,1\n0,0,1\n1,1,0,0.028,1,28\n\n"},
    {"AIRBAG_SIMPLE_PRESSURE_VOLUME", "1,1\n-1,1\n"},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL",
     "1,1\n2.5,3.5,300,1,1,1,1e5,1.2\n*AIRBAG_SIMPLE_AIRBAG_MODEL\n1,1\n"
     "2.5,3.5,300,1,1,1,1e5,1.2\n*AIRBAG_INTERACTION\n1,2,-1,-1,1,1\n1,2,0,1,1\n"},
    {"MAT_ADD_AIRBAG_POROSITY_LEAKAGE", "1,-1,-1\n"},
    {"MAT_FABRIC", "9,800,1e8,1e8,0,0.3\n1e7\n0,-1,-1,0,0,2,7,-1\n\n\n"},
    {"BOUNDARY_PRESCRIBED_MOTION_NODE", "1,4,0,1,1,1\n"},
    {"BOUNDARY_PRESCRIBED_MOTION_SET", "1,4,0,1,1,1\n"},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", "2,4,0,1,1,1\n"},
    {"CONSTRAINED_JOINT_STIFFNESS_GENERALIZED",
     "1,2,2,1,1\n1,1,1,1,1,1\n1,1,1,1,1,1\n1,1,1,1,1,1\n"},
    {"DEFORMABLE_TO_RIGID", "1,2,PART\n"},
    {"LOAD_RIGID_BODY", "2,4,1,1,0,1,2,3\n2,1,1,1,1\n"},
    {"SET_NODE_GENERAL", "9\nPART,1\nSET,1\nSET_SHELL,1\nBOX,1\n"},
    {"SET_NODE_ADD", "9\n1,-1\n"},
    {"SENSOR_CONTROL", "1,BELTPRET,1\n"},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", "2,1,0,1,1,-1,0,0.1\n"},
    {"SET_PART_GENERAL", "9\nSET,1\n"},
    {"SET_SHELL_GENERAL", "9\nPART,1\nSET,1\n"},
    {"SET_SEGMENT_GENERAL", "9\nSHELL,1\nSET_SHELL,1\nSET,1\n"},
    {"DEFINE_CPM_NPDATA", "9,-1,-1\n"},
    {"DEFINE_CPM_CHAMBER", "9,1\n1,1,2,1\n1,0,1\n1,1,1\n"},
    {"AIRBAG_WANG_NEFSKE",
     "1,1\n0,0,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n\n"
     "300,26,0.01,0.028,8.3,1\n"},
    {"MAT_FABRIC",
     "9,800,1e8,1e8,0,0.3,0.3\n1e7,0,0,0,1,0.3,0.1,0.1\n2,0.1,0.1,0.1,1,14,-7,0\n"
     "1,1,1,1,1\n0,0,1,1,0,0,0,0\n1,1,1,0,0,0,1,1\n1,1,1,1,1,1,1\n"
     "1,1,1,1,0,1,1,1\n"},
    {"MAT_RIGID", "9,700,1e8,0.3,1,1,1,1\n-1,1,111111\n1,1,1,1,1,1\n"},
    {"SECTION_SHELL", "9,5,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n"},
    {"DEFINE_TRANSFORMATION", "1\nTRANSL,1,1,1\nSCALE,2,2,2\nROTATE,0,0,1,0,0,0,30\n"},
    {"DEFINE_TRANSFORMATION", "9\nPOS6N,1,2,3,2,3,4\n"},
    {"SET_NODE_GENERAL", "9\nNODE,1,2,3,4,1,2,3\nALL\n"},
    {"SET_PART_GENERAL", "9\nPART,1,2,1,2,1,2,1\nALL\n"},
    {"SET_SHELL_GENERAL", "9\nELEM,1,1,1,1,1,1,1\nALL\n"},
    {"SET_SEGMENT_GENERAL", "9\nPART,1,2,1\nALL\n"},
    {"DEFINE_BOX", "1,0,1,0,1,0,1\n"},
    {"DEFINE_CURVE_SMOOTH", "9,0,1,0,10,1,0\n"},
    {"DEFINE_CURVE_FUNCTION", "9,0\n2*TIME\n"},
    {"AIRBAG_HYBRID",
     "1,1\n293,1e5,1.2,8.3,1,1\n1,1,1,1,1,1,1,1\n1,1,1,1,1,1\n"
     "1,1,0,0.028,1,28,0,0\n1\n"},
    {"AIRBAG_SIMPLE_PRESSURE_VOLUME", "1,1\n1e5,2,0,1\n"},
    {"AIRBAG_INTERACTION", "1,2,0.1,1,1,1,1\n"},
    {"AIRBAG_ADIABATIC_GAS_MODEL", "1,1\n1,1,1.4,1e5,1e5,1.2\n"},
    {"SECTION_BEAM", "9,2,1,1,1\n1,1,1,1,1\n"}};

void read(const std::filesystem::path& folder, const std::string& cards, FieldLog& log) {
    const auto file = folder / "table.k";
    std::ofstream(file) << SCENE << cards << "*END\n";
    DeckOptions options;
    options.log = &log;
    try {
        (void)read_deck(file, options);
    } catch (const InputError&) {  // most examples are no sense
    }
}

FieldLog logged(const std::filesystem::path& folder) {
    constexpr int MOST_CARDS = 14;
    FieldLog log;
    for (const keywords::Keyword& entry : keywords::all())
        for_each_word(entry.names, [&](std::string_view name) {
            const auto with = [&](const std::string& keyword) {
                for (const char* row : ROWS) {
                    std::string cards = fmt::format("*{}\n", keyword);
                    for (int i = 0; i < MOST_CARDS; ++i) cards += std::string(row) + "\n";
                    read(folder, cards, log);
                }
            };
            with(std::string(name));
            for_each_word(entry.options, [&](std::string_view option) {
                with(fmt::format("{}_{}", name, option));
            });
        });
    for (const auto& [name, cards] : EXAMPLES)
        read(folder, fmt::format("*{}\n{}", name, cards), log);
    return log;
}

std::string listed(const FieldLog::Fields& fields, FieldUse use) {
    std::string text;
    for (const FieldLog::Field& field : fields)
        if (field.use == use) text += (text.empty() ? "" : " ") + field.name;
    return text;
}

/// "IDNOFF: N1 N2; IDPOFF: PID"
std::string id_fields(const FieldLog::Fields& fields) {
    std::string text;
    for (std::size_t kind = 0; kind < ID_KINDS; ++kind) {
        std::string names;
        for (const FieldLog::Field& field : fields)
            if ((field.ids >> kind & 1U) != 0) names += " " + field.name;
        if (!names.empty())
            text += fmt::format("{}{}:{}", text.empty() ? "" : "; ", OFFSET_FIELDS.at(kind), names);
    }
    return text;
}

}  // namespace

std::string keyword_table(const std::filesystem::path& folder) {
    const FieldLog log = logged(folder);
    std::string text =
        "# Keywords and their fields\n\n"
        "This table is generated from the readers (`test_keyword_table`). A field is *acted on*; "
        "or "
        "it is *warned of* where a deck sets it; or it does *not matter*; or it is *refused*: set, "
        "it is a fault. `KEYWORDS.md` says what is decided about them.\n\n"
        "| keyword | suffixes | acted on | warned of | no matter | refused | suffixes refused |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const keywords::Keyword& entry : keywords::all())
        for_each_word(entry.names, [&](std::string_view name) {
            const auto at = log.keywords().find(std::string(name));
            const FieldLog::Fields fields =
                at != log.keywords().end() ? at->second : FieldLog::Fields{};
            text += fmt::format(
                "| `*{}` | {} | {} | {} | {} | {} | {} |\n", name, entry.options,
                listed(fields, FieldUse::ACTED_ON), listed(fields, FieldUse::WARNED),
                listed(fields, FieldUse::HARMLESS), listed(fields, FieldUse::REFUSED), entry.later);
        });
    text +=
        "\n## Ids\n\nFields that hold an id, and the field of `*INCLUDE_TRANSFORM` whose offset is "
        "added to it; one that is told by another field (STYPE1, SURFATYP, ...) stands under "
        "each.\n\n| keyword | offsets and fields |\n|---|---|\n";
    for (const keywords::Keyword& entry : keywords::all())
        for_each_word(entry.names, [&](std::string_view name) {
            const auto at = log.keywords().find(std::string(name));
            if (at == log.keywords().end()) return;
            if (const std::string ids = id_fields(at->second); !ids.empty())
                text += fmt::format("| `*{}` | {} |\n", name, ids);
        });
    text +=
        "\n## Other keywords\n\nMaterials of other names are read for their number and density "
        "alone: elements of "
        "them are refused, but for solids, which are taken as rigid.\n\n"
        "Not read, with a note, for they cannot change the answer: keywords that begin with ";
    const auto listed = [](std::string_view words) {
        std::string beginnings;
        for_each_word(words, [&](std::string_view word) {
            beginnings += fmt::format("{}`*{}`", beginnings.empty() ? "" : ", ", word);
        });
        return beginnings;
    };
    return fmt::format(
        "{}{}.\n\nNot read, with a note; what refers to one is a fault that names it: {}.\n", text,
        listed(keywords::harmless_beginnings()), listed(keywords::unread_definitions()));
}

}  // namespace corpuscle::io
