// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/study/study.hpp"

namespace corpuscle::study_test {

namespace fs = std::filesystem;

/// A folder with a deck and a study in it.
struct Desk {
    scene::Folder folder;
    explicit Desk(const std::string& name) : folder("study_" + name) {
        fs::create_directories(folder.path);
        put("bag.k", "*KEYWORD\n*END\n");
    }
    void put(const std::string& name, const std::string& text) const {
        std::ofstream(folder.path / name) << text;
    }
    [[nodiscard]] study::Study study(const std::string& text) const {
        put("s.toml", text);
        study::Study s = study::read_study(folder.path / "s.toml");
        s.folder = folder.path / "out";
        return s;
    }
    [[nodiscard]] std::vector<std::string> faults(const std::string& text) const {
        try {
            (void)study(text);
        } catch (const InputError& error) {
            return error.faults;
        }
        return {};
    }
    /// A program in corpuscle's place: shell text that sees the run's words.
    [[nodiscard]] std::string program(const std::string& text) const {
        put("program.sh", "#!/bin/sh\n" + text);
        fs::permissions(folder.path / "program.sh", fs::perms::owner_all);
        return (folder.path / "program.sh").string();
    }
};

}  // namespace corpuscle::study_test
