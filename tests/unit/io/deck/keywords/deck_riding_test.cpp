// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a load or damping by parts acts on the mass of these parts, on rigid bodies too.

#include <algorithm>
#include <catch2/catch.hpp>

#include "solver/simulation.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Of cloth 420 kg: part 1 and part 2, of 210 kg each. Nodes 2, 3, 5 and 6 ride on bodies.
const std::string CARRIER =
    "*MAT_RIGID\n5,500.0,1.e9,0.3\n\n\n*PART\nplate\n50,1,5\n"
    "*NODE\n21,2,0,1\n22,3,0,1\n23,3,1,1\n24,2,1,1\n*ELEMENT_SHELL\n20,50,21,22,23,24\n";
const std::string CARRIED = "*SET_NODE\n6\n2,3,5,6\n";
const std::string CARRIED_BY_NODES = CARRIED + "*CONSTRAINED_NODAL_RIGID_BODY\n60,0,6\n";
const std::string WELDED = "*CONSTRAINED_SPOTWELD\n2,6\n3,5\n";
const std::string ON_CARRIER = CARRIER + CARRIED + "*CONSTRAINED_EXTRA_NODES_SET\n50,6\n";
const std::string SHARING = CARRIER + "*ELEMENT_SHELL\n31,50,2,5,24,24\n";
const std::string TIED_ON =
    CARRIER +
    "*NODE\n25,2,0,0\n26,2,1,0\n*ELEMENT_SHELL\n32,50,25,26,24,21\n"
    "*SET_NODE\n8\n5,25\n*SET_NODE\n9\n6,26\n*CONSTRAINED_TIED_NODES\n8\n9\n";
const std::string FALLING = "*INITIAL_VELOCITY\n\n1,0,2\n";
const std::string TUMBLING = "*INITIAL_VELOCITY_GENERATION\n0,0,0.4,1,0,2\n0,0,0,0,1,0\n";

/// A run of some steps.
struct CarriedFlight {
    explicit CarriedFlight(const std::string& more) : scene(read_small(more)) {}

    /// By a step: its span, and what it adds to the momentum.
    template <class Look>
    void steps(int count, Look&& look) {
        double half = 0.0;
        for (int k = 0; k < count; ++k) {
            const Vec3 before = momentum(), of_cloth = cloth_momentum();
            const StepReport step = scene.step([&](Simulation& at) {
                if (k > 0) residual = std::max(residual, std::abs(at.books().residual));
            });
            look(half + 0.5 * step.dt, Vec3(momentum() - before), of_cloth);
            half = 0.5 * step.dt;
        }
    }
    [[nodiscard]] Vec3 momentum() const {
        Vec3 all = Vec3::Zero();
        for (std::size_t n = 0; n < scene.nodes().size(); ++n)
            all += scene.nodes().mass[n] * scene.nodes().v[n];
        for (const RigidBody& body : scene.bodies()) all += body.mass() * body.velocity();
        return all;
    }
    /// Of parts 1 and 2.
    [[nodiscard]] Vec3 cloth_momentum() const {
        Vec3 all = Vec3::Zero();
        for (std::size_t s = 0; s < 3; ++s) {
            const Shell& shell = scene.model().shells[s];
            const int corners = shell.is_triangle() ? 3 : 4;
            for (int k = 0; k < corners; ++k)
                all += scene.scene().cloth.shell_mass[s] / corners * velocity(shell.nodes[k]);
        }
        return all;
    }
    /// As the next kick finds it.
    [[nodiscard]] Vec3 velocity(Index node) const {
        for (const TiedNode& tie : scene.model().tied_nodes)
            if (tie.node == node) node = tie.ends[0];
        for (RigidBody body : scene.bodies()) {
            body.arrive();
            if (std::binary_search(body.nodes().begin(), body.nodes().end(), node))
                return body.velocity() + body.spin().cross(scene.nodes().x[node] - body.position());
        }
        return scene.nodes().v[node];
    }

    Simulation scene;
    double residual = 0.0;
};

void check_same_flight(const std::string& by_parts, const std::string& of_all) {
    CarriedFlight some(by_parts), all(of_all);
    const auto nothing = [](double, const Vec3&, const Vec3&) {};
    some.steps(40, nothing);
    all.steps(40, nothing);
    for (std::size_t n = 0; n < all.scene.nodes().size(); ++n) {
        const auto gap = (some.scene.nodes().x[n] - all.scene.nodes().x[n]).norm();
        CAPTURE(all.scene.model().node_id[n], gap);
        CHECK(gap < 1e-9);
    }
    CHECK(some.residual == Approx(all.residual).margin(1e-6));
}

}  // namespace

TEST_CASE("gravity on parts of cloth pulls what of them rides on bodies", "[io][rigid]") {
    const auto body = GENERATE(CARRIED_BY_NODES, WELDED, ON_CARRIER, SHARING, TIED_ON);
    const auto load = GENERATE(as<std::string>{}, "*LOAD_GRAVITY_PART\n1,3,0,2.0\n2,3,0,2.0\n",
                               "*SET_PART\n3\n1,2\n*LOAD_GRAVITY_PART_SET\n3,3,0,2.0\n");
    CAPTURE(body, load);
    CarriedFlight flight(body + load);
    flight.steps(40, [&](double span, const Vec3& gain, const Vec3&) {
        REQUIRE((gain - span * Vec3(0, 0, -2.0 * 420.0)).norm() < 1e-9);
    });
    CHECK(flight.residual < 1e-6 * 420.0);
}

TEST_CASE("the parts of *LOAD_BODY_PARTS feel it on bodies too", "[io][rigid]") {
    const auto body = GENERATE(CARRIED_BY_NODES, ON_CARRIER, SHARING);
    CarriedFlight flight(body +
                         "*DEFINE_CURVE\n8\n0,2\n1,2\n*SET_PART\n3\n1,2\n*LOAD_BODY_PARTS\n3\n"
                         "*LOAD_BODY_Z\n8,1.0\n");
    flight.steps(40, [&](double span, const Vec3& gain, const Vec3&) {
        REQUIRE((gain - span * Vec3(0, 0, -2.0 * 420.0)).norm() < 1e-9);
    });
}

TEST_CASE("damping of parts of cloth brakes what of them rides on bodies", "[io][rigid]") {
    const auto body = GENERATE(CARRIED_BY_NODES, WELDED, ON_CARRIER, SHARING, TIED_ON);
    const auto start = GENERATE(FALLING, TUMBLING);
    CAPTURE(body, start);
    CarriedFlight flight(body + start +
                         "*DEFINE_CURVE\n8\n0,1\n1,1\n*DAMPING_PART_MASS\n1,8,3.0\n2,8,3.0\n");
    flight.steps(40, [&](double span, const Vec3& gain, const Vec3& of_cloth) {
        REQUIRE((gain + 3.0 * span * of_cloth).norm() < 1e-9 * of_cloth.norm());
    });
    // of the books: what the integrator leaves without damping too
    CarriedFlight undamped(body + start);
    undamped.steps(40, [](double, const Vec3&, const Vec3&) {});
    CHECK(flight.residual < 1.1 * undamped.residual + 1e-3);
}

TEST_CASE("what acts on all parts one by one acts as on the whole", "[io][rigid]") {
    const auto body = GENERATE(ON_CARRIER, SHARING, TIED_ON);
    const auto start = GENERATE(FALLING, TUMBLING);
    CAPTURE(body, start);
    const std::string curve = "*DEFINE_CURVE\n8\n0,2\n1,2\n";
    check_same_flight(
        body + start + curve + "*LOAD_GRAVITY_PART\n1,3,8,1.0\n2,3,8,1.0\n50,3,8,1.0\n",
        body + start + curve + "*LOAD_BODY_Z\n8,1.0\n");
    check_same_flight(body + start + curve + "*DAMPING_PART_MASS\n1,8\n2,8\n50,8\n",
                      body + start + curve + "*DAMPING_GLOBAL\n8\n");
}

TEST_CASE("a load on a rigid part leaves the cloth on it alone", "[io][rigid]") {
    CarriedFlight flight(ON_CARRIER + "*LOAD_GRAVITY_PART\n50,3,0,2.0\n");
    flight.steps(40, [&](double span, const Vec3& gain, const Vec3&) {
        REQUIRE((gain - span * Vec3(0, 0, -2.0 * 150.0)).norm() < 1e-9);
    });
}
