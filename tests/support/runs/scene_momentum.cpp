// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/runs/scene_momentum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::test {
namespace {

struct Momentum {
    Vec3 sum = Vec3::Zero();  ///< [kg m/s]
    double sizes = 0.0;       ///< of all that is in it                               [kg m/s]

    void add(const Vec3& p) {
        sum += p;
        sizes += p.norm();
    }
};

Vec3 row(const std::vector<double>& all, std::size_t i) {
    return {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
}

/// Of a row of the history and the frame of the same time.
Momentum momentum_at(const io::Hdf5Reader& file, std::size_t i) {
    Momentum all;
    for (const std::string& part : file.names("/history/part"))
        all.add(row(file.read<double>("/history/part/" + part + "/momentum"), i));
    all.add(row(file.read<double>("/history/airbag/1/owed_momentum"), i));
    const std::string gas = fmt::format("/frames/{:05d}/particles", i);
    if (!file.has(gas)) return all;
    const auto v = file.read<double>(gas + "/velocity"), mass = file.read<double>(gas + "/mass");
    for (std::size_t k = 0; k < mass.size(); ++k) all.add(mass[k] * row(v, k));
    return all;
}

}  // namespace

double change_of_momentum(const std::filesystem::path& results, double since) {
    const io::Hdf5Reader file(results);
    const auto time = file.read<double>("/history/time"),
               frames = file.read<double>("/frames/time");
    if (time != frames) throw std::runtime_error("rows and frames are of different times");
    Momentum start;
    double worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < since * time.back()) continue;
        const Momentum now = momentum_at(file, i);
        if (start.sizes == 0.0) start = now;
        worst = std::max(worst, (now.sum - start.sum).norm() / now.sizes);
    }
    return worst;
}

}  // namespace corpuscle::test
