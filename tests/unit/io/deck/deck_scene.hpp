// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/deck.hpp"
#include "solver/base/error.hpp"
#include "solver/simulation.hpp"

/// Decks written for one test, in a folder of their own.
namespace corpuscle::test {

class DeckFolder {
public:
    DeckFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("corpuscle_deck_" + std::to_string(getpid()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~DeckFolder() { std::filesystem::remove_all(path_); }
    DeckFolder(const DeckFolder&) = delete;
    DeckFolder& operator=(const DeckFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

    Model read(const std::string& text, const io::DeckOptions& options = {}) const {
        return io::read_deck(write("deck.k", text), options);
    }

    /// Messages without the folder's name; empty when the deck is good.
    std::vector<std::string> faults(const std::string& text,
                                    const io::DeckOptions& options = {}) const {
        try {
            read(text, options);
        } catch (const InputError& error) {
            std::vector<std::string> plain;
            for (const std::string& fault : error.faults) plain.push_back(bare(fault));
            return plain;
        }
        return {};
    }

    [[nodiscard]] std::string bare(std::string text) const {
        const std::string folder = path_.string() + "/";
        for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
            text.erase(at, folder.size());
        return text;
    }

private:
    std::filesystem::path path_;
};

/// Two triangles and a quad of two parts in the plane z = 0, fabric, to time 1: a deck that is
/// complete.
inline const std::string SMALL_MESH = R"(*KEYWORD
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
*ELEMENT_SHELL
11,1,1,2,3,3
12,1,1,3,4,4
13,2,2,5,6,3
*PART
cloth
1,1,1
*PART
more cloth
2,1,1
*SECTION_SHELL
1,5
0.3
*MAT_ELASTIC
1,700.,1.e8,0.3
*CONTROL_TERMINATION
1.0
*DEFINE_CURVE
7
0,1
1,3
)";

/// Part 3, rigid, beside the small mesh.
inline const std::string RIGID_TRIANGLE =
    "*PART\nplate\n3,1,2\n*MAT_RIGID\n2,1000.,1.e9,0.3\n\n\n"
    "*NODE\n21,5,0,0\n22,6,0,0\n23,5,1,0\n*ELEMENT_SHELL\n91,3,21,22,23,23\n";

/// With lines behind it.
inline std::string small_deck(const std::string& more = "") {
    return SMALL_MESH + more + "*END\n";
}

/// The model of a small deck with `more` behind it.
inline Model read_small(const std::string& more) {
    const DeckFolder folder;
    return folder.read(small_deck(more));
}

/// What rigid parts start with: what the deck says, or what their nodes have.
inline std::vector<RigidVelocity> starts_of(const Model& model) {
    return Simulation(model).model().rigid_velocity;
}

/// The one fault of a small deck with `more` behind it.
inline std::string only_fault(const std::string& more) {
    const DeckFolder folder;
    const auto faults = folder.faults(small_deck(more));
    REQUIRE(faults.size() == 1);
    return faults[0];
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
    for (const std::string& text : texts)
        if (contains(text, part)) return true;
    return false;
}

}  // namespace corpuscle::test
