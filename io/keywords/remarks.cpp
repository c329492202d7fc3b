// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/remarks.hpp"

#include <fmt/format.h>

#include <vector>

#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Output of LS-DYNA that is not written here, and CONTROL_CPU: names that are no slip of the pen.
bool is_output(std::string_view keyword) {
    constexpr std::string_view NAMES =
        "CONTROL_CPU DATABASE_BNDOUT DATABASE_CURVOUT DATABASE_DEFGEO DATABASE_DEFORC "
        "DATABASE_ELOUT DATABASE_GCEOUT DATABASE_JNTFORC DATABASE_NCFORC DATABASE_NODFOR "
        "DATABASE_SBTOUT DATABASE_SECFORC DATABASE_SLEOUT DATABASE_SPCFORC DATABASE_SPHOUT "
        "DATABASE_SSSTAT DATABASE_SWFORC DATABASE_TPRINT DATABASE_TRHIST";
    bool found = false;
    for_each_word(NAMES, [&](std::string_view name) { found |= keyword == name; });
    return found;
}

}  // namespace

std::string did_you_mean(std::string_view keyword) {
    std::vector<std::string_view> names = {"INCLUDE",
                                           "INCLUDE_TRANSFORM",
                                           "PARAMETER",
                                           "PARAMETER_EXPRESSION",
                                           "PARAMETER_DUPLICATION",
                                           "KEYWORD",
                                           "END"};
    for (const Keyword& entry : all())
        for_each_word(entry.names, [&](std::string_view name) { names.push_back(name); });
    for (const std::string_view beginnings : {harmless_beginnings(), unread_definitions()})
        for_each_word(beginnings, [&](std::string_view name) { names.push_back(name); });
    if (keyword.empty() || is_digit(keyword.back())) return {};  // *MAT_003 is no misspelt *MAT_001
    std::string_view bare = keyword;
    for (const std::string_view suffix : {"_ID", "_TITLE", "_LIST"})
        if (bare.ends_with(suffix)) bare.remove_suffix(suffix.size());
    const std::string_view meant = nearest(bare, names);
    return std::string(meant);
}

std::string_view reason(std::string_view base, std::string_view keyword) {
    if (!base.starts_with("CONSTRAINED_JOINT_")) return "";
    if (keyword.find("_FAILURE") != std::string_view::npos)
        return ": a joint here is exact and does not break";
    return ": the forces of joints are told in the axes of the deck";
}

std::string remark_on(std::string_view keyword) {
    if (keyword.starts_with("DATABASE_BINARY_INTFOR"))
        return "; contact pressure is in every frame of results.h5";
    if (keyword.starts_with("DATABASE_JNTFORC"))
        return "; forces of joints are in results.h5 (/history/joint) and in the export's binout";
    if (keyword.starts_with("INITIAL_TEMPERATURE") || keyword.starts_with("LOAD_THERMAL"))
        return "; no material here depends on temperature, the gas has its own";
    if (keyword.starts_with("DEFINE_FRICTION"))
        return "; friction is that of the contact's card: FS = -2 is refused";
    constexpr std::size_t SLIP = 2;
    constexpr std::size_t LONGEST = 60;
    if (keyword.size() > LONGEST || is_output(keyword)) return {};
    std::string hint;
    for (const Keyword& entry : all())
        for_each_word(entry.names, [&](std::string_view name) {
            if (edit_distance(keyword, name) <= SLIP)
                hint = fmt::format(" (did you mean *{}?)", name);
        });
    return hint;
}

}  // namespace corpuscle::io::keywords
