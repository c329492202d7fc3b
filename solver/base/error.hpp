// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle {

/// Bad input: every fault that was found, one message each, in the user's words. Exit status 2.
struct InputError : std::runtime_error {
    explicit InputError(std::vector<std::string> all)
        : std::runtime_error(fmt::format("{}", fmt::join(all, "\n"))), faults(std::move(all)) {}
    explicit InputError(std::string one) : InputError(std::vector<std::string>{std::move(one)}) {}

    std::vector<std::string> faults;
};

/// The physics broke (an inverted element, a NaN, a particle that left a closed bag). Exit
/// status 3.
struct PhysicsError : std::runtime_error {
    PhysicsError(double at_time, const std::string& where_and_why)
        : std::runtime_error(fmt::format("at time {:.6g}: {}", at_time, where_and_why)),
          time(at_time) {}

    double time;  ///< [s]
};

/// A file could not be written or read, the disk is full, ... Exit status 1.
struct SystemError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace corpuscle
