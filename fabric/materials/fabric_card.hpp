// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "fabric/materials/own_law.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// Stress-strain curves of *MAT_FABRIC, FORM 4 (second Piola-Kirchhoff stress over Green strain)
/// and 14 (engineering stress over engineering strain): rows among the curves, -1 for none.
struct FabricCurves {
    std::array<Index, 3> load{-1, -1, -1};    ///< LCA, LCB, LCAB; none: EA, EB, GAB
    std::array<Index, 3> unload{-1, -1, -1};  ///< LCUA, LCUB, LCUAB; none: as loaded
    double reload = 0.0;  ///< RL: 0 reloads along the unloading curve, 1 along its chord    [-]

    /// Whether any curve is given, of loading or unloading.
    [[nodiscard]] bool any() const {
        for (const auto& rows : {load, unload})
            for (const Index row : rows)
                if (row >= 0) return true;
        return false;
    }
};

/// TSRFAC: strains in tension that the reference geometry brings at the start bear no stress; they
/// come back by a share of what is left in every step, or as a curve of time says.
struct StrainRestoration {
    double share = 0.0;       ///< 0 < TSRFAC < 1: that comes back in every step              [-]
    Index share_curve = -1;   ///< TSRFAC < 0: the same over time
    Index course_curve = -1;  ///< TSRFAC >= 1: what has come back so far over time, 0 to 1

    /// Whether the card asks for it.
    [[nodiscard]] bool any() const { return share > 0.0 || share_curve >= 0 || course_curve >= 0; }
};

/// A second layer without direction.
struct FabricLiner {
    double liner_E = 0.0;      ///< EL: Young's modulus                                       [Pa]
    double liner_nu = 0.0;     ///< PRL: Poisson's ratio                                      [-]
    double liner_ratio = 0.0;  ///< LRATIO: liner thickness / fabric thickness            [-]
    bool liner_waits = false;  ///< LNRC = 1: no compression until it has once been taut
};

/// Layers that do not stretch with the cloth's law, one on each side.
struct FabricCoat {
    double coat_E = 0.0;  ///< ECOAT: Young's modulus                                    [Pa]
    double coat_thickness = 0.0;  ///< |TCOAT|, of the coat on each side                     [m]
    bool coat_stretches = true;   ///< TCOAT > 0: it adds to the membrane; else it only bends

    /// Whether it has both, modulus and thickness; else the coat is left out.
    [[nodiscard]] bool has_coat() const { return coat_E > 0.0 && coat_thickness > 0.0; }
};

/// How the cloth leaks.
struct FabricLeak {
    double leak_area = 0.0;      ///< FLC > 0: share of the area that leaks                   [-]
    double leak_velocity = 0.0;  ///< FAC > 0, unit by FVOPT                  [m/s], [-] or [s/m]
    Index leak_area_curve = -1;  ///< FLC < 0: row in Model::curves, over time
    Index leak_velocity_curve = -1;  ///< FAC < 0: row in Model::curves, over absolute pressure
    int leak_option = 0;             ///< FVOPT: what FAC is, see gas::LeakLaw
    double leak_when_blocked = 0.0;  ///< ELA: share of the leak that blocked fabric keeps   [-]
    bool leak_by_component = false;  ///< FAC's curve is over a component's pressure, not the bag's
    bool leak_from_reference = false;  ///< A0REF = 1: the reference shape's area counts
    std::optional<std::array<double, 4>> leak_growth;  ///< X0-X3, instead of FLC and FAC    [-]

    /// Whether the card gives a leak: X0-X3, or an area and a velocity.
    [[nodiscard]] bool leaks() const {
        const bool has_area = leak_area != 0.0 || leak_area_curve >= 0;
        const bool has_velocity = leak_velocity != 0.0 || leak_velocity_curve >= 0;
        return leak_growth.has_value() || (has_area && has_velocity);
    }
};

/// Orthotropic woven fabric, *MAT_FABRIC (034): the card as the user means it, defaults resolved.
struct FabricCard : FabricLiner, FabricCoat, FabricLeak {
    double density = NaN;  ///< RO                                                    [kg/m^3]
    double E_warp = NaN;   ///< EA: modulus along a, the warp                         [Pa]
    double E_weft = NaN;   ///< EB; the reader sets EB = EA, GAB = EA/2(1+PRBA) when EB = 0 [Pa]
    double nu_ba = 0.0;    ///< PRBA: strain along a from stress along b; nu_ab = nu_ba·EA/EB [-]
    double G = NaN;        ///< GAB: shear modulus                                    [Pa]
    bool no_compression = false;  ///< CSE = 1: the smaller principal stress is never negative
    double damping = 0.0;         ///< DAMP: share of critical, on the strain rate           [-]
    int axes = 0;                 ///< AOPT: 0 nodes 1-2 (+ BETA), 2 vector A, 3 V × normal
    Vec3 a = Vec3::UnitX();       ///< A1-A3, for AOPT 2
    Vec3 v = Vec3::UnitZ();       ///< V1-V3, for AOPT 3
    double beta = 0.0;            ///< BETA, turns the axes about the normal                 [rad]
    int form = 0;  ///< FORM: 14 has `curves` of engineering strain, any other of Green strain
    double reference_birth = 0.0;   ///< RGBRTH > 0: the reference shape counts from then on   [s]
    StrainRestoration restoration;  ///< TSRFAC: of strains at the start
    FabricCurves curves;            ///< instead of EA, EB, PRBA, GAB
};

/// Isotropic linear elastic membrane, *MAT_ELASTIC (001).
struct ElasticCard {
    double density = NaN;  ///< RO [kg/m^3]
    double E = NaN;        ///< E: Young's modulus  [Pa]
    double nu = 0.0;       ///< PR: Poisson's ratio  [-]
};

/// Mass without stiffness, *MAT_NULL (009).
struct NullCard {
    double density = NaN;  ///< RO [kg/m^3]
};

/// Undeformable, *MAT_RIGID (020).
struct RigidCard {
    double density = NaN;      ///< RO [kg/m^3]
    double E = NaN;            ///< E, for contact stiffness only [Pa]
    double nu = 0.0;           ///< PR: Poisson's ratio [-]
    unsigned fixed_moves = 0;  ///< CON1 (CMO = 1), CON2 (-1): bit 0 x, 1 y, 2 z of the centre held
    unsigned fixed_turns = 0;  ///< CON2: bit 0 x, 1 y, 2 z rotation held
    Mat3 axes = Mat3::Identity();  ///< columns: those x, y, z; of CMO = -1 the system CON1, at rest
};

/// The card of a material, by its keyword; OwnCard: a law that a program brings.
using MaterialCard = std::variant<FabricCard, ElasticCard, NullCard, RigidCard, OwnCard>;

/// One material of the deck.
struct Material {
    int id = 0;         ///< MID
    std::string title;  ///< from the deck, may be empty
    MaterialCard card;  ///< its law and numbers, by keyword
};

}  // namespace corpuscle::fabric
