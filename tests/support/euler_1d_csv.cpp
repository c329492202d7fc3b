// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
// Prints the pressure on the fast piston by the 1-D Euler equations, for tools/figures.
#include <fmt/core.h>

#include "tools/verify/exact/fast_piston.hpp"

int main() {
    std::vector<double> times;
    for (int i = 0; i <= 500; ++i) times.push_back(5.0e-3 + i * 1.0e-5);
    const auto pressure = corpuscle::oracle::fast_piston::piston_pressure(times, 800);
    fmt::print("time [s],pressure on the piston [Pa]\n");
    for (std::size_t i = 0; i < times.size(); ++i) {
        fmt::print("{:.5f},{:.6g}\n", times[i], pressure[i]);
    }
}
