// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// A study: one deck run at many points, several seeds a point, into one table.
namespace corpuscle::study {

/// A -D value that varies: listed values, or a range.
struct Factor {
    std::string name;
    std::vector<double> values;   ///< in a list, or `count` evenly over the range
    double from = 0.0, to = 0.0;  ///< of a range
    bool is_range = false;
    bool is_mesh = false;  ///< chooses the deck, and is no -D value
    double order = NaN;    ///< k of error = C value^-k; < 0: it falls with the value
};

enum class Plan { FULL, LATIN, POINTS, STAR };

/// A deck that is run in place of others, by the value of the factor MESH.
struct Mesh {
    std::filesystem::path deck;
    std::uint64_t fingerprint = 0;
    double size = 0.0;  ///< number of elements
};

struct Study {
    std::filesystem::path file, deck, folder;
    std::uint64_t deck_fingerprint = 0;  ///< of the deck's text and of all that it includes
    std::vector<Mesh> meshes;            ///< empty, or decks in place of `deck`, the first of them
    Plan plan = Plan::FULL;
    int samples = 0;              ///< points of a Latin hypercube
    std::uint64_t plan_seed = 1;  ///< of a Latin hypercube
    int repeats = 1;              ///< runs a point, with seeds first_seed, first_seed + 1, ...
    std::uint64_t first_seed = 1;
    int workers = 1;            ///< runs at a time
    int threads = 1;            ///< of each
    bool says_workers = false;  ///< or they are a default
    bool says_threads = false;  ///< likewise
    std::optional<double> until;
    std::vector<std::string> responses;
    std::vector<std::pair<std::string, double>> fixed;
    std::vector<Factor> factors;
    std::vector<std::vector<double>> listed;  ///< points of a CSV, by factor
};

/// @throws InputError with every fault: file:line: [table] key = value, expected ...
[[nodiscard]] Study read_study(const std::filesystem::path& file);

/// The values of the factors, point by point. FULL: the last factor varies fastest. LATIN: of
/// `samples` equal shares of each factor's range every one is met once. STAR: all factors at their
/// first value, then each at its others alone.
[[nodiscard]] std::vector<std::vector<double>> points(const Study& study);

/// A run.
struct Row {
    std::size_t number = 0;  ///< from 1
    std::size_t point = 0;   ///< from 0
    std::vector<double> values;
    std::uint64_t seed = 1;
};
[[nodiscard]] std::vector<Row> rows(const Study& study);

}  // namespace corpuscle::study
