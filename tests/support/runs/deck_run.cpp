// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/runs/deck_run.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "io/results/hdf5.hpp"
#include "solver/base/curve.hpp"
#include "tests/places.hpp"

namespace corpuscle::test {

DeckFile::DeckFile(const std::string& name, const std::string& deck) {
    if (const char* kept = std::getenv("CORPUSCLE_DECKS")) {
        stays_ = true;
        directory_ = std::filesystem::path(kept) / name;
        std::filesystem::create_directories(directory_);
    } else {
        std::string pattern = std::filesystem::temp_directory_path() / (name + ".XXXXXX");
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no directory " + pattern);
        directory_ = pattern;
    }
    std::ofstream(path()) << deck;
}

DeckFile::~DeckFile() {
    if (stays_) return;
    std::error_code ignored;  // a directory left behind harms nobody
    std::filesystem::remove_all(directory_, ignored);
}

DeckRun::DeckRun(const std::string& name, const std::string& deck, const std::string& options)
    : deck_(name, deck) {
    const std::string log = (deck_.directory() / "log").string();
    const std::string command = "timeout -k 10 900 " CORPUSCLE_PROGRAM " run '" +
                                deck_.path().string() + "' -o '" + deck_.directory().string() +
                                "' -j 1 " + options + " >'" + log + "' 2>&1";
    const int ended = std::system(command.c_str());
    status_ = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    if (status_ != 0) std::system(("cat '" + log + "'").c_str());
}

bool DeckRun::has(const std::string& path) const {
    return io::Hdf5Reader(results()).has(path);
}

std::vector<double> DeckRun::read(const std::string& path) const {
    return io::Hdf5Reader(results()).read<double>(path);
}

double DeckRun::at(const std::string& path, double time) const {
    Curve curve;
    curve.x = this->time();
    curve.y = read(path);
    return curve(time);
}

}  // namespace corpuscle::test
