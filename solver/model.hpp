// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/rigid_walls/wall_card.hpp"
#include "contact/surface/cards.hpp"
#include "fabric/materials/fabric_card.hpp"
#include "fabric/mesh.hpp"
#include "gas/cards/bag.hpp"
#include "gas/cards/uniform_card.hpp"
#include "gas/sensor.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/vec.hpp"
#include "solver/bodies/body_cards.hpp"

namespace corpuscle {

/// *AIRBAG_REFERENCE_GEOMETRY: the stress-free place of some nodes.
struct ReferenceGeometry {
    std::vector<std::pair<Index, Vec3>> nodes;  ///< node row, reference position      [m]
    double birth = 0.0;  ///< BIRTH: counts from then on; RGBRTH > 0 goes before       [s]
};

/// *AIRBAG_SHELL_REFERENCE_GEOMETRY: the stress-free corners of one shell, whatever its nodes' are.
struct ShellReference {
    Index shell = -1;             ///< row among the shells
    std::array<Vec3, 4> corners;  ///< in the order of the shell's nodes                [m]
};

/// Bits 0-2: translation x y z, bits 3-5: rotation (membranes have none).
using DofMask = unsigned;

/// *BOUNDARY_SPC.
struct Support {
    Index node = -1;    ///< row among the nodes
    DofMask fixed = 0;  ///< held for good
};

/// What the curve of a motion gives, VAD.
enum class MotionKind {
    VELOCITY,      ///< 0                                                       [m/s]
    ACCELERATION,  ///< 1                                                     [m/s^2]
    DISPLACEMENT   ///< 2                                                         [m]
};

/// *BOUNDARY_PRESCRIBED_MOTION of nodes or of one rigid part.
struct PrescribedMotion {
    std::vector<Index> nodes;                ///< node rows (empty for a rigid part)
    Index rigid_part = -1;                   ///< part row of a *MAT_RIGID, or -1
    MotionKind kind = MotionKind::VELOCITY;  ///< what the curve gives
    bool rotation = false;                   ///< DOF 5-8: about `axis`, rigid parts only
    Vec3 axis = Vec3::UnitX();               ///< unit direction of the motion
    Index curve = -1;                        ///< row: over time                 [m/s] or as `kind`
    double scale = 1.0;                      ///< SF: factor on the curve                      [-]
    double birth = 0.0,                      ///< acts from then on                            [s]
        death = 1e28;                        ///< no more from then on                         [s]
};

/// *CONSTRAINED_ADAPTIVITY, or a node that hangs on an edge: it moves with the edge's ends,
///
///     x = (1 - w) x_0 + w x_1,
///
/// which bear its mass and the forces on it in the same shares. *CONSTRAINED_TIED_NODES: both ends
/// are one node, where it is.
struct TiedNode {
    Index node = -1;                    ///< row of the node that hangs
    std::array<Index, 2> ends{-1, -1};  ///< rows; may be tied themselves
    double share = 0.5;                 ///< w                                               [-]
};

/// *MAT_ADD_AIRBAG_POROSITY_LEAKAGE: what a material lets through, before what it says itself.
struct AddedLeak {
    Index material = -1;      ///< row among the materials
    fabric::FabricCard says;  ///< its leak_ fields alone
};

/// Shells that a contact means of parts of which it does not mean all; rows.
struct ContactShells {
    std::vector<Index> first;   ///< rows, of SURFA
    std::vector<Index> second;  ///< rows, of SURFB
};

/// *LOAD_BODY_X/Y/Z, *LOAD_GRAVITY_PART: acceleration of the frame; bodies feel its opposite.
struct BodyLoad {
    int axis = 0;              ///< 0 x, 1 y, 2 z
    Index curve = -1;          ///< base acceleration over time; -1: constant `scale`    [m/s^2]
    double scale = 1.0;        ///< SF, ACCEL: factor on the curve
    std::vector<Index> parts;  ///< rows of those that feel it; none: all
};

/// *LOAD_SEGMENT_SET, *LOAD_SHELL_SET: positive pressure presses against the facet's normal.
struct PressureLoad {
    std::vector<std::array<Index, 4>> facets;  ///< node rows; a triangle repeats its 3rd
    Index curve = -1;                          ///< pressure over time; -1: constant `scale`  [Pa]
    double scale = 1.0;                        ///< SF: factor on the curve
    double arrival = 0.0;  ///< AT: acts from then on, the curve begins there      [s]
};

/// *LOAD_NODE_POINT, _SET: a force on each of some nodes, F = SF · curve(t).
struct NodeLoad {
    std::vector<Index> nodes;  ///< node rows
    int axis = 0;              ///< DOF 1 to 3: 0 x, 1 y, 2 z
    Index curve = -1;          ///< force over time                                       [N]
    double scale = 1.0;        ///< SF: factor on the curve                            [-]
};

/// *LOAD_RIGID_BODY: a force at the mass centre of a rigid part's body, or a moment, SF · curve(t)
/// along an axis.
struct RigidLoad {
    Index part = -1;            ///< row of a *MAT_RIGID part; its body bears the load
    bool is_moment = false;     ///< DOF 5 to 8; else a force
    Vec3 axis = Vec3::UnitX();  ///< unit, global, or in the axes of `nodes`
    /// Rows; local x along 1-2, z normal to 1-2-3, as they are at t; -1: none.
    std::array<Index, 3> nodes{-1, -1, -1};
    Index curve = -1;    ///< over time                                       [N] or [N m]
    double scale = 1.0;  ///< SF: factor on the curve                            [-]
};

/// *ELEMENT_MASS: mass that a node has beside that of its shells.
struct NodeMass {
    Index node = -1;    ///< row among the nodes
    double mass = 0.0;  ///< added to that of its shells  [kg]
};

/// *ELEMENT_INERTIA: of a node of a rigid body, beside its mass.
struct NodeInertia {
    Index node = -1;              ///< row among the nodes
    Mat3 inertia = Mat3::Zero();  ///< about the node, global axes                       [kg m^2]
};

/// *DAMPING_PART_MASS: f = -SF · curve(t) m v on the nodes of a part, m being what its shells give
/// them; what tied nodes get of it counts at the nodes that bear their mass, and what nodes get that
/// ride on a body pulls the body there. A rigid part has it by its mass as a whole, translation and
/// spin alike, without the cloth that rides on it; of a merged body, whose parts move as one, by the
/// part's share of their mass.
struct PartDamping {
    Index part = -1;     ///< row of the part that is damped
    Index curve = -1;    ///< over time                                                   [1/s]
    double scale = 1.0;  ///< SF: factor on the curve                            [-]
};

/// Output intervals; NaN: not asked for.                                                       [s]
struct OutputIntervals {
    double frames = NaN;            ///< *DATABASE_BINARY_D3PLOT
    double checkpoint_steps = NaN;  ///< *DATABASE_BINARY_D3DUMP; NaN: by the clock            [-]
    double abstat = NaN,            ///< *DATABASE_ABSTAT: bags  [s]
        glstat = NaN,               ///< *DATABASE_GLSTAT: energies of the scene  [s]
        rcforc = NaN,               ///< *DATABASE_RCFORC: forces of contacts  [s]
        rwforc = NaN,               ///< *DATABASE_RWFORC: forces on rigid walls  [s]
        rbdout = NaN,               ///< *DATABASE_RBDOUT: motion of rigid bodies  [s]
        nodout = NaN;               ///< *DATABASE_NODOUT: motion of `history_nodes`  [s]
    double abstat_cpm = NaN,        ///< *DATABASE_ABSTAT_CPM: bags of particles  [s]
        matsum = NaN,               ///< *DATABASE_MATSUM: energies of parts  [s]
        cpm_sensor = NaN;           ///< *DATABASE_CPM_SENSOR: gas at sensors  [s]
};

/// Nodes, shells, and what they are made of.
struct ModelMesh {
    std::vector<int> node_id;   ///< N, the deck's
    Points x;                   ///< initial (folded) node positions, N × 3        [m]
    std::vector<Shell> shells;  ///< E; nodes and part by row
    std::vector<Part> parts;    ///< material by row
    /// Quads of mirrored files, ascending: they are cut from their second node to their fourth.
    std::vector<Index> mirrored_quads;
    std::vector<fabric::Material> materials;       ///< cards, as the deck has them
    std::vector<ReferenceGeometry> references;     ///< stress-free shapes of nodes
    std::vector<ShellReference> shell_references;  ///< go before `references`
    std::vector<NodeMass> node_masses;             ///< beside those of shells
    std::vector<NodeInertia> node_inertias;        ///< of nodes of rigid bodies
};

/// Rigid bodies, and what joins them and nodes.
struct ModelBodies {
    std::vector<RigidVelocity> rigid_velocity;      ///< the last one of a part counts
    std::vector<RigidInertia> rigid_inertia;        ///< at most one a part
    std::vector<RigidExtraNode> rigid_extra_nodes;  ///< that ride on parts
    std::vector<RigidMerge> rigid_merges;  ///< a part is led by one other at most, none by itself
    std::vector<RigidJoint> rigid_joints;  ///< between two bodies
    std::vector<JointStiffness> joint_stiffnesses;  ///< likewise
    std::vector<TiedNode> tied_nodes;               ///< a node at most once
};

/// What holds, moves and loads nodes.
struct ModelLoads {
    Points velocity;                ///< initial node velocities, N × 3                [m/s]
    std::vector<Support> supports;  ///< held nodes
    std::vector<PrescribedMotion> motions;     ///< driven nodes and bodies
    std::vector<BodyLoad> body_loads;          ///< gravity and other accelerations of the frame
    std::vector<PressureLoad> pressure_loads;  ///< on facets
    std::vector<NodeLoad> node_loads;          ///< on nodes
    std::vector<RigidLoad> rigid_loads;        ///< on rigid bodies
    std::vector<PartDamping> part_dampings;    ///< by part
    double mass_damping = 0.0;      ///< *DAMPING_GLOBAL VALDMP                        [1/s]
    Index mass_damping_curve = -1;  ///< *DAMPING_GLOBAL LCID                          [1/s]
};

/// Bags, and what closes them.
struct ModelAirbags {
    std::vector<AddedLeak> added_leaks;             ///< by material
    std::vector<gas::BagCard> bags;                 ///< *AIRBAG_PARTICLE
    std::vector<gas::UniformBagCard> uniform_bags;  ///< that never hold particles
    std::vector<gas::ExchangeCard> exchanges;       ///< between two of these
    std::vector<gas::SensorCard> sensors;           ///< *DATABASE_CPM_SENSOR, one a segment

    // Closing of bags (scene/closing.hpp)
    bool closes_bags = true;  ///< false: a bag with a hole is refused as it is
    double lid_share = 0.05;  ///< of a bag's area, up to which a hole gets a lid          [-]
    std::vector<std::string> mendings;  ///< what was done to close bags
};

/// Pairs of surfaces in contact.
struct ModelContacts {
    std::vector<contact::ContactCard> contacts;  ///< the first that holds for a pair counts
    std::vector<ContactShells> contact_shells;  ///< by contact; none: all contacts mean whole parts
    std::vector<contact::WallCard> walls;       ///< *RIGIDWALL, in the deck's order
};

/// Control and output.
struct ModelControl {
    double end_time = NaN;          ///< *CONTROL_TERMINATION ENDTIM                   [s]
    double step_factor = 0.9;       ///< TSSFAC: share of the shells' stable step       [-]
    double step_start = 0.0;        ///< DTINIT, 0: stable step                        [s]
    double step_mass_scaled = 0.0;  ///< DT2MS < 0: mass is added where the step would be below
                                    ///< |DT2MS|; > 0: everywhere to that step; 0: none         [s]
    OutputIntervals output;         ///< how often which file
    std::vector<Index> history_nodes;  ///< node rows of *DATABASE_HISTORY_NODE
};

/// A scene: pure data, in the deck's units. Built by io from a deck, or by hand in a test.
struct Model : ModelMesh, ModelBodies, ModelLoads, ModelAirbags, ModelContacts, ModelControl {
    std::string title;                  ///< *TITLE
    std::string deck;                   ///< file name, for messages and results
    std::string unit_system;            ///< "kg-mm-ms-K", "SI", "ton-mm-s-K", or "consistent"
    std::vector<Curve> curves;          ///< that cards name by row
    std::vector<std::string> notes;     ///< what was decided where a deck may be read in two ways
    std::vector<std::string> warnings;  ///< each with file and line, for the user
    std::uint64_t fingerprint = 0;      ///< of all that the deck says of the scene; 0: no deck
};

/// What the material of a part says of leaking, or nullptr: it does not.
[[nodiscard]] const fabric::FabricCard* leakage_of(const Model& model, Index part);

}  // namespace corpuscle
