// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Ids and places of a card, as those of the scene: what *INCLUDE_TRANSFORM does to them.

#include <fmt/format.h>

#include <cmath>

#include "io/deck/card.hpp"
#include "io/deck/included/inclusion.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {

constexpr Range IDS{1.0};
constexpr double FARTHEST = 1e100;  ///< as far as a field may lie                            [m]
constexpr double LARGEST_ID = 2147483647.0;

}  // namespace

const FilePlace& Cards::file() const {
    static const FilePlace AS_WRITTEN;
    return block_.inclusion != nullptr ? block_.inclusion->place : AS_WRITTEN;
}

const FilePlace& Card::file() const {
    return cards_.file();
}

Vec3 Card::point(std::string_view x, std::string_view y, std::string_view z) {
    const Vec3 at = file().point(vector(x, y, z));
    if ((at.array().abs() <= FARTHEST).all()) return at;
    fault(x, fmt::format("a place that is no farther than {:g} once its file is placed", FARTHEST));
    return Vec3::Zero();
}

std::optional<int> Card::shifted(std::size_t i, IdKind kind, double written) {
    mark_id(i, kind);
    const std::optional<int> id = shifted_id(cards_.block(), kind, written);
    if (!id)
        fault(i,
              fmt::format("an id that is 1 to {:.0f} once its file's offset is added", LARGEST_ID));
    return id;
}

void Card::mark_id(std::size_t i, IdKind kind) {
    id_kind_.at(i) = static_cast<std::uint8_t>(static_cast<std::size_t>(kind) + 1);
}

/// " (1005 by IDNOFF = 1000)", of an id that the file's offset changes.
std::string Card::shift_text(std::size_t i) const {
    const Inclusion* inclusion = cards_.block().inclusion;
    if (inclusion == nullptr || id_kind_.at(i) == 0) return {};
    const std::size_t kind = id_kind_.at(i) - 1U;
    const std::int64_t by = inclusion->offsets.at(kind);
    const std::string_view text = field_.at(i);
    const std::optional<double> written =
        is_named(text) ? std::optional(named_value(text)) : parse_real(text);
    if (by == 0 || !written || *written == 0.0) return {};
    const auto id = static_cast<std::int64_t>(*written);
    return fmt::format(" ({} by {} = {})", id < 0 ? id - by : id + by, OFFSET_FIELDS.at(kind), by);
}

int Card::id(std::size_t i, IdKind kind, const Range& range) {
    return shifted(i, kind, integer(i, range)).value_or(0);
}

int Card::new_id(std::size_t i, Registry& registry, std::size_t row) {
    const int id = this->id(i, registry.id_kind(), IDS);
    if (id > 0 && !registry.add(id, static_cast<Index>(row), place()))
        fault(i, fmt::format("an id that no other {} has, but {} has it", registry.kind(),
                             cards_.faults().where(registry.find(id)->place)));
    return id;
}

Index Card::collected_row(std::string_view name, Registry& registry, std::size_t row) {
    const std::size_t i = at(name);
    const int id = this->id(i, registry.id_kind(), IDS);
    if (id <= 0) return static_cast<Index>(row);
    const Registry::Entry& first = registry.collect(id, static_cast<Index>(row), place());
    if (first.is_collected) return first.row;
    fault(i, fmt::format("an id that only _COLLECT has, but the {} of {} has it", registry.kind(),
                         cards_.faults().where(first.place)));
    return static_cast<Index>(row);
}

Index Card::row(std::size_t i, const Registry& registry) {
    const Number number = this->number(i, true);
    if (!number.is_good && given(i)) return -1;
    const std::optional<int> id = shifted(i, registry.id_kind(), number.value);
    if (!id) return -1;
    if (const Registry::Entry* entry = registry.find(*id)) return entry->row;
    good_ = false;
    remember_unread(i, *id, registry);
    if (!registry.is_spoilt(*id))
        fault(i, fmt::format("the id of a {} of the deck", registry.kind()));
    return -1;
}

Index Card::row_or_none(std::string_view name, const Registry& registry) {
    const std::size_t i = at(name);
    const Number id = number(i, true);
    return id.value == 0.0 ? -1 : row(i, registry);
}

const Registry::Entry* Card::named(std::string_view name, double id, const Registry& registry) {
    if (!(id >= 1.0 && id <= LARGEST_ID) || id != std::floor(id)) return nullptr;
    mark_id(at(name), registry.id_kind());
    const std::optional<int> of_deck = shifted_id(cards_.block(), registry.id_kind(), id);
    if (!of_deck) return nullptr;
    const Registry::Entry* entry = registry.find(*of_deck);
    if (entry == nullptr) remember_unread(at(name), *of_deck, registry);
    if (entry == nullptr && registry.is_spoilt(*of_deck)) {
        unread_at_ = at(name);
        is_spoilt_ = true;
    }
    return entry;
}

void Card::remember_unread(std::size_t i, int id, const Registry& registry) {
    const Registry::Unread* other = registry.unread(id);
    if (other == nullptr) return;
    unread_at_ = i;
    unread_ = fmt::format("; {} is a *{} ({}), on which nothing acts yet", id, other->keyword,
                          cards_.faults().where(other->place));
}

}  // namespace corpuscle::io
