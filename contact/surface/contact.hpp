// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "contact/geometry/distance.hpp"

namespace corpuscle::contact {

/// Two places of the cloth, or of rigid bodies, that are near each other: gap = |sum of weight x|,
/// rate = normal · sum of weight v. The weights add up to zero, so forces along them keep momentum.
struct Contact {
    static constexpr std::uint16_t ALONE = 320;  ///< `column` of a contact outside of all columns

    std::array<Index, 4> node;     ///< rows: a node and a triangle's three, or two edges'
    std::array<double, 4> weight;  ///< of x: > 0 on the first place, < 0 on the second
    Vec3 normal;                   ///< from the second place to the first, unit
    double gap;                    ///< between the two places  [m]
    double mass;    ///< 1 / (what an impulse of one makes of the rate)             [kg]
    bool is_edges;  ///< two edges, else a node and a triangle
    std::uint16_t column = ALONE;  ///< name of its column (contact/response/column_colouring.hpp)
    bool on_body = false;          ///< on a rigid body that may move: `mass` is along the normal
    int card = 0;                  ///< row of the card by which they touch
    int side = 0;       ///< 1: the first place is on SURFA, -1: the second is; 0: a single surface
    double rest = 0.0;  ///< gap below which it pushes                                  [m]
    double rest_rate = 0.0;  ///< growth of `rest`                                           [m/s]
    double stiffness = 0.0;  ///< of the pair, normal to it  [N/m]
    double thickness = 0.0;  ///< of contact, at full                                        [m]
    double modulus = 0.0;    ///< through the thickness                                     [Pa]
    double area = 0.0;       ///< that it stands for                                       [m^2]
    double own_area = 0.0;   ///< of the lesser of its places                              [m^2]
    double exposure = 1.0;   ///< how far its places face each other                        [-]
    std::uint32_t area_until = 0;  ///< step from which on its area is out of date
    double owed = 0.0;             ///< energy that it owes to the motion                        [J]
    double force = 0.0;    ///< normal, >= 0                                              [N]
    double impulse = 0.0;  ///< likewise, of the step                                     [N s]
    Vec3 rubbed = Vec3::Zero();  ///< by friction, on the first place                          [N s]
    std::size_t pair = 0;        ///< candidate row
    Index memory = -1;           ///< row of what the pair remembers, or -1; until lists change

    /// Velocity of the first place against the second; v by node row.                       [m/s]
    [[nodiscard]] Vec3 relative(const Points& v) const {
        return weight[0] * v[node[0]] + weight[1] * v[node[1]] + weight[2] * v[node[2]] +
               weight[3] * v[node[3]];
    }
    /// Of the gap: the same along the normal, > 0 as it opens.                              [m/s]
    [[nodiscard]] double rate(const Points& v) const { return normal.dot(relative(v)); }
};

/// Contact between the nearest places of a pair that do not quite touch, its mass that of free
/// nodes alone.
/// @param inverse_mass  by node row; 0: held [1/kg]
[[nodiscard]] inline Contact contact_at(const Pair& pair, const Nearest& nearest, double gap,
                                        const std::vector<double>& inverse_mass) {
    double inverse = 0.0;
    for (int i = 0; i < 4; ++i)
        inverse += nearest.weight[i] * nearest.weight[i] * inverse_mass[pair.node[i]];
    return {pair.node, nearest.weight, nearest.apart / gap, gap, 1.0 / inverse, pair.is_edges};
}

}  // namespace corpuscle::contact
