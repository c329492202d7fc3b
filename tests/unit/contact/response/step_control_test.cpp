// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/step_control.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using contact::ContactCard;
using contact::StepControl;
using contact::SurfaceContact;
using support::PENALTY;
using support::SpringCloth;

namespace {

/// `count` pairs, from the one with this number on.
std::vector<StepControl::Nodes> pairs(int count, int from = 0) {
    std::vector<StepControl::Nodes> all;
    for (int i = from; i < from + count; ++i)
        all.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
    return all;
}

/// Steps as contact and the rest allow them, 1 at most; `stopped(i)` are the pairs of the i-th.
template <class Stopped>
void take_steps(StepControl& control, int count, Stopped&& stopped) {
    for (int i = 0; i < count; ++i) {
        std::vector<StepControl::Nodes> some = stopped(i);
        control.follow(std::min(1.0, control.longest()), some, 1000, 3);
    }
}
const auto none = [](int) { return pairs(0); };

}  // namespace

TEST_CASE("contact asks for no step while the guard stops nothing", "[contact]") {
    StepControl control;
    take_steps(control, 1000, none);
    CHECK(control.longest() == INF);
}

TEST_CASE("steps that stop many pairs are followed by shorter ones, which are forgotten again",
          "[contact]") {
    StepControl control;
    take_steps(control, 1, [](int) { return pairs(100); });
    CHECK(control.longest() < 1.0);
    CHECK(control.longest() > 0.9);
    CHECK(control.card() == 3);
    take_steps(control, 20, [](int i) { return pairs(100, 100 * i); });
    CHECK(control.longest() < 0.5);
    const double shortest = control.longest();
    take_steps(control, 400, none);
    CHECK(control.longest() == shortest);  // a pack does not breathe
    take_steps(control, 400, none);
    CHECK(control.longest() > 1.2 * shortest);
    CHECK(control.longest() < 1.0);
    take_steps(control, 10'000, none);
    CHECK(control.longest() == INF);
}

TEST_CASE("a pair that shorter steps do not free does not hold them for ever", "[contact]") {
    StepControl control;
    take_steps(control, 200, [](int) { return pairs(1); });
    const double held = control.longest();
    CHECK(held < 0.9);
    take_steps(control, 5000, [](int) { return pairs(1); });
    CHECK(control.longest() == INF);
    take_steps(control, 3000, none);
    take_steps(control, 200, [](int) { return pairs(1); });  // after a pause it is new
    CHECK(control.longest() == Approx(held));
    // and how often or in which order pairs are named does not matter
    StepControl once, often;
    std::vector<StepControl::Nodes> some = pairs(3), more = {some[2], some[0], some[1], some[0]};
    once.follow(1.0, some, 1000, 0);
    often.follow(1.0, more, 1000, 0);
    CHECK(once.longest() == often.longest());
}

namespace {

constexpr int LAYERS = 8, ROW = 5;  ///< of sheets; nodes along one

struct Pressed {
    std::size_t stopped = 0;                  ///< pairs, in all
    double shortest = INF, at_the_end = INF;  ///< step over the springs' own         [-]
};

/// A pack of loose sheets between two that are pushed together with a force of `push` a node for
/// 100 of the springs' steps, then let alone for 1 100.                                   [N]
Pressed press(double push, bool follows) {
    support::Sheet pack = support::square_sheet(ROW - 1, 0.02);
    for (int i = 1; i < LAYERS; ++i)
        pack.append(support::square_sheet(ROW - 1, 0.02),
                    {1e-3 * (i % 3), 7e-4 * (i % 2), 4e-4 * i});
    SpringCloth cloth(pack);
    SurfaceContact contact(cloth.setup(ContactCard{}, cloth.x, PENALTY));
    const double full = cloth.stable_step(), end = 1200 * full;
    const std::vector<double> rates = cloth.own_rates();
    const std::size_t nodes = ROW * ROW, all = cloth.x.size();
    Pressed out;
    double last = full;
    for (double t = 0.0; t < end; t += last) {
        const double wish = follows ? std::max(0.25 * full, contact.holding_step()) : full;
        const double dt = std::min(full, wish);
        std::fill(cloth.f.begin(), cloth.f.end(), Vec3::Zero());
        cloth.add_spring_force();
        if (t < 100 * full)
            for (std::size_t i = 0; i < nodes; ++i) {
                cloth.f[i].z() += push;
                cloth.f[all - 1 - i].z() -= push;
            }
        contact.find(cloth.x, cloth.v, t, dt);
        contact.add_force(cloth.x, cloth.v, dt, cloth.f, {}, {rates, 1.0});
        cloth.kick(0.5 * (last + dt));
        contact.filter(cloth.x, dt, cloth.v);
        cloth.drift(dt);
        out.shortest = std::min(out.shortest, dt / full);
        out.at_the_end = dt / full;
        last = dt;
    }
    out.stopped = contact.counts().impacts;
    return out;
}

}  // namespace

TEST_CASE("a pack pressed harder than repulsion holds is held by shorter steps, until it is let go",
          "[contact]") {
    const Pressed fixed = press(30.0, false), followed = press(30.0, true);
    INFO(fixed.stopped << " pairs stopped with the springs' step, " << followed.stopped
                       << " with that which contact asks for, " << followed.shortest
                       << " of it at least, " << followed.at_the_end << " at the end");
    CHECK(fixed.stopped > 300);
    CHECK(10 * followed.stopped < 9 * fixed.stopped);
    CHECK(followed.shortest < 0.95);
    CHECK(followed.shortest >= 0.25);
    CHECK(followed.at_the_end == 1.0);
}

TEST_CASE("contact leaves the step alone where repulsion holds", "[contact]") {
    const Pressed followed = press(0.01, true);
    INFO(followed.stopped << " pairs stopped");
    CHECK(followed.shortest == 1.0);
}
