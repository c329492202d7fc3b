// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace corpuscle::support {

/// A deck that a user might write, in SI units.
struct RandomScene {
    std::string deck;     ///< *KEYWORD to *END
    std::string summary;  ///< what it holds, on a line
    unsigned seed;        ///< of `corpuscle run --seed`
    int particles;        ///< NP
    bool is_rigid;        ///< nothing moves but gas
};

/// A closed box of 0.3 to 60 litres in the atmosphere with an inflator in it; a second or two of
/// computing. Walls: rigid, or cloth that touches itself, one face held. By chance: 1 or 2 chambers
/// with or without a hole between them, a vent, a porous part, heat to the walls; initial air as
/// IAIR 0, 1, -1 or 2; 1 to 3 gases of 1 or 2 inflators with 1 to 4 nozzles; 10 to 20 000
/// particles, TSW, TSSFAC 0.2 to 0.9. Cloth may meet a plane or a rigid body that flies against it,
/// and weigh something.
[[nodiscard]] RandomScene random_scene(unsigned seed);

/// The same of cloth that nothing holds, thrown, without vents, pores, heat to the walls, TSW,
/// plane and weight; its nozzles push it (IMOM = 1), and no gas comes in after 0.4 of the time: from
/// then on its momentum, with that of gas and body, is constant. Rows and frames at the same times.
[[nodiscard]] RandomScene free_scene(unsigned seed);

}  // namespace corpuscle::support
