// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: `corpuscle study --slurm` runs a study through a real Slurm, to the same table. The test
// starts a Slurm of its own; where it may not, or where slurm-wlm and munge are not installed, it
// says that it was skipped.

#include <catch2/catch.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/places.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

bool works(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

/// A Slurm that lives as long as this.
class PrivateSlurm {
public:
    explicit PrivateSlurm(fs::path folder) : folder_(std::move(folder)) {
        is_up_ = works(script("start"));
        ::setenv("SLURM_CONF", (folder_ / "slurm.conf").c_str(), 1);
    }
    ~PrivateSlurm() { works(script("stop")); }
    PrivateSlurm(const PrivateSlurm&) = delete;
    PrivateSlurm& operator=(const PrivateSlurm&) = delete;
    [[nodiscard]] bool is_up() const { return is_up_; }

private:
    [[nodiscard]] std::string script(const std::string& what) const {
        return CORPUSCLE_MODELS "/../tests/support/private_slurm.sh " + what + " " +
               folder_.string();
    }
    fs::path folder_;
    bool is_up_ = false;
};

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("a study goes through Slurm to the table that it makes alone", "[study]") {
    const bool is_installed = works(
        "command -v sbatch && command -v slurmctld && command -v slurmd && command -v munged");
    if (::geteuid() != 0 || !is_installed) {
        WARN("skipped: needs slurm-wlm and munge, and to be root");
        return;
    }
    const scene::Folder folder("study_slurm");
    fs::create_directories(folder.path);
    const PrivateSlurm slurm(folder.path / "slurm");
    REQUIRE(slurm.is_up());
    std::ofstream(folder.path / "s.toml")
        << "deck = \"" CORPUSCLE_MODELS
           "/vented_tank/vented_tank.k\"\nrepeats = 2\nworkers = 2\n"
           "until = 0.01\nresponses = [\"end:/history/airbag/1/mass\"]\n"
           "[fixed]\nNP = 300\n[factors]\nC23 = [0.5, 1.0]\n";
    const std::string study =
        std::string(CORPUSCLE_PROGRAM) + " study " + (folder.path / "s.toml").string() + " -o ";
    REQUIRE(works(study + (folder.path / "by_slurm").string() + " --slurm"));
    REQUIRE(works(study + (folder.path / "alone").string()));
    for (int k = 0; k < 120 && !fs::exists(folder.path / "by_slurm" / "study.h5"); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(500));

    // all but the wall time
    const auto rows = [&](const char* name) {
        std::stringstream csv(text_of(folder.path / name / "study.csv"));
        std::vector<std::string> all;
        for (std::string line; std::getline(csv, line);) {
            std::size_t at = 0;
            for (int comma = 0; comma < 5 && at != std::string::npos; ++comma)
                at = line.find(',', at + 1);
            REQUIRE(at != std::string::npos);
            all.push_back(line.substr(0, at) +
                          line.substr(std::min(line.find(',', at + 1), line.size())));
        }
        return all;
    };
    CHECK(rows("by_slurm").size() == 5);
    CHECK(rows("by_slurm") == rows("alone"));
    CHECK(rows("by_slurm")[4].starts_with("4,2,1,2,normal"));
}
