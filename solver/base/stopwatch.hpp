// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

namespace corpuscle {

/// Wall time by phase, in order of first appearance.                                       [s]
class Timings {
public:
    /// @param phase    a string literal: its characters are not copied
    /// @param seconds  are added to what it has, 0 at first                                   [s]
    void add(std::string_view phase, double seconds) {
        for (auto& [name, total] : phases_) {
            if (name == phase) {
                total += seconds;
                return;
            }
        }
        phases_.emplace_back(phase, seconds);
    }
    /// Name and total of each.                                                               [s]
    [[nodiscard]] const std::vector<std::pair<std::string_view, double>>& phases() const {
        return phases_;
    }

private:
    std::vector<std::pair<std::string_view, double>> phases_;
};

/// lap("phase") books the time since the last lap. Phase names are string literals.
class Stopwatch {
public:
    /// Starts the first lap.
    /// @param timings  gets all laps; outlives the watch
    explicit Stopwatch(Timings& timings) : timings_(timings) {}

    /// Ends a lap and begins the next.
    void operator()(std::string_view phase) {
        const auto now = std::chrono::steady_clock::now();
        timings_.add(phase, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }

private:
    Timings& timings_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace corpuscle
