// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/support/draw.hpp"
#include "tests/support/random/random_plan.hpp"
#include "tests/support/random/random_scene.hpp"

/// Cards of a random scene that do not depend on how its bag is cut.
namespace corpuscle::support {

/// *MAT_FABRIC: 470 to 940 dtex polyamide, with what it leaks.
[[nodiscard]] std::string cloth(Draw& draw, Plan& plan, int id, double density, double modulus,
                                bool leaks);

/// *AIRBAG_PARTICLE: initial air, gases, inflators, their nozzles, vents. Says so in the summary.
[[nodiscard]] std::string airbag(Draw& draw, Plan& plan, RandomScene& scene);

}  // namespace corpuscle::support
