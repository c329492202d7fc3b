// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// One reader a keyword, and the table that finds it.
namespace corpuscle::io::keywords {

/// A value, or below 0 the id of a curve (mat_fabric.cpp).
void value_or_curve(Card& c, const char* name, const Registry& curves, double& value, Index& curve);

/// What a keyword refers to is read before it, wherever it stands in the deck.
enum class Phase {
    NODE,
    TRANSFORMATION,  ///< then files are where they belong
    GROUND,
    AXES,
    MATERIAL,
    PART,
    STIFFENED,  ///< parts that are rigid though their material is not
    SHELL,
    SET,
    SUM_OF_SETS,
    PLACE,
    SCENE,
    RELATION
};

using Reader = void (*)(Cards&, Draft&);

struct Keyword {
    std::string_view names;    ///< the name and its aliases, blanks between
    std::string_view options;  ///< suffixes that it knows, in any order and number
    std::string_view later;    ///< suffixes that LS-DYNA has and nothing acts on yet
    Phase phase = Phase::GROUND;
    Reader read = nullptr;
    bool holds_once = false;  ///< of several in a deck the last one holds
};

/// What the deck's keyword is.
struct Match {
    const Keyword* keyword = nullptr;        ///< nullptr: not to be read
    std::vector<std::string_view> suffixes;  ///< of the matching options
    std::string_view name;                   ///< of its names the one that matches
    bool is_harmless = false;                ///< not read, and cannot change the answer
    std::string remark;                      ///< not read, and this is to be said
    bool is_definition = false;              ///< not read, and a fault of what refers to it
};
Match find(std::string_view keyword);

/// All keywords that are read.
std::span<const Keyword> all();
/// Beginnings of those that are not read and cannot change the answer, blanks between.
std::string_view harmless_beginnings();
/// Beginnings of definitions that are not read and say nothing unless something refers to them.
std::string_view unread_definitions();

// nodes_elements.cpp
void node(Cards&, Draft&);
void element_shell(Cards&, Draft&);
// parts_sections.cpp
void part(Cards&, Draft&);
void section_shell(Cards&, Draft&);
void section_other(Cards&, Draft&);
// rigid_parts.cpp
void section_solid(Cards&, Draft&);
void element_solid(Cards&, Draft&);
void extra_nodes_node(Cards&, Draft&);
void extra_nodes_set(Cards&, Draft&);
// rigid_merges.cpp
void constrained_rigid_bodies(Cards&, Draft&);
void deformable_to_rigid(Cards&, Draft&);  // deformable_to_rigid.cpp
void part_composite(Cards&, Draft&);       // part_composite.cpp
// element_state.cpp
void element_death(Cards&, Draft&);
void initial_stress(Cards&, Draft&);
// materials.cpp, mat_fabric.cpp
void mat_elastic(Cards&, Draft&);
void mat_null(Cards&, Draft&);
void mat_rigid(Cards&, Draft&);
void mat_fabric(Cards&, Draft&);
void mat_other(Cards&, Draft&);
void mat_add_erosion(Cards&, Draft&);
void mat_add_leakage(Cards&, Draft&);  // leakage.cpp
// curves.cpp
void define_curve(Cards&, Draft&);
void define_curve_smooth(Cards&, Draft&);
void define_curve_function(Cards&, Draft&);
void define_box(Cards&, Draft&);
void define_vector(Cards&, Draft&);
// coordinates.cpp
void define_coordinate_system(Cards&, Draft&);
void define_coordinate_vector(Cards&, Draft&);
void define_coordinate_nodes(Cards&, Draft&);
// transformation.cpp
void define_transformation(Cards&, Draft&);
void node_transform(Cards&, Draft&);
// sets.cpp, sets_general.cpp
void set_node(Cards&, Draft&);
void set_part(Cards&, Draft&);
void set_shell(Cards&, Draft&);
void set_segment(Cards&, Draft&);
void set_node_add(Cards&, Draft&);
void set_part_add(Cards&, Draft&);
void set_shell_add(Cards&, Draft&);
void set_segment_add(Cards&, Draft&);
void set_node_intersect(Cards&, Draft&);
void set_shell_intersect(Cards&, Draft&);
void set_segment_intersect(Cards&, Draft&);
void set_node_general(Cards&, Draft&);
void set_part_general(Cards&, Draft&);
void set_shell_general(Cards&, Draft&);
void set_segment_general(Cards&, Draft&);
// airbag_uniform.cpp
void airbag_simple(Cards&, Draft&);
void airbag_wang_nefske(Cards&, Draft&);
void airbag_adiabatic(Cards&, Draft&);
void airbag_hybrid(Cards&, Draft&);
void airbag_load_curve(Cards&, Draft&);
void airbag_pressure_volume(Cards&, Draft&);
void airbag_interaction(Cards&, Draft&);
// airbag_particle.cpp, airbag_vents.cpp, reference_geometry.cpp
void airbag_particle(Cards&, Draft&);
void note_bags(Draft&);  ///< dialect and collision model of bags of particles, once they have ids
void define_cpm_vent(Cards&, Draft&);
void define_cpm_npdata(Cards&, Draft&);
void define_cpm_gas(Cards&, Draft&);      // cpm_gas.cpp
void define_cpm_chamber(Cards&, Draft&);  // airbag_chambers.cpp
void airbag_reference_geometry(Cards&, Draft&);
void airbag_shell_reference_geometry(Cards&, Draft&);
// boundary.cpp, motion.cpp, initial_velocity.cpp
void boundary_spc_node(Cards&, Draft&);
void boundary_spc_set(Cards&, Draft&);
void motion_node(Cards&, Draft&);
void motion_set(Cards&, Draft&);
void motion_rigid(Cards&, Draft&);
void initial_velocity(Cards&, Draft&);
void initial_velocity_node(Cards&, Draft&);
void initial_velocity_rigid_body(Cards&, Draft&);
void initial_velocity_generation(Cards&, Draft&);
// loads.cpp
void load_body_x(Cards&, Draft&);
void load_body_y(Cards&, Draft&);
void load_body_z(Cards&, Draft&);
void load_body_parts(Cards&, Draft&);
void load_gravity_part(Cards&, Draft&);
void load_gravity_part_set(Cards&, Draft&);
void load_segment(Cards&, Draft&);
void load_segment_set(Cards&, Draft&);
void load_shell_element(Cards&, Draft&);
void load_shell_set(Cards&, Draft&);
void damping_global(Cards&, Draft&);
void damping_part_mass(Cards&, Draft&);
void damping_part_stiffness(Cards&, Draft&);
void damping_frequency_range(Cards&, Draft&);
void load_node_point(Cards&, Draft&);
void load_node_set(Cards&, Draft&);
void load_rigid_body(Cards&, Draft&);  // loads_rigid.cpp
void element_mass(Cards&, Draft&);
void element_inertia(Cards&, Draft&);  // nodes_elements.cpp
void element_mass_node_set(Cards&, Draft&);
void control_dynamic_relaxation(Cards&, Draft&);
void termination(Cards&, Draft&);
// links.cpp, joined_nodes.cpp
void element_beam(Cards&, Draft&);
void element_discrete(Cards&, Draft&);
void element_seatbelt(Cards&, Draft&);
void accelerometer(Cards&, Draft&);
void sensor_control(Cards&, Draft&);
void belt_device(Cards&, Draft&);
void nodal_rigid_body(Cards&, Draft&);
void spotweld(Cards&, Draft&);
void constrained_adaptivity(Cards&, Draft&);
// joints.cpp
void joint_spherical(Cards&, Draft&);
void joint_revolute(Cards&, Draft&);
void joint_stiffness_generalized(Cards&, Draft&);  // joint_stiffness.cpp
void tied_nodes(Cards&, Draft&);
// contact.cpp, walls.cpp, walls_geometric.cpp
void contact_single_surface(Cards&, Draft&);
void contact_surface_to_surface(Cards&, Draft&);
void contact_nodes_to_surface(Cards&, Draft&);
void contact_beams(Cards&, Draft&);
void contact_tied(Cards&, Draft&);  // contact_tied.cpp
void rigidwall_planar(Cards&, Draft&);
void rigidwall_flat(Cards&, Draft&);
void rigidwall_sphere(Cards&, Draft&);
void rigidwall_cylinder(Cards&, Draft&);
void rigidwall_prism(Cards&, Draft&);
// control_output.cpp
void title(Cards&, Draft&);
void control_termination(Cards&, Draft&);
void control_timestep(Cards&, Draft&);
void control_contact(Cards&, Draft&);
void control_cpm(Cards&, Draft&);
void database_cpm_sensor(Cards&, Draft&);  // database_sensor.cpp
void database_d3plot(Cards&, Draft&);
void database_d3dump(Cards&, Draft&);
void database_abstat(Cards&, Draft&);
void database_abstat_cpm(Cards&, Draft&);
void database_matsum(Cards&, Draft&);
void database_glstat(Cards&, Draft&);
void database_rcforc(Cards&, Draft&);
void database_rwforc(Cards&, Draft&);
void database_rbdout(Cards&, Draft&);
void database_nodout(Cards&, Draft&);
void database_history_node(Cards&, Draft&);
void database_history_node_set(Cards&, Draft&);

}  // namespace corpuscle::io::keywords
