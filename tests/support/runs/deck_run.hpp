// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::test {

/// A deck that a test writes, in a directory of its own that goes when this does. With
/// CORPUSCLE_DECKS=DIR in the environment it stays, as DIR/NAME/deck.k, results beside it, to be
/// run by hand: corpuscle run DIR/NAME/deck.k
class DeckFile {
public:
    /// @param name  of the case, one word
    /// @param deck  its text
    DeckFile(const std::string& name, const std::string& deck);
    ~DeckFile();
    DeckFile(const DeckFile&) = delete;
    DeckFile& operator=(const DeckFile&) = delete;

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] std::filesystem::path path() const { return directory_ / "deck.k"; }

private:
    std::filesystem::path directory_;
    bool stays_ = false;
};

/// One run of the program on such a deck.
class DeckRun {
public:
    /// @param options  of `corpuscle run`, e.g. "--seed 3"
    DeckRun(const std::string& name, const std::string& deck, const std::string& options = "");

    /// The program's exit status; 124: it has not come to its end in 15 minutes.
    [[nodiscard]] int status() const { return status_; }
    [[nodiscard]] std::filesystem::path results() const { return deck_.directory() / "results.h5"; }
    /// Whether results.h5 has a dataset.
    [[nodiscard]] bool has(const std::string& path) const;

    /// All numbers of a dataset, row after row.
    [[nodiscard]] std::vector<double> read(const std::string& path) const;
    [[nodiscard]] std::vector<double> time() const { return read("/history/time"); }
    /// A history at `time`, linear between samples.
    [[nodiscard]] double at(const std::string& path, double time) const;

private:
    DeckFile deck_;
    int status_ = -1;
};

}  // namespace corpuscle::test
