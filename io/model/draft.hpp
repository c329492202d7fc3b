// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/deck/included/file_place.hpp"
#include "io/deck/registry.hpp"
#include "io/model/transformation.hpp"
#include "solver/model.hpp"

namespace corpuscle::io {

struct Inclusion;

struct Section {
    double thickness = NaN;
    int element_form = 0;
    bool is_solid = false;      ///< *SECTION_SOLID
    bool is_tube = false;       ///< *SECTION_BEAM, CST = 1
    bool is_composite = false;  ///< of *PART_COMPOSITE itself
    double area = NaN;          ///< of *SECTION_BEAM                                      [m^2]
    std::string other;          ///< the keyword of one that is no shell's and no solid's
    Place place;                ///< of its card
};

/// A keyword that is in the deck and that nothing acts on, as long as no element needs it.
struct Unread {
    std::string keyword;
    Place place;
    double density = NaN;  ///< of a material                                       [kg/m^3]
};

/// *ELEMENT_BEAM, _DISCRETE, _SEATBELT: joins two nodes.
struct Link {
    std::string keyword;
    Place place;
    Index part = -1;
    std::array<Index, 2> nodes{-1, -1};
};

/// *ELEMENT_SOLID; fewer than eight corners repeat some.
struct Solid {
    int id = 0;
    Index part = -1;
    std::array<Index, 8> nodes{};
};

/// *DEFINE_COORDINATE_...
struct LocalAxes {
    Mat3 axes = Mat3::Identity();            ///< columns: local x, y, z
    std::array<Index, 3> nodes{-1, -1, -1};  ///< _NODES: rows; they give the axes
    bool moves = false;                      ///< FLAG = 1: the axes go with the nodes
};

/// *DEFINE_BOX, along the axes of its file.
struct SetBox {
    Eigen::AlignedBox3d box;
    FilePlace file;

    [[nodiscard]] bool contains(const Vec3& x) const { return box.contains(file.written(x)); }
};

/// A thing that a keyword has made, whose number the deck may leave open.
struct Numbered {
    enum class Kind : std::uint8_t { PARTICLE_BAG, UNIFORM_BAG, CONTACT, WALL };
    Kind kind = Kind::PARTICLE_BAG;
    std::size_t row = 0;  ///< in the model's list of its kind
    Place place;          ///< of the keyword
    std::string keyword;  ///< without its star
};

/// Which meaning of the cards the deck wants: today's, or that of the 2007 course notes.
enum class Dialect { TODAY, NOTES_2007 };

/// By which keywords refer to each other, and which offset of *INCLUDE_TRANSFORM shifts their ids.
struct DraftNames {
    Registry nodes{"*NODE", IdKind::NODE};
    Registry shells{"*ELEMENT_SHELL", IdKind::ELEMENT}, solids{"*ELEMENT_SOLID", IdKind::ELEMENT};
    Registry parts{"*PART", IdKind::PART}, materials{"*MAT", IdKind::MATERIAL},
        sections{"*SECTION_SHELL", IdKind::OTHER};
    Registry node_sets{"*SET_NODE", IdKind::SET}, part_sets{"*SET_PART", IdKind::SET},
        shell_sets{"*SET_SHELL", IdKind::SET}, segment_sets{"*SET_SEGMENT", IdKind::SET},
        solid_sets{"*SET_SOLID", IdKind::SET};
    Registry curves{"*DEFINE_CURVE", IdKind::FUNCTION};
    Registry vectors{"*DEFINE_VECTOR", IdKind::DEFINE}, boxes{"*DEFINE_BOX", IdKind::DEFINE},
        coordinates{"*DEFINE_COORDINATE", IdKind::DEFINE},
        transformations{"*DEFINE_TRANSFORMATION", IdKind::DEFINE},
        cpm_vents{"*DEFINE_CPM_VENT", IdKind::DEFINE},
        cpm_npdata{"*DEFINE_CPM_NPDATA", IdKind::DEFINE},
        cpm_chambers{"*DEFINE_CPM_CHAMBER", IdKind::DEFINE},
        cpm_gases{"*DEFINE_CPM_GAS_PROPERTIES", IdKind::DEFINE};
    std::vector<Numbered> numbered;  ///< in the order of the deck; id 0: open until number_things()

    /// Ids that nothing defines are no further faults: some text of the deck could not be read.
    void spoil_rest() {
        for (Registry* kind :
             {&nodes,           &shells,    &solids,     &parts,        &materials,
              &sections,        &node_sets, &part_sets,  &shell_sets,   &segment_sets,
              &solid_sets,      &curves,    &vectors,    &boxes,        &coordinates,
              &transformations, &cpm_vents, &cpm_npdata, &cpm_chambers, &cpm_gases})
            kind->spoil_rest();
    }
};

/// What the run asks of the whole deck.
struct DraftOptions {
    Dialect dialect = Dialect::TODAY;
    double until = 0.0;          ///< as DeckOptions                                  [s]
    bool is_incomplete = false;  ///< some text of the deck could not be read
};

/// Members of sets, in the order of their names.
struct DraftSets {
    std::vector<std::vector<Index>> node_set;                    ///< node rows
    std::vector<std::vector<Index>> part_set;                    ///< part rows
    std::vector<std::vector<Index>> shell_set;                   ///< shell rows
    std::vector<std::vector<std::array<Index, 4>>> segment_set;  ///< node rows
};

/// What a part exchanges with the gas; its parts are known later.
struct PartExchange {
    gas::HeatCard heat;
    gas::FrictionCard friction;
    bool is_rough = false;  ///< friction counts
};

/// *DEFINE_CPM_GAS_PROPERTIES
struct CpmGas {
    double molar_mass = NaN;     ///< [kg/mol]
    std::array<double, 5> cp{};  ///< of T^0 to T^4, by mole                        [J/(mol K)]
    std::string refused;         ///< fields that are set and that nothing acts on
};

/// Of airbags, until their keywords are all read.
struct DraftAirbags {
    std::optional<gas::CollisionModel> collision;  ///< of all bags; none: the default
    double mean_free_path = NaN;                   ///< of that model; NaN: its default      [m]
    double force_decay = 1.0;  ///< SFFDC of *CONTROL_CPM, for bags that have none of their own  [-]
    std::vector<CpmGas> cpm_gas;                             ///< of *DEFINE_CPM_GAS_PROPERTIES
    std::vector<gas::VentCard> cpm_vent;                     ///< without parts
    std::vector<PartExchange> cpm_exchange;                  ///< of *DEFINE_CPM_NPDATA
    std::vector<std::vector<gas::ChamberCard>> cpm_chamber;  ///< of one bag each
};

/// A curve over time that loads or moves something.
struct CurveUse {
    Index curve = -1;
    Place place;                   ///< of the card that names it
    double from = 0.0, to = 1e28;  ///< when it acts                                  [s]
};

/// Where cards stand that say something of what others make, for faults of the whole.
struct DraftUses {
    std::vector<Place> motion_places;  ///< of the cards of Model::motions
    std::vector<CurveUse> curve_uses;
    std::vector<Index> function_curves;                     ///< rows of *DEFINE_CURVE_FUNCTION
    std::map<std::pair<Index, double>, Index> late_curves;  ///< row and delay: row of the later one
    std::vector<std::pair<Index, Place>> body_uses;  ///< rigid parts that loads and springs act on
    Place node_masses_at;                            ///< the first *ELEMENT_MASS or _INERTIA
    std::vector<Place> node_inertias_at;             ///< of Model::node_inertias
};

/// A model under construction: what keywords refer to each other by, and what the model itself does
/// not keep.
struct Draft : DraftNames, DraftOptions, DraftSets, DraftAirbags, DraftUses {
    explicit Draft(Model& under_construction) : model(under_construction) {}

    Model& model;
    std::vector<Section> section;
    std::vector<std::uint8_t> part_has_solids;  ///< by part row
    std::vector<Index> part_section;            ///< by part row; -1: none
    std::vector<Solid> solid;
    std::vector<Link> links;
    std::map<Index, Unread> unread_materials;  ///< by material row
    std::map<Index, Unread> bare_parts;        ///< without section or material, by part row
    std::vector<Index> stiffened_parts;        ///< of solids that deform, taken as rigid
    std::vector<Index> inertia_nodes;          ///< NODEID of *PART_INERTIA, node rows
    std::vector<SetBox> box;
    std::vector<Transformation> transformation;
    /// By *NODE block: its first node row, and the *INCLUDE_TRANSFORM around it or nullptr.
    std::vector<std::pair<Index, const Inclusion*>> node_files;
    std::vector<RigidVelocity> inertia_start;  ///< of *PART_INERTIA, where nothing else says it
    std::vector<Index> rigid_owner;  ///< by node row: rigid part or -1; empty until it is asked for
    std::vector<LocalAxes> coordinate;
    std::vector<std::pair<Index, Index>> local_constraints;  ///< rigid material, its axes: rows
    Points vector;                                           ///< head - tail

    std::vector<std::pair<Index, Place>> added_leaks;  ///< *MAT_ADD_AIRBAG_POROSITY_LEAKAGE
    std::vector<Index> body_load_parts;                ///< *LOAD_BODY_PARTS; none: all
    double rigid_wall_penalty = 0.0;                   ///< RWPNAL of *CONTROL_CONTACT

    int frame_count = 0;  ///< NPLTC of *DATABASE_BINARY_D3PLOT, which needs the end time
};

}  // namespace corpuscle::io
