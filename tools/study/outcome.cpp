// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "io/responses/body_responses.hpp"
#include "io/results/hdf5.hpp"
#include "io/system/atomic_file.hpp"
#include "io/text/text.hpp"
#include "io/text/units.hpp"
#include "solver/base/error.hpp"
#include "solver/base/vec.hpp"
#include "tools/study/history_response.hpp"

namespace corpuscle::study {
namespace {

namespace fs = std::filesystem;

bool is_response(const std::string& name) {
    const io::BodyMotion at_rest{
        0, 1.0, 1.0, {Vec3::Zero()}, {Vec3::Zero()}, {Vec3::Zero()}, {Vec3::Zero()}};
    const std::vector<io::Response> all = io::body_responses(at_rest, "SI");
    return std::any_of(all.begin(), all.end(),
                       [&](const io::Response& response) { return response.name == name; });
}

struct Value {
    double number;
    std::string unit;
};

/// Of a history, or "PID.NAME". @throws SystemError where the results have no such thing
Value find(const io::Hdf5Reader& results, const std::string& response) {
    if (const auto history = history_response(response)) {
        const double value = value_of(*history, results);
        const auto [factor, unit] =
            io::spoken(results.text(history->path, "unit"), results.text("/", "unit_system"));
        return {factor * value, unit};
    }
    std::string path = "/responses/" + response;
    std::replace(path.begin(), path.end(), '.', '/');
    // a body that met nothing has no time to contact: that is an answer
    const bool is_known = results.has(path.substr(0, path.rfind('/'))) &&
                          is_response(response.substr(response.find('.') + 1));
    if (!results.has(path) && is_known) return {NaN, ""};
    if (!results.has(path)) throw SystemError(fmt::format("no response {}", response));
    return {results.read<double>(path).at(0), results.text(path, "unit")};
}

void read_responses(const Study& study, const fs::path& folder, Outcome& outcome) {
    try {
        const io::Hdf5Reader results(folder / "results.h5");
        for (std::size_t r = 0; r < study.responses.size(); ++r) {
            try {
                const Value value = find(results, study.responses[r]);
                outcome.responses[r] = value.number;
                outcome.units[r] = value.unit;
            } catch (const SystemError& why) {
                outcome.reason = why.what();
            }
        }
    } catch (const SystemError& why) {
        outcome.reason = why.what();
    }
    if (!outcome.reason.empty()) outcome.status = 1;
}

/// The mesh of a row; null where the study has one deck.
const Mesh* mesh_of(const Study& study, const Row& row) {
    for (std::size_t f = 0; f < study.factors.size(); ++f)
        if (study.factors[f].is_mesh)
            for (const Mesh& mesh : study.meshes)
                if (mesh.size == row.values[f]) return &mesh;
    return nullptr;
}

}  // namespace

fs::path deck_of(const Study& study, const Row& row) {
    const Mesh* const mesh = mesh_of(study, row);
    return mesh != nullptr ? mesh->deck : study.deck;
}

fs::path folder_of(const Study& study, const Row& row) {
    return study.folder / fmt::format("run_{:04}", row.number);
}

std::vector<std::string> definitions_of(const Study& study, const Row& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : study.fixed) all.push_back(fmt::format("{}={}", name, value));
    for (std::size_t f = 0; f < study.factors.size(); ++f)
        if (!study.factors[f].is_mesh)
            all.push_back(fmt::format("{}={}", study.factors[f].name, row.values[f]));
    return all;
}

std::string key_of(const Study& study, const Row& row) {
    const Mesh* const mesh = mesh_of(study, row);
    return fmt::format("deck {} {:016x}, {}, seed {}, until {}",
                       deck_of(study, row).filename().string(),
                       mesh != nullptr ? mesh->fingerprint : study.deck_fingerprint,
                       fmt::join(definitions_of(study, row), " "), row.seed,
                       study.until ? fmt::format("{}", *study.until) : "its end");
}

bool has_form_of_response(const std::string& response) {
    if (history_response(response)) return true;
    const std::size_t dot = std::min(response.find('.'), response.size());
    return io::parse_integer(response.substr(0, dot)).has_value() && dot < response.size() &&
           is_response(response.substr(dot + 1));
}

void write_status(const Study& study, const Row& row, int status, const Cost& cost,
                  const std::string& reason) {
    io::replace_text(folder_of(study, row) / "status",
                     fmt::format("{}\n{}\n{:.3f}\n{}\n{:.3f}\n", key_of(study, row), status,
                                 cost.seconds, reason, cost.cpu_seconds));
}

Outcome read_outcome(const Study& study, const Row& row) {
    Outcome outcome;
    outcome.responses.assign(study.responses.size(), NaN);
    outcome.units.resize(study.responses.size());
    std::ifstream in(folder_of(study, row) / "status");
    std::string key, status, seconds;
    if (!std::getline(in, key) || !std::getline(in, status) || !std::getline(in, seconds) ||
        key != key_of(study, row))
        return outcome;
    std::string cpu;
    std::getline(in, outcome.reason);
    std::getline(in, cpu);
    const auto code = io::parse_integer(status);
    const auto wall = io::parse_real(seconds);
    if (!code || !wall) return outcome;
    outcome.is_finished = true;
    outcome.status = *code;
    outcome.cost = {*wall, io::parse_real(cpu).value_or(NaN)};
    if (outcome.status == 0) read_responses(study, folder_of(study, row), outcome);
    return outcome;
}

}  // namespace corpuscle::study
