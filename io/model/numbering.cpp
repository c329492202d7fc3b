// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/numbering.hpp"

#include <initializer_list>
#include <unordered_set>

namespace corpuscle::io {
namespace {

using NumberedKind = Numbered::Kind;

int& open_number(Model& model, const Numbered& thing) {
    switch (thing.kind) {
        case NumberedKind::PARTICLE_BAG:
            return model.bags[thing.row].id;
        case NumberedKind::UNIFORM_BAG:
            return model.uniform_bags[thing.row].id;
        case NumberedKind::CONTACT:
            return model.contacts[thing.row].id;
        case NumberedKind::WALL:
            break;
    }
    return model.walls[thing.row].id;
}

/// Those of kinds that share their numbers.
void number_kinds(std::initializer_list<NumberedKind> kinds, Draft& draft) {
    std::vector<int*> numbers;
    for (const Numbered& thing : draft.numbered)
        for (const NumberedKind kind : kinds)
            if (thing.kind == kind) numbers.push_back(&open_number(draft.model, thing));
    std::unordered_set<int> taken;
    for (const int* number : numbers) taken.insert(*number);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (*numbers[i] != 0) continue;
        int next = static_cast<int>(i) + 1;
        while (taken.contains(next)) ++next;
        taken.insert(*numbers[i] = next);
    }
}

}  // namespace

void number_things(Draft& draft, DeckPlaces& places) {
    number_kinds({NumberedKind::PARTICLE_BAG, NumberedKind::UNIFORM_BAG}, draft);
    number_kinds({NumberedKind::CONTACT}, draft);
    number_kinds({NumberedKind::WALL}, draft);
    for (const Numbered& thing : draft.numbered)
        if (thing.kind != NumberedKind::WALL)
            places.add(thing.kind == NumberedKind::CONTACT ? "contact" : "bag",
                       open_number(draft.model, thing), thing.place, thing.keyword);
}

}  // namespace corpuscle::io
