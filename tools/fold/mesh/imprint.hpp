// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/sheet.hpp"

namespace corpuscle::fold {

/// A line that cells shall not cross.
struct Imprint {
    int name;                   ///< its nodes get this among the lines that they are on;
                                ///< negative if it is curved
    std::vector<double> level;  ///< N: signed distance of every node from the line            [m]
    double snap = 0.4;          ///< nodes nearer than this share of an edge move onto the line
    double gives_way = 0.0;  ///< nodes that cannot move and are nearer than this share of an edge
                             ///< take the line to themselves
    std::function<void(Vec3& X)> settle;  ///< moves a point that is nearly on the line onto it,
                                          ///< or is empty: it stays                            [m]
};

/// Makes the line an edge of every cell that it crosses: nodes close to it move onto it, along an
/// edge and along the lines that hold them; what it still crosses is cut.
/// Isosurface stuffing [Labelle & Shewchuk 2007] in the plane, with nodes that are not free.
/// @returns for every cell of the sheet, -1 or 1: the side of the line that it is on
std::vector<int> imprint(Sheet& sheet, Imprint line);

}  // namespace corpuscle::fold
