// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"
#include "io/keywords/remarks.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {

namespace {

using P = Phase;

constexpr std::string_view SHAPED = "MOTION DISPLAY ID TITLE";
constexpr std::string_view SHAPED_LATER = "INTERIOR DEFORM";
constexpr std::string_view CONTACTS = "ID TITLE MPP MORTAR SMOOTH INTERIOR";
constexpr std::string_view CONTACTS_LATER = "THERMAL FRICTION ORTHO INTERFERENCE";
constexpr std::string_view LISTS = "LIST COLUMN GENERATE INCREMENT COLLECT TITLE";
constexpr std::string_view LISTS_LATER = "SMOOTH";
constexpr bool ONCE = true;

const Keyword KEYWORDS[] = {
    {"TITLE", "", "", P::GROUND, title, ONCE},
    {"CONTROL_TERMINATION", "", "", P::GROUND, control_termination, ONCE},
    {"CONTROL_TIMESTEP", "", "", P::GROUND, control_timestep, ONCE},
    {"CONTROL_CPM", "", "", P::GROUND, control_cpm, ONCE},
    {"CONTROL_CONTACT", "", "", P::GROUND, control_contact, ONCE},
    {"CONTROL_DYNAMIC_RELAXATION", "", "", P::GROUND, control_dynamic_relaxation},
    {"TERMINATION_NODE TERMINATION_BODY TERMINATION_CONTACT TERMINATION_CURVE TERMINATION_SENSOR "
     "TERMINATION_DELETED_SHELLS TERMINATION_DELETED_SOLIDS",
     "", "", P::GROUND, termination},
    {"DATABASE_BINARY_D3PLOT", "", "", P::GROUND, database_d3plot, ONCE},
    {"DATABASE_BINARY_D3DUMP DATABASE_BINARY_RUNRSF", "", "", P::GROUND, database_d3dump, ONCE},
    {"DATABASE_ABSTAT", "", "", P::GROUND, database_abstat, ONCE},
    {"DATABASE_ABSTAT_CPM", "", "", P::GROUND, database_abstat_cpm, ONCE},
    {"DATABASE_MATSUM", "", "", P::GROUND, database_matsum, ONCE},
    {"DATABASE_GLSTAT", "", "", P::GROUND, database_glstat, ONCE},
    {"DATABASE_RCFORC", "", "", P::GROUND, database_rcforc, ONCE},
    {"DATABASE_RWFORC", "", "", P::GROUND, database_rwforc, ONCE},
    {"DATABASE_RBDOUT", "", "", P::GROUND, database_rbdout, ONCE},
    {"DATABASE_NODOUT", "", "", P::GROUND, database_nodout, ONCE},
    {"DATABASE_HISTORY_NODE", "ID LOCAL", "", P::SCENE, database_history_node},
    {"DATABASE_HISTORY_NODE_SET", "LOCAL", "", P::SCENE, database_history_node_set},

    {"DATABASE_CPM_SENSOR", "", "", P::SCENE, database_cpm_sensor},

    {"NODE", "", "MERGE RIGID SCALAR", P::NODE, node},
    {"NODE_TRANSFORM", "", "", P::PLACE, node_transform},
    {"DEFINE_TRANSFORMATION", "TITLE", "", P::TRANSFORMATION, define_transformation},
    {"DEFINE_CURVE", "TITLE", "", P::GROUND, define_curve},
    {"DEFINE_CURVE_SMOOTH", "TITLE", "", P::GROUND, define_curve_smooth},
    {"DEFINE_CURVE_FUNCTION", "TITLE", "", P::AXES, define_curve_function},
    {"DEFINE_BOX", "TITLE", "DRAWBEAD LOCAL SPH NODES", P::GROUND, define_box},
    {"DEFINE_VECTOR", "TITLE", "NODES", P::GROUND, define_vector},
    {"DEFINE_COORDINATE_SYSTEM", "TITLE", "IGES", P::AXES, define_coordinate_system},
    {"DEFINE_COORDINATE_VECTOR", "TITLE", "", P::AXES, define_coordinate_vector},
    {"DEFINE_COORDINATE_NODES", "TITLE", "", P::AXES, define_coordinate_nodes},
    {"SECTION_SHELL", "TITLE", "MISC EFG XFEM THERMAL", P::GROUND, section_shell},
    {"SECTION_SOLID", "TITLE", "EFG SPG MISC", P::GROUND, section_solid},
    {"SECTION_BEAM SECTION_DISCRETE SECTION_SEATBELT", "TITLE", "AISC", P::GROUND, section_other},
    {"SECTION_TSHELL SECTION_SPH SECTION_ALE1D SECTION_ALE2D SECTION_POINT_SOURCE",
     "TITLE ELLIPSE INTERACTION USER MIXTURE", "", P::GROUND, section_other},
    {"MAT_ELASTIC MAT_001", "TITLE", "FLUID", P::MATERIAL, mat_elastic},
    {"MAT_NULL MAT_009", "TITLE", "", P::MATERIAL, mat_null},
    {"MAT_RIGID MAT_020", "TITLE", "DISCRETE", P::MATERIAL, mat_rigid},
    {"MAT_FABRIC MAT_034", "TITLE", "MAP", P::MATERIAL, mat_fabric},
    {"MAT_ADD_AIRBAG_POROSITY_LEAKAGE", "TITLE", "", P::PART, mat_add_leakage},
    {"MAT_ADD_EROSION", "TITLE", "", P::SCENE, mat_add_erosion},
    {"PART", "CONTACT INERTIA", "PRINT ATTACHMENT REPOSITION AVERAGED", P::PART, part},
    {"PART_COMPOSITE", "", "CONTACT LONG TSHELL IGA SHELL", P::PART, part_composite},
    {"DEFORMABLE_TO_RIGID", "", "", P::STIFFENED, deformable_to_rigid},
    {"ELEMENT_BEAM", "THICKNESS SECTION SCALAR SCALR PID OFFSET ORIENTATION WARPAGE", "", P::SHELL,
     element_beam},
    {"ELEMENT_DISCRETE", "", "LCO", P::SHELL, element_discrete},
    {"ELEMENT_SEATBELT_ACCELEROMETER", "", "", P::SHELL, accelerometer},
    {"ELEMENT_SEATBELT_PRETENSIONER ELEMENT_SEATBELT_RETRACTOR ELEMENT_SEATBELT_SENSOR "
     "ELEMENT_SEATBELT_SLIPRING",
     "", "", P::SHELL, belt_device},
    {"ELEMENT_SEATBELT", "", "", P::SHELL, element_seatbelt},
    {"SENSOR_CONTROL", "TITLE", "", P::SHELL, sensor_control},
    {"ELEMENT_MASS", "", "PART MATRIX", P::SCENE, element_mass},
    {"ELEMENT_MASS_NODE_SET", "", "", P::SCENE, element_mass_node_set},
    {"ELEMENT_INERTIA", "", "OFFSET", P::SCENE, element_inertia},
    {"ELEMENT_SHELL", "THICKNESS BETA", "MCID OFFSET DOF COMPOSITE", P::SHELL, element_shell},
    {"ELEMENT_SOLID", "", "ORTHO DOF TET4TOTET10 H20 H27 H64", P::SHELL, element_solid},

    {"SET_NODE", LISTS, LISTS_LATER, P::SET, set_node},
    {"SET_PART", LISTS, LISTS_LATER, P::SET, set_part},
    {"SET_SHELL", LISTS, LISTS_LATER, P::SET, set_shell},
    {"SET_SEGMENT", "COLLECT TITLE", "", P::SET, set_segment},
    {"SET_NODE_ADD", "COLLECT TITLE", "ADVANCED", P::SUM_OF_SETS, set_node_add},
    {"SET_PART_ADD", "COLLECT TITLE", "", P::SUM_OF_SETS, set_part_add},
    {"SET_SHELL_ADD", "COLLECT TITLE", "", P::SUM_OF_SETS, set_shell_add},
    {"SET_SEGMENT_ADD", "COLLECT TITLE", "", P::SUM_OF_SETS, set_segment_add},
    {"SET_NODE_INTERSECT", "TITLE", "", P::SUM_OF_SETS, set_node_intersect},
    {"SET_SHELL_INTERSECT", "TITLE", "", P::SUM_OF_SETS, set_shell_intersect},
    {"SET_SEGMENT_INTERSECT", "TITLE", "", P::SUM_OF_SETS, set_segment_intersect},
    {"SET_NODE_GENERAL", "COLLECT TITLE", "", P::SUM_OF_SETS, set_node_general},
    {"SET_PART_GENERAL", "COLLECT TITLE", "", P::SUM_OF_SETS, set_part_general},
    {"SET_SHELL_GENERAL", "COLLECT TITLE", "", P::SUM_OF_SETS, set_shell_general},
    {"SET_SEGMENT_GENERAL", "COLLECT TITLE", "", P::SUM_OF_SETS, set_segment_general},

    {"DEFINE_ELEMENT_DEATH_SHELL DEFINE_ELEMENT_DEATH_SHELL_SET", "TITLE", "", P::SCENE,
     element_death},
    {"INITIAL_STRESS_SHELL INITIAL_STRESS_SHELL_SET", "", "", P::SCENE, initial_stress},

    {"AIRBAG_PARTICLE", "MPP DECOMPOSITION MOLEFRACTION INFLATION JET SEGMENT TIME ID TITLE", "",
     P::SCENE, airbag_particle},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL", "ID", "", P::SCENE, airbag_simple},
    {"AIRBAG_WANG_NEFSKE", "ID MULTIPLE JETTING", "POP", P::SCENE, airbag_wang_nefske},
    {"AIRBAG_ADIABATIC_GAS_MODEL", "ID", "", P::SCENE, airbag_adiabatic},
    {"AIRBAG_HYBRID", "ID JETTING CM", "CHEMKIN", P::SCENE, airbag_hybrid},
    {"AIRBAG_SIMPLE_PRESSURE_VOLUME", "ID", "", P::SCENE, airbag_pressure_volume},
    {"AIRBAG_INTERACTION", "", "", P::RELATION, airbag_interaction},
    {"AIRBAG_LOAD_CURVE", "ID", "", P::SCENE, airbag_load_curve},
    {"DEFINE_CPM_VENT", "TITLE", "", P::PLACE, define_cpm_vent},
    {"DEFINE_CPM_GAS_PROPERTIES", "TITLE", "", P::PLACE, define_cpm_gas},
    {"DEFINE_CPM_NPDATA", "TITLE", "", P::PLACE, define_cpm_npdata},
    {"DEFINE_CPM_CHAMBER", "TITLE", "", P::PLACE, define_cpm_chamber},
    {"AIRBAG_REFERENCE_GEOMETRY", "BIRTH RDT ID", "", P::SCENE, airbag_reference_geometry},
    {"AIRBAG_SHELL_REFERENCE_GEOMETRY", "RDT ID", "", P::SCENE, airbag_shell_reference_geometry},
    {"BOUNDARY_SPC_NODE", "ID BIRTH DEATH", "", P::SCENE, boundary_spc_node},
    {"BOUNDARY_SPC_SET", "ID BIRTH DEATH", "", P::SCENE, boundary_spc_set},
    {"BOUNDARY_PRESCRIBED_MOTION_NODE", "ID", "", P::SCENE, motion_node},
    {"BOUNDARY_PRESCRIBED_MOTION_SET", "ID", "BOX SEGMENT LINE", P::SCENE, motion_set},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", "ID", "LOCAL", P::SCENE, motion_rigid},
    {"CONSTRAINED_RIGID_BODIES", "", "SET", P::SHELL, constrained_rigid_bodies},
    {"CONSTRAINED_EXTRA_NODES_NODE", "", "", P::SCENE, extra_nodes_node},
    {"CONSTRAINED_EXTRA_NODES_SET", "", "", P::SCENE, extra_nodes_set},
    {"CONSTRAINED_NODAL_RIGID_BODY", "SPC INERTIA TITLE", "OVERRIDE", P::PLACE, nodal_rigid_body},
    {"CONSTRAINED_SPOTWELD", "ID", "FILTERED", P::PLACE, spotweld},
    {"CONSTRAINED_ADAPTIVITY", "", "", P::SCENE, constrained_adaptivity},
    {"CONSTRAINED_TIED_NODES", "FAILURE", "", P::RELATION, tied_nodes},
    {"CONSTRAINED_JOINT_SPHERICAL", "ID", "LOCAL FAILURE", P::RELATION, joint_spherical},
    {"CONSTRAINED_JOINT_REVOLUTE", "ID", "LOCAL FAILURE", P::RELATION, joint_revolute},
    {"CONSTRAINED_JOINT_STIFFNESS_GENERALIZED", "", "", P::RELATION, joint_stiffness_generalized},
    {"INITIAL_VELOCITY", "", "", P::SCENE, initial_velocity},
    {"INITIAL_VELOCITY_NODE", "", "", P::SCENE, initial_velocity_node},
    {"INITIAL_VELOCITY_RIGID_BODY", "", "", P::SCENE, initial_velocity_rigid_body},
    {"INITIAL_VELOCITY_GENERATION", "", "START TIME", P::SCENE, initial_velocity_generation},
    {"LOAD_BODY_PARTS", "", "", P::PLACE, load_body_parts, ONCE},
    {"LOAD_GRAVITY_PART", "", "", P::SCENE, load_gravity_part},
    {"LOAD_GRAVITY_PART_SET", "", "", P::SCENE, load_gravity_part_set},
    {"LOAD_BODY_X", "", "", P::SCENE, load_body_x},
    {"LOAD_BODY_Y", "", "", P::SCENE, load_body_y},
    {"LOAD_BODY_Z", "", "", P::SCENE, load_body_z},
    {"LOAD_SEGMENT", "ID", "NONUNIFORM", P::SCENE, load_segment},
    {"LOAD_SEGMENT_SET", "ID", "NONUNIFORM ANGLE", P::SCENE, load_segment_set},
    {"LOAD_SHELL_ELEMENT", "ID", "", P::SCENE, load_shell_element},
    {"LOAD_SHELL_SET", "ID", "", P::SCENE, load_shell_set},
    {"LOAD_NODE_POINT", "", "", P::SCENE, load_node_point},
    {"LOAD_NODE_SET", "", "", P::SCENE, load_node_set},
    {"LOAD_RIGID_BODY", "", "", P::SCENE, load_rigid_body},
    {"DAMPING_GLOBAL", "", "", P::SCENE, damping_global, ONCE},
    {"DAMPING_FREQUENCY_RANGE", "DEFORM", "", P::SCENE, damping_frequency_range},
    {"DAMPING_PART_MASS", "SET", "", P::SCENE, damping_part_mass},
    {"DAMPING_PART_STIFFNESS", "SET", "", P::SCENE, damping_part_stiffness},
    {"CONTACT_AIRBAG_SINGLE_SURFACE CONTACT_AUTOMATIC_SINGLE_SURFACE", CONTACTS, CONTACTS_LATER,
     P::SCENE, contact_single_surface},
    {"CONTACT_SINGLE_SURFACE CONTACT_AUTOMATIC_GENERAL CONTACT_ERODING_SINGLE_SURFACE", CONTACTS,
     CONTACTS_LATER, P::SCENE, contact_single_surface},
    {"CONTACT_TIED_NODES_TO_SURFACE CONTACT_TIED_SURFACE_TO_SURFACE "
     "CONTACT_TIED_SHELL_EDGE_TO_SURFACE",
     "ID TITLE MPP OFFSET BEAM CONSTRAINED", "FAILURE", P::PLACE, contact_tied},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE CONTACT_SURFACE_TO_SURFACE "
     "CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE CONTACT_ONE_WAY_SURFACE_TO_SURFACE "
     "CONTACT_FORMING_ONE_WAY_SURFACE_TO_SURFACE CONTACT_FORMING_SURFACE_TO_SURFACE "
     "CONTACT_ERODING_SURFACE_TO_SURFACE CONTACT_RIGID_BODY_ONE_WAY_TO_RIGID_BODY "
     "CONTACT_RIGID_BODY_TWO_WAY_TO_RIGID_BODY",
     CONTACTS, CONTACTS_LATER, P::SCENE, contact_surface_to_surface},
    {"CONTACT_AUTOMATIC_NODES_TO_SURFACE CONTACT_NODES_TO_SURFACE "
     "CONTACT_FORMING_NODES_TO_SURFACE CONTACT_ERODING_NODES_TO_SURFACE "
     "CONTACT_RIGID_NODES_TO_RIGID_BODY",
     CONTACTS, CONTACTS_LATER, P::SCENE, contact_nodes_to_surface},
    {"CONTACT_AUTOMATIC_BEAMS_TO_SURFACE", "ID TITLE MPP", "", P::SCENE, contact_beams},
    {"RIGIDWALL_PLANAR", "FINITE MOVING FORCES DISPLAY ID TITLE", "ORTHO", P::SCENE,
     rigidwall_planar},
    {"RIGIDWALL_GEOMETRIC_FLAT", SHAPED, SHAPED_LATER, P::SCENE, rigidwall_flat},
    {"RIGIDWALL_GEOMETRIC_SPHERE", SHAPED, SHAPED_LATER, P::SCENE, rigidwall_sphere},
    {"RIGIDWALL_GEOMETRIC_CYLINDER", SHAPED, SHAPED_LATER, P::SCENE, rigidwall_cylinder},
    {"RIGIDWALL_GEOMETRIC_PRISM", SHAPED, SHAPED_LATER, P::SCENE, rigidwall_prism},
};

/// Materials of which only elements would need more than their numbers.
const Keyword OTHER_MATERIAL = {"MAT", "TITLE", "", P::MATERIAL, mat_other};

/// The suffixes after `base` when all of them are in `allowed`; none otherwise.
std::optional<std::vector<std::string_view>> suffixes(std::string_view keyword,
                                                      std::string_view base,
                                                      std::string_view allowed) {
    std::vector<std::string_view> found;
    std::string_view rest = keyword.substr(base.size());
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('_', 1), rest.size());
        const std::string_view word = rest.substr(1, end - 1);
        bool is_known = false;
        for_each_word(allowed, [&](std::string_view option) { is_known |= option == word; });
        if (!is_known) return {};
        found.push_back(word);
        rest.remove_prefix(end);
    }
    return found;
}

bool starts_with_word(std::string_view keyword, std::string_view base) {
    return keyword.starts_with(base) &&
           (keyword.size() == base.size() || keyword[base.size()] == '_');
}

/// The longest name of the table that the keyword begins with.
std::pair<const Keyword*, std::string_view> longest_base(std::string_view keyword) {
    std::pair<const Keyword*, std::string_view> best{nullptr, {}};
    for (const Keyword& entry : KEYWORDS)
        for_each_word(entry.names, [&](std::string_view name) {
            if (starts_with_word(keyword, name) && name.size() > best.second.size())
                best = {&entry, name};
        });
    return best;
}

}  // namespace

std::span<const Keyword> all() {
    return KEYWORDS;
}

Match find(std::string_view keyword) {
    const auto [entry, base] = longest_base(keyword);
    if (entry != nullptr) {
        if (auto found = suffixes(keyword, base, entry->options))
            return {entry, std::move(*found), base, false, {}};
        const std::string all = fmt::format("{} {}", entry->options, entry->later);
        if (suffixes(keyword, base, all))
            return {nullptr,
                    {},
                    {},
                    false,
                    fmt::format("is not acted on yet, expected *{}{}{}", base,
                                entry->options.empty()
                                    ? ""
                                    : fmt::format(" with no suffix but {}", entry->options),
                                reason(base, keyword))};
    }
    if (begins_with_any(keyword, harmless_beginnings()))
        return {nullptr, {}, {}, true, remark_on(keyword)};
    if (begins_with_any(keyword, unread_definitions())) return {nullptr, {}, {}, false, {}, true};
    if (const std::string_view why = own_refusal(keyword); !why.empty())
        return {nullptr, {}, {}, false, std::string(why)};
    if (const std::string meant = did_you_mean(keyword); !meant.empty())
        return {nullptr, {}, {}, false, fmt::format("is not supported, did you mean *{}?", meant)};
    if (keyword.starts_with("MAT_") && !keyword.starts_with("MAT_ADD_"))
        return {&OTHER_MATERIAL,
                keyword.ends_with("_TITLE") ? std::vector<std::string_view>{"TITLE"}
                                            : std::vector<std::string_view>{},
                "MAT",
                false,
                {}};
    return {nullptr, {}, {}, false, refusal(keyword)};
}

}  // namespace corpuscle::io::keywords
