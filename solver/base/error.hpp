// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle {

/// Bad input: every fault that was found, one message each, in the user's words. Exit status 2.
struct InputError : std::runtime_error {
    explicit InputError(std::vector<std::string> all)
        : std::runtime_error(lines(all)), faults(std::move(all)) {}
    explicit InputError(std::string one) : InputError(std::vector<std::string>{std::move(one)}) {}

    std::vector<std::string> faults;

private:
    static std::string lines(const std::vector<std::string>& all) {
        std::string text;
        for (const std::string& fault : all) (text += text.empty() ? "" : "\n") += fault;
        return text;
    }
};

/// The physics broke (an inverted element, a NaN, a particle that left a closed bag). Exit
/// status 3.
struct PhysicsError : std::runtime_error {
    PhysicsError(double at_time, const std::string& where_and_why)
        : std::runtime_error("at time " + digits(at_time) + ": " + where_and_why), time(at_time) {}

    double time;  ///< [s]

private:
    static std::string digits(double number) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.6g", number);
        return text.data();
    }
};

/// A file could not be written or read, the disk is full, ... Exit status 1.
struct SystemError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace corpuscle
