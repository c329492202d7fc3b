// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/known_names.hpp"

#include <fmt/format.h>

#include "io/deck_parameters.hpp"
#include "solver/base/error.hpp"
#include "tools/study/history_response.hpp"
#include "tools/study/outcome.hpp"

namespace corpuscle::study {
namespace {

void look_into(const std::filesystem::path& deck, const Study& study,
               std::vector<std::string>& faults) {
    const io::DeckParameters known = io::read_deck_parameters(deck);
    if (!known.is_whole) return;  // its runs say why
    const auto expect = [&](const char* table, const std::string& name) {
        if (known.has(name)) return;
        faults.push_back(fmt::format("{}: [{}] {}, expected a *PARAMETER of {}: {}",
                                     study.file.string(), table, name, deck.filename().string(),
                                     known.of_deck.empty()
                                         ? "it has none"
                                         : fmt::format("{}", fmt::join(known.of_deck, ", "))));
    };
    for (const Factor& factor : study.factors)
        if (!factor.is_mesh) expect("factors", factor.name);
    for (const auto& [name, value] : study.fixed) expect("fixed", name);
}

}  // namespace

void expect_known_names(const Study& study) {
    std::vector<std::string> faults;
    if (study.meshes.empty()) look_into(study.deck, study, faults);
    for (const Mesh& mesh : study.meshes) look_into(mesh.deck, study, faults);
    for (const std::string& response : study.responses) {
        if (!has_form_of_response(response))
            faults.push_back(fmt::format(
                "{}: responses = {}, expected BODY.RESPONSE, as 100.hic15, or max:, min: "
                "or end: and a history",
                study.file.string(), response));
        const auto history = history_response(response);
        if (const std::string why = history ? wrong_part(*history) : ""; !why.empty())
            faults.push_back(
                fmt::format("{}: responses = {}: {}", study.file.string(), response, why));
    }
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace corpuscle::study
