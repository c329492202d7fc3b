// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gas/cards/collision_model.hpp"
#include "io/deck/deck_fingerprint.hpp"
#include "io/deck/deck_places.hpp"
#include "io/deck/faults.hpp"
#include "io/deck/keyword_reader.hpp"
#include "io/deck/parameters.hpp"
#include "io/keywords/mesh/coordinates.hpp"
#include "io/keywords/tasks.hpp"
#include "io/model/draft.hpp"
#include "io/model/file_places.hpp"
#include "io/model/loose_ends.hpp"
#include "io/model/numbering.hpp"
#include "io/model/solid_skin.hpp"
#include "io/text/text.hpp"
#include "io/text/units.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {

namespace {

using keywords::Task;

/// Of a *PARAMETER of any type; NaN where its characters are none.
double parameter_number(const Parameter& parameter) {
    if (parameter.type != 'C') return parameter.value.number;
    return parse_real(trim(parameter.text)).value_or(NaN);
}

/// DIALECT, by -D or by *PARAMETER: 2007 for the cards of the course notes.
Dialect dialect(Parameters& parameters, Faults& faults) {
    const Place deck{0, 1};
    double year = 0.0;
    if (const Parameter* p = parameters.find("DIALECT", {}))
        year = parameter_number(*p);
    else if (const auto text = parameters.take_override("DIALECT"))
        year = parse_real(*text).value_or(NaN);
    if (year == 2007.0) return Dialect::NOTES_2007;
    if (year != 0.0) faults.fault(deck, "DIALECT, expected 2007, or 0 for today's cards");
    return Dialect::TODAY;
}

/// COLLISION, by -D or by *PARAMETER (type C): the collision model of all bags.
std::optional<gas::CollisionModel> collision(Parameters& parameters, Faults& faults) {
    std::optional<std::string> name = parameters.take_override("COLLISION");
    if (const Parameter* p = parameters.find("COLLISION", {}); !name && p != nullptr)
        name = p->text;
    if (!name) return {};
    const auto model = gas::collision_model(trim(*name));
    if (!model)
        faults.fault(Place{0, 1}, fmt::format("COLLISION = {}, expected one of {}", *name,
                                              gas::collision_names()));
    return model;
}

/// MEAN_FREE_PATH, by -D or by *PARAMETER: of a collision model that has one.               [m]
double mean_free_path(const std::optional<gas::CollisionModel>& model, Parameters& parameters,
                      Faults& faults) {
    double path = NaN;
    if (const Parameter* p = parameters.find("MEAN_FREE_PATH", {}))
        path = parameter_number(*p);
    else if (const auto text = parameters.take_override("MEAN_FREE_PATH"))
        path = parse_real(*text).value_or(-1.0);
    else
        return path;
    if (!(path > 0.0))
        faults.fault(Place{0, 1}, "MEAN_FREE_PATH, expected a length > 0");
    else if (!model || !gas::has_mean_free_path(*model))
        faults.fault(Place{0, 1},
                     "MEAN_FREE_PATH is set, expected COLLISION = ntc or spheres, the "
                     "models that have one");
    return path;
}

/// CLOSE, by -D or by *PARAMETER: no, yes, or the share of a bag's area up to which lids close it.
void closing(Parameters& parameters, Faults& faults, Model& model) {
    std::optional<std::string> text = parameters.take_override("CLOSE");
    if (const Parameter* p = parameters.find("CLOSE", {}); !text && p != nullptr)
        text = p->type == 'C' ? p->text : fmt::format("{}", p->value.number);
    if (!text) return;
    const std::string word = upper(trim(*text));
    const auto share = parse_real(word);
    if (word == "NO") {
        model.closes_bags = false;
    } else if (share && *share >= 0.0 && *share <= 1.0) {
        model.lid_share = *share;
    } else if (word != "YES") {
        faults.fault(Place{0, 1}, fmt::format("CLOSE = {}, expected no, yes, or the share of a "
                                              "bag's area that a lid may close, 0 to 1",
                                              *text));
    }
}

/// UNITS, by -D or by *PARAMETER (type C): of a deck without *AIRBAG_PARTICLE.
std::string units(Parameters& parameters, Faults& faults) {
    std::optional<std::string> text = parameters.take_override("UNITS");
    if (const Parameter* p = parameters.find("UNITS", {}); !text && p != nullptr) text = p->text;
    if (!text) return {};
    if (const std::string_view system = unit_system_named(*text); !system.empty())
        return std::string(system);
    faults.fault(Place{0, 1}, fmt::format("UNITS = {}, expected {}", *text, unit_systems()));
    return {};
}

/// The system in which density and modulus of the first fabric are those of cloth, if one alone is:
/// 200 to 3000 kg/m^3 and 1 MPa to 100 GPa.
std::string guessed_units(const Model& model) {
    for (const fabric::Material& material : model.materials) {
        const auto* cloth = std::get_if<fabric::FabricCard>(&material.card);
        if (cloth == nullptr || !(cloth->density > 0.0)) continue;
        std::vector<std::string_view> fitting;
        for (const std::string_view name : unit_system_names()) {
            const UnitScale unit = *scale_of(name);
            const double density = cloth->density * unit.kilogram / std::pow(unit.metre, 3.0),
                         E = cloth->E_warp * unit.kilogram /
                             (unit.metre * unit.second * unit.second);
            if (density > 200.0 && density < 3000.0 && E > 1e6 && E < 1e11) fitting.push_back(name);
        }
        return fitting.size() == 1 ? std::string(fitting[0]) : std::string();
    }
    return {};
}

/// Those of *AIRBAG_PARTICLE, else as said, else as guessed.
void settle_units(const std::string& said, Model& model, Faults& faults) {
    if (!model.bags.empty()) {
        if (!said.empty() && said != model.unit_system)
            faults.fault(Place{0, 1}, fmt::format("UNITS = {}, expected {}, as UNIT of "
                                                  "*AIRBAG_PARTICLE has it",
                                                  said, model.unit_system));
        return;
    }
    if (!said.empty()) {
        model.unit_system = said;
        return;
    }
    const std::string guess = guessed_units(model);
    if (guess.empty()) {
        model.notes.push_back(fmt::format(
            "units are not known, numbers are told as the deck has them (-D UNITS={} says them)",
            unit_systems()));
        return;
    }
    model.unit_system = guess;
    model.notes.push_back(
        fmt::format("units are taken as {}, from density and modulus of the "
                    "fabric (-D UNITS={} says them)",
                    guess, unit_systems()));
}

/// What -D and *PARAMETER say of the whole deck, but for its units.
void take_settings(Parameters& parameters, Faults& faults, Draft& draft) {
    draft.dialect = dialect(parameters, faults);
    draft.collision = collision(parameters, faults);
    draft.mean_free_path = mean_free_path(draft.collision, parameters, faults);
    closing(parameters, faults, draft.model);
}

/// By Numbered::Kind, how many the model has.
std::array<std::size_t, 4> counts_of_numbered(const Model& model) {
    return {model.bags.size(), model.uniform_bags.size(), model.contacts.size(),
            model.walls.size()};
}

void read_block(Task& task, const Parameters& parameters, Faults& faults, Draft& draft) {
    const auto before = counts_of_numbered(draft.model);
    faults.begin_block();
    if (faults.log() != nullptr) faults.log()->begin(task.match.name);
    Cards cards(*task.block, faults, parameters, std::move(task.match.suffixes));
    task.match.keyword->read(cards, draft);
    cards.finish();
    faults.end_block(task.block->place, task.block->keyword);
    const auto after = counts_of_numbered(draft.model);
    for (std::size_t kind = 0; kind < after.size(); ++kind)
        for (std::size_t row = before[kind]; row < after[kind]; ++row)
            draft.numbered.push_back(
                {static_cast<Numbered::Kind>(kind), row, task.block->place, task.block->keyword});
}

/// What no single keyword can see.
void check_whole(Draft& draft, const DeckText& text, Faults& faults) {
    Model& model = draft.model;
    const bool has_termination =
        std::any_of(text.blocks.begin(), text.blocks.end(),
                    [](const Block& b) { return b.keyword == "CONTROL_TERMINATION"; });
    if (!has_termination)
        faults.fault(text.end, "*CONTROL_TERMINATION is missing, expected ENDTIM > 0");
    if (model.shells.empty()) faults.fault(text.end, "*ELEMENT_SHELL is missing, expected a mesh");
    if (draft.frame_count > 0)  // goes before DT
        model.output.frames = model.end_time / draft.frame_count;
    auto& history = model.history_nodes;
    std::sort(history.begin(), history.end());
    history.erase(std::unique(history.begin(), history.end()), history.end());
    model.velocity.resize(model.x.size(), Vec3::Zero());
}

}  // namespace

Model read_deck(const std::filesystem::path& file, const DeckOptions& options, DeckPlaces* places) {
    DeckPlaces unused;
    DeckPlaces& learnt = places != nullptr ? *places : unused;
    Faults faults;
    faults.keep_log(options.log);
    Parameters parameters(options.overrides);
    DeckText text = read_keywords(file, parameters, faults);
    Model model;
    model.deck = file.string();
    model.unit_system = "consistent";
    Draft draft(model);
    draft.until = options.until;
    take_settings(parameters, faults, draft);
    const std::string said_units = units(parameters, faults);
    model.fingerprint = scene_fingerprint(text, parameters);
    std::vector<Task> tasks = keywords::sort_out(text, parameters, faults, draft);
    const auto scene = std::find_if(tasks.begin(), tasks.end(), [](const Task& task) {
        return task.match.keyword->phase > keywords::Phase::SHELL;
    });
    const auto ground = std::find_if(tasks.begin(), scene, [](const Task& task) {
        return task.match.keyword->phase > keywords::Phase::TRANSFORMATION;
    });
    const auto relations = std::find_if(scene, tasks.end(), [](const Task& task) {
        return task.match.keyword->phase == keywords::Phase::RELATION;
    });
    const auto read = [&](auto from, auto to) {
        for (auto task = from; task != to; ++task) read_block(*task, parameters, faults, draft);
    };
    read(tasks.begin(), ground);
    place_files(text, parameters, faults, draft);
    read(ground, scene);
    check_parts(draft, faults);
    if (!faults.any()) make_skins(draft);  // sets and all that follows know them as shells
    if (!faults.any()) make_beam_bodies(draft, faults);
    read(scene, relations);
    number_things(draft, learnt);
    keywords::note_bags(draft);
    read(relations, tasks.end());
    if (!text.is_incomplete) check_whole(draft, text, faults);
    if (!faults.any()) settle_loose_ends(draft, faults);

    settle_units(said_units, model, faults);

    std::vector<std::string> all = parameters.unused_overrides();
    for (std::string& fault : faults.faults()) all.push_back(std::move(fault));
    if (!all.empty()) throw InputError(std::move(all));
    for (const RigidVelocity& start : draft.inertia_start)
        if (std::none_of(model.rigid_velocity.begin(), model.rigid_velocity.end(),
                         [&](const RigidVelocity& own) { return own.part == start.part; }))
            model.rigid_velocity.push_back(start);
    keywords::place_local_axes(draft);
    model.warnings = faults.warnings();
    for (std::string& note : faults.notes()) model.notes.push_back(std::move(note));
    learnt.add("shell", std::move(draft.shells));
    learnt.add("part", std::move(draft.parts));
    learnt.add("material", std::move(draft.materials));
    learnt.add("node", std::move(draft.nodes));
    learnt.take(std::move(faults));
    return model;
}

}  // namespace corpuscle::io
