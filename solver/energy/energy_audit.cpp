// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/energy/energy_audit.hpp"

#include "solver/base/parallel.hpp"

namespace corpuscle {
namespace {

/// Contact gives no more than it took. What goes beyond that is work that its growing gaps and
/// areas bring into the scene: it parts surfaces that began nearer than their thickness.
void bring_in_parting(Moved& moved) {
    if (moved.contact >= 0.0) return;
    moved.external -= moved.contact;
    moved.contact = 0.0;
}

}  // namespace

double ForceShare::work(const Points& v_mid, double span) const {
    return span * parallel::sum(f.size(), 0.0, [&](std::size_t n) { return f[n].dot(v_mid[n]); });
}

std::pair<double, double> ForceShare::works(const Points& v_mid, const Points& v_before,
                                            double span) const {
    using Two = Eigen::Vector2d;
    const Two sums = parallel::sum(f.size(), Two(Two::Zero()), [&](std::size_t n) {
        return Two(f[n].dot(v_mid[n]), f[n].dot(v_before[n]));
    });
    return {span * sums[0], span * sums[1]};
}

void EnergyAudit::book(SceneState& scene, double span) {
    book_forces(scene, span);
    book_contact(scene);
    book_airbags(scene, span);
    book_restored(scene);
    bring_in_parting(scene.ledger.after);
    book_impulses(scene, span);
    if (scene.clock.step == 0) scene.ledger.open(books(scene));
}

/// Books the work of this kick's forces, sum of f · v_mid · span, v_mid = (v_before + v) / 2:
/// exactly the change of kinetic energy, so what held nodes gain beyond it, and beyond what
/// obstacles gave, came from their supports.
void EnergyAudit::book_forces(SceneState& scene, double span) {
    const fabric::Nodes& nodes = scene.nodes;
    KickVelocities& v = scene.v;
    parallel::for_each(nodes.size(),
                       [&](std::size_t n) { v.mid[n] = 0.5 * (v.before[n] + nodes.v[n]); });
    for (const RigidBody& body : scene.bodies.all)
        for (const Index n : body.nodes()) v.mid[n] = body.mid_velocity_at(nodes.x[n]);

    const auto gain = [&](Index n) {
        Vec3 given = span * nodes.f[n];
        if (!v.kicked.empty()) given += nodes.mass[n] * (nodes.v[n] - v.kicked[n]);
        return 0.5 * nodes.mass[n] * (nodes.v[n].squaredNorm() - v.before[n].squaredNorm()) -
               given.dot(v.mid[n]);
    };
    Moved& moved = scene.ledger.after;
    for (const Index n : scene.supports.nodes()) moved.external += gain(n);
    for (const RigidBody& body : scene.bodies.all) {
        moved.external += body.held_work() + body.field_work();
        moved.damping += body.damped();
    }
    if (scene.bodies.springs) moved.damping += scene.bodies.springs->damped(span, scene.bodies.all);
    moved.external += scene.forces.loads.work(v.mid, span);

    moved.damping -= scene.forces.damping.work(v.mid, span);
    if (scene.cloth.membranes)
        moved.damping += scene.cloth.membranes->damping_energy(v.before, nodes.v, span);
}

/// Of what contact and walls took, friction has its share.
void EnergyAudit::book_contact(SceneState& scene) {
    Moved& moved = scene.ledger.after;
    if (scene.obstacles.contact) rubbed_ += scene.obstacles.contact->friction_work(scene.v.mid);
    double friction = rubbed_;
    for (const contact::RigidWall& wall : scene.obstacles.walls) friction += wall.friction_energy();
    moved.contact -= friction - moved.friction;
    moved.friction = friction;
}

void EnergyAudit::book_airbags(SceneState& scene, double span) {
    Moved& moved = scene.ledger.after;
    moved.ambient = moved.smoothing = 0.0;
    for (gas::BagGas& bag : scene.airbags.particle) {
        bag.book_load(scene.v.mid, span);
        moved.ambient += bag.ambient_work();
        moved.smoothing += bag.smoothing_given();
    }
    for (gas::UniformBag& bag : scene.airbags.uniform) {
        const double scaled = bag.scaling_work();
        bag.book_load(scene.v.mid, span);
        moved.ambient += bag.ambient_work();
        moved.external += bag.scaling_work() - scaled;
    }
}

/// Strains that TSRFAC brings in are work from outside.
void EnergyAudit::book_restored(SceneState& scene) {
    if (!scene.cloth.membranes) return;
    const double restored = scene.cloth.membranes->restored_energy() - restored_;
    restored_ += restored;
    scene.ledger.before.external += restored;
    scene.ledger.after.external += restored;
    scene.cloth.growth.give(restored);
}

/// What walls, contacts and joints have got in this kick.
void EnergyAudit::book_impulses(SceneState& scene, double span) {
    scene.impulses.walls.commit();
    for (std::size_t w = 0; w < scene.obstacles.walls.size(); ++w)
        scene.impulses.walls.give(w, scene.obstacles.walls[w].impulse());
    scene.impulses.contacts.commit();
    for (std::size_t c = 0; c < scene.impulses.contacts.size(); ++c)
        scene.impulses.contacts.give(c, span * scene.obstacles.contact->force(static_cast<int>(c)));
    scene.impulses.joints.commit();
    scene.impulses.turnings.commit();
    if (scene.bodies.joints) {
        const std::vector<RigidJoints::Given> given = scene.bodies.joints->take_given();
        for (std::size_t j = 0; j < given.size(); ++j) {
            scene.impulses.joints.give(j, given[j].impulse);
            scene.impulses.turnings.give(j, given[j].turning);
        }
    }
}

EnergyBooks EnergyAudit::books(const SceneState& scene) {
    EnergyBooks instant;
    if (scene.bodies.springs) {
        instant.strain += scene.bodies.springs->energy();
        instant.friction += scene.bodies.springs->rubbed();
    }
    if (scene.cloth.membranes) {
        instant.strain += scene.cloth.membranes->strain_energy();
        instant.damping += scene.cloth.membranes->lost_energy();
    }
    for (const gas::BagGas& bag : scene.airbags.particle) {
        instant.gas += bag.energy();
        instant.smoothing += bag.smoothing_taken();
        instant.inflow += bag.inflow_energy();
        instant.outflow += bag.lost_energy();
    }
    for (const gas::UniformBag& bag : scene.airbags.uniform) {
        instant.gas += bag.energy();
        instant.inflow += bag.inflow_energy();
        instant.outflow += bag.outflow_energy();
    }
    return scene.ledger.balance(instant);
}

}  // namespace corpuscle
