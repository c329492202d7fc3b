// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::test {

/// One run of the program on a deck that a test writes, in a directory of its own that goes when
/// this does. With CORPUSCLE_DECKS=DIR in the environment deck and results stay, as DIR/NAME/deck.k
/// and DIR/NAME/results.h5, to be run by hand: corpuscle run DIR/NAME/deck.k
class DeckRun {
public:
    /// @param name     of the case, one word
    /// @param deck     text of the deck
    /// @param options  of `corpuscle run`, e.g. "--seed 3"
    DeckRun(const std::string& name, const std::string& deck, const std::string& options = "");
    ~DeckRun();
    DeckRun(const DeckRun&) = delete;
    DeckRun& operator=(const DeckRun&) = delete;

    [[nodiscard]] int status() const {
        return status_;
    }  ///< the program's exit status; 124: it has not come to its end in 15 minutes
    [[nodiscard]] std::filesystem::path results() const { return directory_ / "results.h5"; }
    [[nodiscard]] std::filesystem::path deck() const { return directory_ / "deck.k"; }
    /// Whether results.h5 has a dataset.
    [[nodiscard]] bool has(const std::string& path) const;

    /// All numbers of a dataset, row after row.
    [[nodiscard]] std::vector<double> read(const std::string& path) const;
    [[nodiscard]] std::vector<double> time() const { return read("/history/time"); }
    /// A history at `time`, linear between samples.
    [[nodiscard]] double at(const std::string& path, double time) const;

private:
    std::filesystem::path directory_;
    bool stays_ = false;
    int status_ = -1;
};

}  // namespace corpuscle::test
