// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// fuzz [--target NAME] [--cases N] [--first I] [--keep DIR]: gives damaged files to what reads
// them, and prints counts by outcome. Case I of a target is the same wherever it is run.

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <ctime>
#include <fstream>

#include "io/system/confined.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/places.hpp"

using namespace corpuscle;
using namespace corpuscle::fuzz;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t SEED = 2007;
constexpr std::uint64_t BATCH = 100;  ///< cases a process; of one that fails each gets its own

std::string case_of(const Target& target, std::uint64_t number) {
    Random draw(SEED, Stream::INITIAL, 0, number);
    const auto pick = [&] {
        return target.seeds[draw.below(static_cast<std::uint32_t>(target.seeds.size()))];
    };
    const std::string seed = pick();
    return target.is_text ? damaged_text(seed, pick(), draw) : damaged_bytes(seed, draw);
}

char read_case(const Target& target, const fs::path& file) {
    try {
        target.read(file);
        return static_cast<char>(Outcome::TAKEN);
    } catch (const InputError& error) {
        if (error.faults.empty()) throw;
        return static_cast<char>(Outcome::REFUSED);
    } catch (const PhysicsError&) {
        return static_cast<char>(Outcome::STOPPED);
    } catch (const SystemError&) {
        return static_cast<char>(Outcome::DAMAGED);
    }
}

/// Tells of a case that takes more than `slow` seconds of a processor.
char outcome_of(const Target& target, std::uint64_t number, const fs::path& file, double slow) {
    std::ofstream(file, std::ios::binary) << case_of(target, number);
    const std::clock_t begin = std::clock();
    const char outcome = read_case(target, file);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (seconds > slow) {
        fmt::print("{} case {}: {:.2f} s\n", target.name, number, seconds);
        std::fflush(stdout);
    }
    return outcome;
}

struct Counts {
    std::uint64_t taken = 0, refused = 0, stopped = 0, damaged = 0, failed = 0;

    void add(const std::vector<char>& outcomes) {
        for (const char outcome : outcomes) {
            taken += outcome == static_cast<char>(Outcome::TAKEN);
            refused += outcome == static_cast<char>(Outcome::REFUSED);
            stopped += outcome == static_cast<char>(Outcome::STOPPED);
            damaged += outcome == static_cast<char>(Outcome::DAMAGED);
        }
    }
};

io::Confined run(const Target& target, std::uint64_t begin, std::uint64_t end, const fs::path& file,
                 double slow, int seconds) {
    std::fflush(stdout);  // or the child prints it once more
    return io::confined(
        [&] {
            std::vector<char> outcomes;
            for (std::uint64_t i = begin; i < end; ++i)
                outcomes.push_back(outcome_of(target, i, file, slow));
            return outcomes;
        },
        {.seconds = seconds});
}

Counts run_all(const Target& target, std::uint64_t first, std::uint64_t cases, const fs::path& work,
               const fs::path& keep, double slow) {
    constexpr int SECONDS_A_CASE = 20;
    Counts counts;
    const fs::path file = work / target.file;
    for (std::uint64_t at = first; at < first + cases; at += BATCH) {
        const std::uint64_t end = std::min(at + BATCH, first + cases);
        const io::Confined batch = run(target, at, end, file, slow, 60);
        if (batch.bytes) counts.add(*batch.bytes);
        for (std::uint64_t i = at; i < end && !batch.bytes; ++i) {
            const io::Confined one = run(target, i, i + 1, file, slow, SECONDS_A_CASE);
            if (one.bytes) {
                counts.add(*one.bytes);
                continue;
            }
            ++counts.failed;
            fmt::print("{} case {}: {}\n", target.name, i, one.failure);
            if (keep.empty()) continue;
            fs::create_directories(keep);
            std::ofstream(keep / fmt::format("{}_{}{}", target.name, i, file.extension().string()),
                          std::ios::binary)
                << case_of(target, i);
        }
    }
    return counts;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Damaged files for what reads them, with counts by outcome"};
    std::string only, keep;
    std::uint64_t cases = 1000, first = 0;
    double slow = INF;
    app.add_option("--target", only, "deck, recipe, study, ply, obj, stl, results or checkpoint");
    app.add_option("--cases", cases, "of each target")->capture_default_str();
    app.add_option("--first", first, "number of the first case")->capture_default_str();
    app.add_option("--keep", keep, "folder for files of cases that fail");
    app.add_option("--slow", slow, "seconds of a processor beyond which a case is told");
    CLI11_PARSE(app, argc, argv);

    std::string pattern = fs::temp_directory_path() / "fuzz.XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) return 1;
    const fs::path work = pattern;
    bool is_good = true;
    fmt::print("{:<12}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "target", "cases", "taken",
               "refused", "stopped", "damaged", "failed");
    for (const Target& target : all_targets(CORPUSCLE_MODELS, CORPUSCLE_DECKS, work)) {
        if (!only.empty() && target.name != only) continue;
        const Counts n = run_all(target, first, cases, work, keep, slow);
        fmt::print("{:<12}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", target.name, cases, n.taken,
                   n.refused, n.stopped, n.damaged, n.failed);
        std::fflush(stdout);
        is_good = is_good && n.taken + n.refused + n.stopped + n.damaged == cases;
    }
    fs::remove_all(work);
    return is_good ? 0 : 1;
}
