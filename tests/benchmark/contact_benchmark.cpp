// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What contact costs on one core, in processor time: an inflated bag that touches nothing, and a
// sheet of 10 000 facets as it is crumpled as far as it will go.

#include <fmt/core.h>

#include <ctime>
#include <random>
#include <string_view>

#include "contact/surface_contact.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::SpringCloth;

namespace {

/// Processor time of this program so far.                                                  [ms]
double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

constexpr double SIDE = 0.6;         ///< of the sheet  [m]
constexpr double SPEED = 20.0;       ///< of the flow  [m/s]
constexpr std::size_t JAMMED = 600;  ///< steps without getting smaller by a tenth
constexpr double DRAG = 5e3;         ///< rate at which the cloth takes it on  [1/s]
const Vec3 CENTRE(SIDE / 2, SIDE / 2, 0.0);

/// Root mean square distance from the centre, by that of the flat sheet.                    [-]
double size_of(const Points& x) {
    double sum = 0.0;
    for (const Vec3& p : x) sum += (p - CENTRE).squaredNorm();
    return std::sqrt(sum / static_cast<double>(x.size())) / (SIDE / std::sqrt(6.0));
}

/// Costs of the steps since the last line.
struct Costs {
    double search = 0.0, response = 0.0;  ///< [ms]
    std::size_t builds = 0, steps = 0;    ///< builds: before the first of them

    void add(const Costs& more) {
        search += more.search;
        response += more.response;
        steps += more.steps;
    }
    void print(double size, const ContactCounts& counts) const {
        const auto n = static_cast<double>(steps);
        fmt::print("{:>6.3f} {:>6} {:>10} {:>8} {:>9} {:>8.3f} {:>8.3f} {:>10.3f} {:>8.3f}\n", size,
                   steps, counts.candidates, counts.near, counts.touching,
                   static_cast<double>(counts.builds - builds) / n, search / n, response / n,
                   (search + response) / n);
    }
};

/// A step of the cloth in a flow towards its centre. Returns what contact cost.
Costs advance(SpringCloth& cloth, SurfaceContact& contact, double dt, int n, double speed) {
    std::fill(cloth.f.begin(), cloth.f.end(), Vec3::Zero());
    cloth.add_spring_force();
    const double shrinking = speed / (0.7 * SIDE * size_of(cloth.x));  // [1/s]
    for (std::size_t i = 0; i < cloth.x.size(); ++i)
        cloth.f[i] -= cloth.mass[i] * DRAG * (cloth.v[i] + shrinking * (cloth.x[i] - CENTRE));
    const double start = now();
    contact.find(cloth.x, cloth.v, n * dt, dt);
    const double found = now();
    cloth.kick(dt);
    const double kicked = now();
    contact.respond(cloth.x, dt, cloth.v);
    const double responded = now();
    cloth.drift(dt);
    return {found - start, responded - kicked, 0, 1};
}

/// Draws a sheet together by a flow towards its centre, at 20 m/s where it is widest, that drags it
/// along.
void crumple() {
    support::Sheet sheet = support::square_sheet(71, SIDE);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (Vec3& x : sheet.x) x += 5e-4 * Vec3(noise(random), noise(random), noise(random));
    SpringCloth cloth(sheet);
    SurfaceContact contact(cloth.setup({}, cloth.x));
    const double dt = cloth.stable_step();
    fmt::print("{} facets drawn together, {:.3g} us a step\n", cloth.triangles.size(), 1e6 * dt);
    fmt::print(
        "  size  steps candidates     near  touching builds/st  find/ms respond/ms"
        " all/ms\n");
    Costs costs;
    int n = 0;
    const auto step = [&](double speed) { costs.add(advance(cloth, contact, dt, n++, speed)); };
    const auto print = [&] {
        costs.print(size_of(cloth.x), contact.counts());
        costs = {};
        costs.builds = contact.counts().builds;
    };
    for (double next = 0.9; next > 0.1 && costs.steps < JAMMED; step(SPEED)) {
        if (size_of(cloth.x) >= next) continue;
        print();
        next -= 0.1;
    }
    print();
    fmt::print("drawn together no further; comes to rest:\n");
    for (int line = 0; line < 3; ++line) {
        for (int k = 0; k < 200; ++k) step(0.0);
        print();
    }
    const ContactCounts& counts = contact.counts();
    fmt::print("{} impacts, {} clumps, {} unstopped\n", counts.impacts, counts.impact_zones,
               counts.unstopped);
}

/// A bag of 8 192 facets, inflated and flying, that touches nothing.
void inflate(std::size_t particles) {
    Model model = scenes::of(shapes::sphere(0.3, 5), scenes::cloth(), 3e-4);
    scenes::fill(model, scenes::air(), 5e-3, 1e-4, 600.0, {0.01, 0.02, -0.01}, particles);
    model.velocity.assign(model.x.size(), Vec3(20.0, 5.0, -10.0));
    ContactCard card;
    card.id = 1;
    card.parts = {0};
    model.contacts = {card};
    Simulation simulation(model);
    const auto spent = [&](bool on_contact) {
        double sum = 0.0;
        for (const auto& [phase, seconds] : simulation.timings().phases())
            if (!on_contact || phase.starts_with("contact")) sum += seconds;
        return sum;
    };
    const auto watch = [](Simulation&) {};
    while (simulation.time() < 1e-3) simulation.step(watch);
    const double all = spent(false), on_contact = spent(true);
    const auto steps = simulation.steps();
    const std::size_t builds = simulation.contact()->counts().builds;
    while (simulation.steps() < steps + 200) simulation.step(watch);
    const ContactCounts& counts = simulation.contact()->counts();
    fmt::print(
        "inflated bag of {} facets, {} particles: {:.3f} ms of {:.3f} ms a step, {:.2f} %; "
        "{} facets searched, {} candidates, {} near, {} builds in 200 steps\n",
        model.shells.size(), particles, 5.0 * (spent(true) - on_contact),
        5.0 * (spent(false) - all), 100.0 * (spent(true) - on_contact) / (spent(false) - all),
        counts.searched, counts.candidates, counts.near, counts.builds - builds);
}

}  // namespace

/// @param argc  with any argument: the bag only
int main(int argc, char** /*argv*/) {
    parallel::set_threads(1);
    for (const std::size_t particles : {20'000UL, 100'000UL}) inflate(particles);
    if (argc == 1) crumple();
}
