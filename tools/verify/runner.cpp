// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <fstream>

#include "io/deck/deck_fingerprint.hpp"
#include "solver/base/error.hpp"
#include "tools/study/outcome.hpp"
#include "tools/study/workers.hpp"

namespace corpuscle::verify {
namespace {

namespace fs = std::filesystem;

/// FNV-1a of a file's bytes, eight at a time.
std::uint64_t fingerprint(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw SystemError(fmt::format("cannot read {}", file.string()));
    std::uint64_t sum = 14695981039346656037ULL;
    std::vector<std::uint64_t> block(1 << 16);
    while (in) {
        std::fill(block.begin(), block.end(), 0);
        in.read(reinterpret_cast<char*>(block.data()),
                static_cast<std::streamsize>(8 * block.size()));
        for (std::size_t i = 0; i < static_cast<std::size_t>(in.gcount() + 7) / 8; ++i)
            sum = (sum ^ block[i]) * 1099511628211ULL;
    }
    return sum;
}

/// "case_NP=2500", from the deck's name and the parameters.
std::string folder_name(const LevelCard& level) {
    std::string name = level.deck.stem().string();
    for (const auto& [key, value] : level.parameters) name += fmt::format("_{}={}", key, value);
    return name;
}

/// A level's seeds as a study of one point.
study::Study study_of(const Card& card, const LevelCard& level, const Plan& plan,
                      std::uint64_t program) {
    study::Study study;
    study.deck = fs::canonical(level.deck);
    study.deck_fingerprint = io::deck_fingerprint(level.deck) ^ program;
    study.folder = plan.folder / card.name / folder_name(level);
    study.repeats = level.seeds;
    study.fixed = level.parameters;
    return study;
}

Level read_level(const LevelCard& card, const study::Study& study) {
    Level level;
    level.card = &card;
    for (const study::Row& row : study::rows(study)) {
        const study::Outcome outcome = study::read_outcome(study, row);
        if (outcome.is_finished && outcome.status == 0) {
            level.runs.emplace_back(study::folder_of(study, row), card, outcome.cost.cpu_seconds);
        } else if (level.fault.empty()) {
            level.fault = outcome.is_finished
                              ? fmt::format("{} (status {}, {})", outcome.reason, outcome.status,
                                            study::folder_of(study, row).string())
                              : "a run is missing";
        }
    }
    return level;
}

/// One level of one case.
struct Entry {
    const Card* card;
    const LevelCard* level;
    study::Study study;
};

/// Long runs first: the finest levels, so that no core waits for one at the end.
std::vector<study::Job> missing_jobs(const std::deque<Entry>& entries) {
    std::vector<std::pair<double, study::Job>> jobs;
    for (const Entry& entry : entries)
        for (const study::Row& row : study::rows(entry.study)) {
            const study::Outcome outcome = study::read_outcome(entry.study, row);
            if (!outcome.is_finished || outcome.status != 0)
                jobs.push_back({entry.level->size, {&entry.study, row}});
        }
    std::stable_sort(jobs.begin(), jobs.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<study::Job> sorted;
    for (auto& [size, job] : jobs) sorted.push_back(job);
    return sorted;
}

}  // namespace

std::vector<Row> verify(const std::vector<Card>& cards, const Plan& plan,
                        const std::function<void(const std::string&)>& told) {
    const std::uint64_t program = fingerprint(plan.program);
    std::deque<Entry> entries;  // jobs point into it
    for (const Card& card : cards)
        for (const LevelCard& level : card.levels(plan.mode))
            entries.push_back({&card, &level, study_of(card, level, plan, program)});
    const std::vector<study::Job> jobs = missing_jobs(entries);
    std::size_t done = 0;
    study::make_jobs(
        jobs, plan.workers, plan.program.string(), [&](const study::Job& job, int status) {
            told(fmt::format("{} of {}: {}, seed {}: {}", ++done, jobs.size(),
                             fs::relative(job.study->folder, plan.folder).string(), job.row.seed,
                             status == 0 ? "normal" : fmt::format("failed ({})", status)));
        });
    std::vector<Row> rows;
    auto entry = entries.begin();
    for (const Card& card : cards) {
        std::vector<Level> levels;
        for ([[maybe_unused]] const LevelCard& level : card.levels(plan.mode)) {
            levels.push_back(read_level(*entry->level, entry->study));
            ++entry;
        }
        for (Row& row : judge(card, plan.mode, levels)) rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace corpuscle::verify
