// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::test {

/// One run of the program on a deck of models/, in a directory of its own that goes when this does.
class ModelRun {
public:
    /// @param model    folder and name of the deck, e.g. "helium_air"
    /// @param options  of `corpuscle run`, e.g. "-D NP=2000 --until 0.004"
    /// @param folder   of models/, where it is not the deck's name
    ModelRun(const std::string& model, const std::string& options, const std::string& folder = "");
    ~ModelRun();
    ModelRun(const ModelRun&) = delete;
    ModelRun& operator=(const ModelRun&) = delete;

    [[nodiscard]] int status() const { return status_; }  ///< the program's exit status
    [[nodiscard]] std::filesystem::path results() const { return directory_ / "results.h5"; }

    /// A number of run.json, by its name.
    [[nodiscard]] double of_run(const std::string& name) const;

    /// One number a sample of results.h5, in order of /history/time.
    [[nodiscard]] std::vector<double> history(const std::string& path) const;
    /// The history at `time`, linear between samples.
    [[nodiscard]] double at(const std::string& path, double time) const;
    /// Mean of the samples with begin <= time <= end.
    [[nodiscard]] double mean(const std::string& path, double begin, double end) const;

private:
    std::filesystem::path directory_;
    int status_ = -1;
};

}  // namespace corpuscle::test
