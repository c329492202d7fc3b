// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/measured_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "io/results/results_content.hpp"
#include "io/text/text.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::verify {

MeasuredRun::MeasuredRun(const std::filesystem::path& folder, const LevelCard& level,
                         double cpu_seconds)
    : folder_(folder),
      level_(&level),
      cpu_seconds_(cpu_seconds),
      results_(std::make_unique<io::Hdf5Reader>(folder / "results.h5")) {}

std::vector<double> MeasuredRun::read(const std::string& path) const {
    if (!results_->has(path))
        throw SystemError(fmt::format("{}: the results hold no {}", folder_.string(), path));
    return results_->read<double>(path);
}

std::vector<Vec3> MeasuredRun::vectors(const std::string& path) const {
    const auto all = read(path);
    std::vector<Vec3> rows;
    for (std::size_t i = 0; i + 2 < all.size(); i += 3)
        rows.emplace_back(all[i], all[i + 1], all[i + 2]);
    return rows;
}

double MeasuredRun::at(const std::string& path, double time) const {
    Curve curve;
    curve.x = this->time();
    curve.y = read(path);
    return curve(time);
}

double MeasuredRun::mean(const std::string& path, double from, double to) const {
    const auto t = time(), value = read(path);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] <= from || t[i] > to * (1.0 + 1e-12)) continue;
        sum += value[i];
        count += 1.0;
    }
    if (count == 0.0)
        throw SystemError(fmt::format("{} has no sample between {} and {}", path, from, to));
    return sum / count;
}

std::vector<std::string> MeasuredRun::frames() const {
    return io::frame_groups(*results_);
}

double MeasuredRun::parameter(const std::string& name) const {
    for (const auto& [key, value] : level_->parameters)
        if (key == name) return value;
    throw SystemError(fmt::format("{}: the level sets no {}", folder_.string(), name));
}

double MeasuredRun::steps() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "run.json").rdbuf();
    constexpr std::string_view KEY = "\"steps\": ";
    const std::string all = text.str();
    const std::size_t at = all.find(KEY);
    if (at == std::string::npos) return NaN;
    const std::size_t begin = at + KEY.size();
    return io::parse_real(all.substr(begin, all.find_first_of(",}\n", begin) - begin))
        .value_or(NaN);
}

double MeasuredRun::particle_steps() const {
    double particles = 0.0;
    if (results_->has("/history/airbag"))
        for (const std::string& bag : names("/history/airbag")) {
            const std::string path = "/history/airbag/" + bag + "/particles";
            if (!results_->has(path)) continue;
            const auto inside = read(path);
            for (const double n : inside) particles += n / static_cast<double>(inside.size());
        }
    return steps() * particles;
}

double greatest_change(const MeasuredRun& run, const std::string& path, double from, double to) {
    const auto time = run.time(), value = run.read(path);
    double start = NaN, worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < from || time[i] > to) continue;
        if (std::isnan(start)) start = value[i];
        worst = std::max(worst, std::abs(value[i] / start - 1.0));
    }
    return std::isnan(start) ? NaN : worst;
}

Estimate maxwell_distance(const Runs& runs, int species, double T, double molar_mass) {
    std::vector<double> speeds;
    for (const MeasuredRun& run : runs) {
        const std::string frame = run.frames().back() + "particles/";
        const auto of = run.read(frame + "species");
        const auto v = run.vectors(frame + "velocity");
        for (std::size_t i = 0; i < v.size(); ++i)
            if (of[i] == species) speeds.push_back(v[i].norm());
    }
    const double a = std::sqrt(GAS_CONSTANT * T / molar_mass);
    return {kolmogorov_smirnov(std::move(speeds),
                               [a](double speed) { return maxwell_below(speed, a); }),
            NaN};
}

Findings by_run(const Runs& runs,
                const std::function<std::map<std::string, double>(const MeasuredRun&)>& of) {
    std::map<std::string, std::vector<double>> samples;
    for (const MeasuredRun& run : runs)
        for (const auto& [name, error] : of(run)) samples[name].push_back(error);
    Findings found;
    for (const auto& [name, errors] : samples) found[name] = mean_of(errors);
    return found;
}

}  // namespace corpuscle::verify
