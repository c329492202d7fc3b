// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: moments between bodies are those of their angles, keep angular momentum, and energy to the
// order of the step; a run that is interrupted goes on with the same bits.
#include "solver/bodies/joint_springs.hpp"

#include <catch2/catch.hpp>

#include <memory>
#include <numbers>

#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

constexpr double RATE = 30.0;  ///< spins at the start, about                            [rad/s]

Index spring_curve(Model& model, std::vector<double> x, std::vector<double> y) {
    model.curves.push_back({static_cast<int>(model.curves.size()) + 1, std::move(x), std::move(y)});
    return static_cast<Index>(model.curves.size() - 1);
}

/// Two bricks that turn past each other, on three springs between axes that are at an angle.
Model sprung_bricks(double end_time) {
    Model model = scenes::empty(end_time);
    for (int k = 0; k < 2; ++k) {
        const Index part = scenes::add(model, shapes::box({0.3, 0.2, 0.1 + 0.1 * k}),
                                       scenes::rigid(1000.0), 1e-3, Vec3(k, 0, 0));
        const Vec3 spin = k == 0 ? Vec3(0.3, -0.2, 0.5) : Vec3(-0.4, 0.3, -0.6);
        model.rigid_velocity.push_back({part, Vec3(1, 2, 3), RATE * spin});
    }
    JointStiffness joint;
    joint.id = 7;
    joint.parts = {0, 1};
    joint.axes = {Mat3::Identity(),
                  Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix()};
    for (std::size_t k = 0; k < 3; ++k) {
        const double stiff = 20.0 + 10.0 * static_cast<double>(k);
        joint.about[k].spring = spring_curve(
            model, {-3.0, -0.5, 0.5, 3.0}, {-4.0 * stiff, -0.5 * stiff, 0.5 * stiff, 4.0 * stiff});
    }
    model.joint_stiffnesses = {joint};
    return model;
}

/// Worst residual over the scene's energy.
double worst_residual(Model model) {
    Simulation run(std::move(model));
    double worst = 0.0, energy = 0.0;
    while (!run.is_over())
        run.step([&](Simulation& at) {
            const EnergyBooks books = at.books();
            worst = std::max(worst, std::abs(books.residual));
            energy = std::max(energy, books.kinetic + books.strain);
        });
    return worst / energy;
}

Vec3 all_turning(const Simulation& run) {
    Vec3 all = Vec3::Zero();
    for (const RigidBody& body : run.bodies())
        all += body.angular_momentum() + body.mass() * body.position().cross(body.velocity());
    return all;
}

}  // namespace

TEST_CASE("springs about three angles keep momenta, and energy to second order of the step",
          "[solver][rigid]") {
    Simulation run(sprung_bricks(0.4));
    const Vec3 before = all_turning(run);
    double least = INF, most = 0.0;
    while (!run.is_over()) {
        run.step([&](Simulation& at) {
            least = std::min(least, at.books().strain);
            most = std::max(most, at.books().strain);
        });
    }
    CHECK((all_turning(run) - before).norm() < 1e-12 * before.norm());
    CHECK(most - least > 1.0);
    // a thousand steps a run: the longer run's are four times as long
    const double coarse = worst_residual(sprung_bricks(0.4));
    const double fine = worst_residual(sprung_bricks(0.1));
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 8.0);
}

TEST_CASE("a spring that swings through theta = 90 degrees has the bodies' reduced inertia",
          "[solver][rigid]") {
    Model model = sprung_bricks(0.5);
    model.rigid_velocity[0].spin = Vec3(0, -40.0, 0);
    model.rigid_velocity[1].spin = Vec3(0, 40.0, 0);
    JointStiffness& joint = model.joint_stiffnesses[0];
    joint.axes[1] = Mat3::Identity();
    for (const std::size_t k : {0U, 2U}) joint.about[k] = {};
    constexpr double ABOUT_Y = 4e-3, AMPLITUDE = 2.2, FREQUENCY = 80.0 / AMPLITUDE;
    for (Index part = 0; part < 2; ++part)  // stable about y
        model.rigid_inertia.push_back(
            {part, 0.2, Vec3(part, 0, 0), Vec3(2e-3, ABOUT_Y, 3e-3).asDiagonal()});
    const double stiff = FREQUENCY * FREQUENCY * ABOUT_Y / 2.0;
    double most = 0.0, angle = 0.0;
    joint.about[1].spring = spring_curve(model, {-9.0, 9.0}, {-9.0 * stiff, 9.0 * stiff});
    Simulation run(model);
    while (!run.is_over()) {
        const StepReport step = run.step([](Simulation&) {});
        angle += step.dt * (run.bodies()[1].spin() - run.bodies()[0].spin()).y();
        most = std::max(most, angle);
    }
    CHECK(most == Approx(AMPLITUDE).epsilon(1e-4));
    CHECK(angle == Approx(AMPLITUDE * std::sin(FREQUENCY * run.time())).margin(1e-3 * AMPLITUDE));
}

TEST_CASE("phi or psi near theta = 90 degrees stop the run, or the start", "[solver][rigid]") {
    Model model = sprung_bricks(0.5);
    model.joint_stiffnesses[0].axes[1] = Mat3::Identity();
    model.joint_stiffnesses[0].about[1] = {};
    model.rigid_velocity[0].spin = Vec3::Zero();
    model.rigid_velocity[1].spin = Vec3(0, 40.0, 0);
    const auto go = [&] {
        Simulation run(model);
        while (!run.is_over()) run.step([](Simulation&) {});
    };
    CHECK_THROWS_AS(go(), PhysicsError);
    model.joint_stiffnesses[0].axes[1] =
        Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix();
    CHECK_THROWS_AS(go(), InputError);
}

TEST_CASE("a stiff stop sets the step, a restart after every step leaves no trace",
          "[solver][rigid][restart]") {
    Model model = sprung_bricks(0.1);
    model.joint_stiffnesses[0].axes[1] = Mat3::Identity();
    JointAxis& about = model.joint_stiffnesses[0].about[2];
    about.stiffness = 1e6;
    about.friction = 3.0;
    about.high = 0.1;
    about.damper = spring_curve(model, {-1.0, 1.0}, {-0.1, 0.1});
    const auto go = [&](bool is_restarted) {
        auto run = std::make_unique<Simulation>(model);
        CHECK(run->stable_step().who == StepLimit::Who::JOINT);
        CHECK(run->stable_step().text() == "joint stiffness 7");
        std::vector<char> samples;
        double residual = 0.0, friction = 0.0;
        while (!run->is_over()) {
            run->step([&](Simulation& at) {
                StateWriter bytes;
                Sample sample = at.sample();
                bytes(sample);
                const std::vector<char> told = bytes.take();
                samples.insert(samples.end(), told.begin(), told.end());
                residual = std::max(residual, std::abs(sample.energy.residual));
                friction = sample.energy.friction;
            });
            if (!is_restarted) continue;
            StateWriter state;
            state(*run);
            const std::vector<char> bytes = state.take();
            run = std::make_unique<Simulation>(model);
            StateReader reader(bytes);
            reader(*run);
            REQUIRE(reader.is_at_end());
        }
        CHECK(friction > 0.05);
        CHECK(residual < 0.05 * friction);
        return samples;
    };
    CHECK(go(false) == go(true));
}
