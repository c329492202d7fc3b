// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/verification/dsmc/flows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/dsmc/hard_spheres.hpp"

namespace corpuscle::dsmc {
namespace {

using std::numbers::pi;

constexpr double CELLS = 3.0;          ///< by mean free path of the air at rest
constexpr double A_CELL = 10.0;        ///< particles
constexpr std::size_t FEWEST = 20000;  ///< particles of a plane
constexpr double SHARE =
    0.1;  ///< dt in mean free paths / c: a sixth of the time between collisions
constexpr int STEPS_A_SAMPLE = 4;

int cells(double length, double resolution) {
    return 2 * static_cast<int>(std::ceil(0.5 * CELLS * resolution * length));
}

std::size_t particles_in(const std::array<int, 2>& grid) {
    return std::max(FEWEST, static_cast<std::size_t>(A_CELL * grid[0] * grid[1]));
}

}  // namespace

PlaneField::PlaneField(const SlotFlow& flow)
    : along_(static_cast<int>(flow.length) * BINS),
      across_(static_cast<int>(flow.height) * BINS),
      bins_(static_cast<std::size_t>(along_ * across_)) {}

void PlaneField::add(double x, double y, double u) {
    const int i = std::clamp(static_cast<int>(x * BINS), 0, along_ - 1),
              j = std::clamp(static_cast<int>(y * BINS), 0, across_ - 1);
    Sums& bin = bins_[static_cast<std::size_t>(i * across_ + j)];
    bin.n += 1.0;
    bin.nu += u;
}

void PlaneField::begin(std::size_t at_rest) {
    at_rest_ += static_cast<double>(at_rest) / static_cast<double>(bins_.size());
}

std::vector<PlaneField::Sums> PlaneField::profile(double x) const {
    std::vector<Sums> rows(static_cast<std::size_t>(across_));
    const int middle = static_cast<int>(x * BINS), half = BINS / 4;
    for (int i = middle - half; i < middle + half; ++i)
        for (int j = 0; j < across_; ++j) {
            const Sums& bin = bins_[static_cast<std::size_t>(i * across_ + j)];
            Sums& row = rows[static_cast<std::size_t>(j)];
            row.n += bin.n;
            row.nu += bin.nu;
        }
    return rows;
}

/// Greatest y where the speed of a profile is `u`, linear between rows.
double PlaneField::outermost(const std::vector<Sums>& rows, double u) {
    const auto speed = [&](std::size_t j) { return rows[j].nu / rows[j].n; };
    std::size_t j = rows.size() - 1;
    while (j > 0 && speed(j) < u) --j;
    const double beyond = j + 1 < rows.size() ? (speed(j) - u) / (speed(j) - speed(j + 1)) : 0.0;
    return (static_cast<double>(j) + 0.5 + beyond) / BINS;
}

Findings PlaneField::layer() const {
    Findings found;
    for (const double x : {1.0, 2.0, 3.0}) {
        const auto rows = profile(x);
        double n = 0.0, nu = 0.0;
        for (std::size_t j = 0; j < BINS / 2; ++j) {
            n += rows[j].n;
            nu += rows[j].nu;
        }
        found[fmt::format("thickness, x = {:.0f}", x)] =
            outermost(rows, 0.2 * nu / n) - outermost(rows, 0.8 * nu / n);
    }
    return found;
}

Findings PlaneField::jet() const {
    Findings found;
    for (const double x : {2.0, 4.0, 6.0}) {
        const auto rows = profile(x);
        double n = 0.0, nu = 0.0, flux = 0.0;
        for (std::size_t j = 0; j < BINS / 4; ++j) {
            n += rows[j].n;
            nu += rows[j].nu;
        }
        for (const Sums& row : rows) flux += std::max(0.0, row.nu);
        const std::string at = fmt::format(", x = {:.0f}", x);
        found["middle" + at] = nu / n / SlotFlow::STREAM;
        found["width" + at] = outermost(rows, 0.5 * nu / n);
        found["mass" + at] = flux / (0.5 * BINS * BINS * at_rest_ * SlotFlow::STREAM);
    }
    return found;
}

Findings crossed(const std::array<double, 2>& air_helium, double time) {
    return {{fmt::format("air, {:.0f}", time), air_helium[0]},
            {fmt::format("helium, {:.0f}", time), air_helium[1]}};
}

double diffusivity(double share, double time) {
    const auto crossed_by = [&](double D) {
        double sum = 0.5;
        for (int k = 1; k < 400; k += 2)
            sum -= 4.0 / (pi * pi * k * k) *
                   std::exp(-k * k * pi * pi * D * time / (SlitFlow::LENGTH * SlitFlow::LENGTH));
        return sum;
    };
    double low = 0.0, high = 1.0;
    while (crossed_by(high) < share && high < 1e6) high *= 2.0;
    for (int i = 0; i < 60; ++i)
        (crossed_by(0.5 * (low + high)) < share ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
}

Findings by_spheres(const SlotFlow& flow, double resolution, std::uint64_t seed) {
    const std::array<int, 2> grid{cells(flow.length, resolution), cells(flow.height, resolution)};
    const std::size_t n = particles_in(grid);
    const double density = static_cast<double>(n) / (flow.length * flow.height);
    HardSpheres gas({{flow.length, flow.height}, grid, false, flow.outlet}, {{1.0, 1.0}}, density,
                    1.0 / resolution, seed);
    gas.fill(0, n, 0.0, flow.length);
    gas.set_slot({flow.slot, density * SlotFlow::STREAM, SlotFlow::SPEED,
                  SlotFlow::HALF_ANGLE * pi / 180.0});
    PlaneField field(flow);
    const double dt = SHARE / resolution;
    const int steps = static_cast<int>(flow.end / dt);
    for (int s = 1; s <= steps; ++s) {
        gas.step(dt);
        if (s * dt <= flow.from || s % STEPS_A_SAMPLE != 0) continue;
        field.begin(n);
        for (const Particle& p : gas.particles()) field.add(p.x[0], p.x[1], p.v[0]);
    }
    return flow.is_jet ? field.jet() : field.layer();
}

Findings by_spheres(const SlitFlow& flow, double resolution, std::uint64_t seed) {
    const std::array<int, 2> grid{cells(SlitFlow::LENGTH, resolution),
                                  cells(SlitFlow::HEIGHT, resolution)};
    const std::size_t n = particles_in(grid);
    HardSpheres gas({{SlitFlow::LENGTH, SlitFlow::HEIGHT}, grid, false, 0.0, flow.slit},
                    {{1.0, 1.0}, {SlitFlow::HELIUM_MASS, SlitFlow::HELIUM_DIAMETER}},
                    static_cast<double>(n) / (SlitFlow::LENGTH * SlitFlow::HEIGHT),
                    1.0 / resolution, seed);
    const double plate = 0.5 * SlitFlow::LENGTH;
    gas.fill(0, n / 2, 0.0, plate);
    gas.fill(1, n / 2, plate, SlitFlow::LENGTH);
    Findings found;
    double t = 0.0;
    for (const double time : SlitFlow::TIMES) {
        const int steps = static_cast<int>(std::ceil((time - t) * resolution / SHARE));
        for (int s = 0; s < steps; ++s) gas.step((time - t) / steps);
        t = time;
        std::array<double, 2> over{};
        for (const Particle& p : gas.particles())
            over[static_cast<std::size_t>(p.gas)] += (p.x[0] < plate) == (p.gas == 1);
        const double each = 0.5 * static_cast<double>(n);
        found.merge(crossed({over[0] / each, over[1] / each}, time));
    }
    return found;
}

}  // namespace corpuscle::dsmc
