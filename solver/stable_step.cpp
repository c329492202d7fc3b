// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/stable_step.hpp"

#include <fmt/format.h>

namespace corpuscle {

std::string StepLimit::text() const {
    switch (who) {
        case Who::SHELL:
            return fmt::format("shell {}", id);
        case Who::GAS:
            return fmt::format("gas of bag {}", id);
        case Who::CONTACT:
            return fmt::format("contact {}", id);
        case Who::START:
            return "DTINIT";
        case Who::END:
            return "end time";
        case Who::NOTHING:
            break;
    }
    return "nothing";
}

}  // namespace corpuscle
