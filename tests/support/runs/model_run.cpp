// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/runs/model_run.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "io/results/hdf5.hpp"
#include "solver/base/curve.hpp"
#include "tests/places.hpp"

namespace corpuscle::test {

ModelRun::ModelRun(const std::string& model, const std::string& options,
                   const std::string& folder) {
    std::string pattern = std::filesystem::temp_directory_path() / (model + ".XXXXXX");
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no directory " + pattern);
    directory_ = pattern;
    const std::string deck =
        CORPUSCLE_MODELS "/" + (folder.empty() ? model : folder) + "/" + model + ".k";
    const std::string log = (directory_ / "log").string();
    const std::string command = CORPUSCLE_PROGRAM " run '" + deck + "' -o '" + directory_.string() +
                                "' " + options + " >'" + log + "' 2>&1";
    const int ended = std::system(command.c_str());
    status_ = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    if (status_ != 0) std::system(("cat '" + log + "'").c_str());
}

ModelRun::~ModelRun() {
    std::error_code ignored;  // a directory left behind harms nobody
    std::filesystem::remove_all(directory_, ignored);
}

double ModelRun::of_run(const std::string& name) const {
    std::ifstream in(directory_ / "run.json");
    std::ostringstream all;
    all << in.rdbuf();
    const std::string text = all.str(), before = '"' + name + "\": ";
    const auto at = text.find(before);
    if (at == std::string::npos) throw std::runtime_error("run.json has no " + name);
    return std::stod(text.substr(at + before.size()));
}

std::vector<double> ModelRun::history(const std::string& path) const {
    return io::Hdf5Reader(results()).read<double>(path);
}

double ModelRun::at(const std::string& path, double time) const {
    Curve curve;
    curve.x = history("/history/time");
    curve.y = history(path);
    return curve(time);
}

double ModelRun::mean(const std::string& path, double begin, double end) const {
    const auto time = history("/history/time");
    const auto value = history(path);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < begin || time[i] > end) continue;
        sum += value[i];
        count += 1.0;
    }
    if (count == 0.0) throw std::runtime_error(path + " has no sample in the span asked for");
    return sum / count;
}

}  // namespace corpuscle::test
