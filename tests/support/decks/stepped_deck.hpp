// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "io/deck.hpp"
#include "solver/simulation.hpp"
#include "tests/places.hpp"

/// Decks of tests/decks, read and run.
namespace corpuscle {

inline Model read(const std::string& name) {
    return io::read_deck(std::string(CORPUSCLE_DECKS) + "/" + name);
}

inline bool tells(const std::vector<std::string>& lines, const std::string& words) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.find(words) != std::string::npos;
    });
}

/// Steps, and the time that velocities live at after them.
struct Run {
    explicit Run(Model model) : scene(std::move(model)) {}
    explicit Run(const std::string& name) : Run(read(name)) {}

    void steps(int count) {
        for (int i = 0; i < count && !scene.is_over(); ++i) {
            const StepReport report = scene.step([&](Simulation& at) {
                const EnergyBooks books = at.books();
                residual = std::max(residual, std::abs(books.residual));
                moved = std::max(moved, books.kinetic + books.strain);
            });
            half_step = report.t + 0.5 * report.dt;
            last_time = report.t;
        }
    }
    void to_the_end() { steps(1'000'000); }

    [[nodiscard]] Index row(int node) const {
        const auto& ids = scene.model().node_id;
        return static_cast<Index>(std::find(ids.begin(), ids.end(), node) - ids.begin());
    }
    [[nodiscard]] const Vec3& x(int node) const { return scene.nodes().x[row(node)]; }
    [[nodiscard]] const Vec3& v(int node) const { return scene.nodes().v[row(node)]; }

    Simulation scene;
    double half_step = 0.0;
    double last_time = 0.0;  ///< at which forces were found last                          [s]
    double residual = 0.0;   ///< of the energy books, the worst so far                   [J]
    double moved = 0.0;      ///< kinetic and strain energy, the most so far              [J]
};

}  // namespace corpuscle
