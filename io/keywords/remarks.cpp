// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/remarks.hpp"

#include <fmt/format.h>

#include <vector>

#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {
namespace {

/// Beginnings of what cannot change the answer here: output, other solvers, and numerics that have
/// no counterpart.
constexpr std::string_view HARMLESS =
    "DATABASE_ COMMENT HOURGLASS INTERFACE_SPRINGBACK EOS_ DEFINE_SD_ORIENTATION "
    "INITIAL_FOAM_REFERENCE_GEOMETRY BOUNDARY_NON_REFLECTING DEFINE_FRICTION "
    "DEFINE_HEX_SPOTWELD_ASSEMBLY INITIAL_TEMPERATURE LOAD_THERMAL SET_BEAM SET_DISCRETE SET_SOLID "
    "CONTROL_ACCURACY CONTROL_ACOUSTIC CONTROL_AIRBAG CONTROL_ALE "
    "CONTROL_BULK_VISCOSITY CONTROL_CESE CONTROL_CHECK_SHELL CONTROL_CPU "
    "CONTROL_DEBUG "
    "CONTROL_DISCRETE_ELEMENT CONTROL_EFG "
    "CONTROL_ENERGY CONTROL_EXPLICIT_THERMAL CONTROL_FREQUENCY CONTROL_HOURGLASS CONTROL_IMPLICIT "
    "CONTROL_MPP CONTROL_NONLOCAL CONTROL_OUTPUT CONTROL_PARALLEL CONTROL_PORE_FLUID "
    "CONTROL_REMESHING CONTROL_REQUIRE_REVISION CONTROL_RIGID CONTROL_SPOTWELD_BEAM "
    "CONTACT_FORCE_TRANSDUCER CONTACT_INTERIOR CONTROL_ADAPTIVE CONTROL_ADAPSTEP "
    "CONTROL_SHELL CONTROL_SOLID CONTROL_SOLUTION CONTROL_SPH CONTROL_STRUCTURED CONTROL_SUBCYCLE "
    "CONTROL_THERMAL "
    "CONTROL_UNITS DEFINE_BOX_ADAPTIVE DEFINE_MATERIAL_HISTORIES DEFINE_TRACER_PARTICLES_2D "
    "ELEMENT_PLOTEL RIGIDWALL_FORCE_TRANSDUCER";

/// Beginnings of definitions that say nothing unless something refers to them.
constexpr std::string_view DEFINITIONS =
    "DEFINE_CONNECTION_PROPERTIES DEFINE_CONSTRUCTION_STAGES DEFINE_HAZ_PROPERTIES "
    "DEFINE_SPOTWELD_RUPTURE_STRESS SET_BOX SET_MODE "
    "DEFINE_FUNCTION DEFINE_TABLE DEFINE_FILTER DEFINE_PLANE DEFINE_REGION SENSOR_DEFINE "
    "SENSOR_SWITCH SET_2D_SEGMENT SET_TSHELL";

/// Beginnings of families of which LS-DYNA has more than is read here.
constexpr std::string_view LATER =
    "AIRBAG_ CONSTRAINED_ CONTACT_ DEFINE_ ELEMENT_ INITIAL_ LOAD_ MAT_ RIGIDWALL_ "
    "SECTION_";

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

bool begins_with_any(std::string_view keyword, std::string_view beginnings) {
    bool found = false;
    for_each_word(beginnings, [&](std::string_view b) { found |= keyword.starts_with(b); });
    return found;
}

std::string_view harmless_beginnings() {
    return HARMLESS;
}

std::string_view unread_definitions() {
    return DEFINITIONS;
}

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

std::string_view own_refusal(std::string_view keyword) {
    if (keyword.starts_with("SENSOR_")) return "is not supported yet: sensors switch nothing here";
    if (keyword == "CASE" || keyword.starts_with("CASE_"))
        return "is not supported: a run has one case, expected the keywords of that case alone";
    if (keyword.starts_with("DEFORMABLE_TO_RIGID_"))
        return "is not supported: no part becomes rigid or deforms again during a run, expected "
               "*DEFORMABLE_TO_RIGID of parts that are rigid from the start";
    return {};
}

std::string refusal(std::string_view keyword) {
    return begins_with_any(keyword, LATER) ? "is not supported yet" : "is not supported";
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
