// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/fault.hpp"

namespace corpuscle {

/// Bad input: every fault that was found. Exit status 2.
struct InputError : std::runtime_error {
    /// Faults in the words of physics; `faults` gets their texts.
    explicit InputError(std::vector<Fault> all) : InputError(texts(all)) { typed = std::move(all); }
    /// Messages as they stand; `typed` gets them as `why` alone. what() joins them by line ends.
    explicit InputError(std::vector<std::string> all)
        : std::runtime_error(lines(all)), faults(std::move(all)) {
        for (const std::string& fault : faults) typed.push_back({.of = {}, .why = fault});
    }
    /// One message.
    explicit InputError(std::string one) : InputError(std::vector<std::string>{std::move(one)}) {}
    /// One fault.
    explicit InputError(Fault one) : InputError(std::vector<Fault>{std::move(one)}) {}

    std::vector<std::string> faults;  ///< one message each
    std::vector<Fault> typed;         ///< the same, for translation into deck words

private:
    static std::vector<std::string> texts(const std::vector<Fault>& all) {
        std::vector<std::string> out;
        for (const Fault& fault : all) out.push_back(fault.text());
        return out;
    }
    static std::string lines(const std::vector<std::string>& all) {
        std::string text;
        for (const std::string& fault : all) (text += text.empty() ? "" : "\n") += fault;
        return text;
    }
};

/// The physics broke (an inverted element, a NaN, a particle that left a closed bag). Exit
/// status 3.
struct PhysicsError : std::runtime_error {
    /// @param at_time        of the step that broke                                           [s]
    /// @param where_and_why  element, node or particle by its id, and what is wrong with it
    PhysicsError(double at_time, const std::string& where_and_why)
        : std::runtime_error("at time " + digits(at_time) + ": " + where_and_why), time(at_time) {}

    double time;  ///< of the step that broke; what() begins with it                 [s]

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
