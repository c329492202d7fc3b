// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/scene/scene_state.hpp"

namespace corpuscle {

std::string StepLimit::text() const {
    switch (who) {
        case Who::SHELL:
            return fmt::format("shell {}", id);
        case Who::STRAIN:
            return "the start of strained cloth";
        case Who::GAS:
            return fmt::format("gas of bag {}", id);
        case Who::JOINT:
            return fmt::format("joint stiffness {}", id);
        case Who::START:
            return "the first step asked for";
        case Who::END:
            return "end time";
        case Who::NOTHING:
            break;
    }
    return "nothing";
}

StepLimit SceneState::shells_step() const {
    StepLimit limit;
    if (cloth.membranes) {
        const auto [dt, shell] = cloth.membranes->stable_step();
        if (shell >= 0)
            limit.tighten(model.step_factor * dt, StepLimit::Who::SHELL, model.shells[shell].id);
    }
    return limit;
}

StepLimit SceneState::stable_step(bool without_start) const {
    StepLimit limit = shells_step();
    // Whoever asks for steps beyond the stable one gets them from the first on
    if (!without_start && model.step_factor <= 1.0)
        limit.tighten(cloth.strained_start.longest(), StepLimit::Who::STRAIN, 0);
    const double by_cloth = limit.dt;
    for (const gas::BagGas& bag : airbags.particle)
        limit.tighten(step_beside(bag.stable_step(), by_cloth), StepLimit::Who::GAS, bag.card().id);
    // Rigid bodies and gas at uniform pressure set no limit: a thousand steps are what a path and a
    // curve of inflow want to be seen.
    if (limit.who == StepLimit::Who::NOTHING) limit.dt = model.end_time / 1000.0;
    if (bodies.springs) {
        const JointSprings::Limit joint = bodies.springs->stable_step(bodies.all);
        limit.tighten(model.step_factor * joint.dt, StepLimit::Who::JOINT, joint.id);
    }
    for (const gas::UniformBag& bag : airbags.uniform)
        limit.tighten(bag.stable_step(), StepLimit::Who::GAS, bag.card().id);
    if (clock.step == 0 && model.step_start > 0.0 && !without_start)
        limit.tighten(model.step_start, StepLimit::Who::START, 0);
    const double rest = model.end_time - clock.t;
    if (limit.dt >= rest * (1.0 - 1e-9)) return {rest, StepLimit::Who::END, 0};
    if (2.0 * limit.dt > rest)
        limit.dt = 0.5 * rest;  // two like steps, not a last one that is tiny
    return limit;
}

}  // namespace corpuscle
