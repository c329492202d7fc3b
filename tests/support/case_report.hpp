// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace corpuscle::test {

/// A line of a table: case, exact answer, measured.
inline void report(const std::string& what, double exact, double measured) {
    fmt::print("{:<64} exact {:>12.5g}  measured {:>12.5g}\n", what, exact, measured);
    std::fflush(stdout);
}

}  // namespace corpuscle::test
