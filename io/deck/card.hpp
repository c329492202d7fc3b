// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/faults.hpp"
#include "io/deck/included/file_place.hpp"
#include "io/deck/included/id_kind.hpp"
#include "io/deck/parameters.hpp"
#include "io/deck/registry.hpp"
#include "solver/base/vec.hpp"

/// Card images: a keyword's lines read field by field, as the manual prints them.
///
///     Card c = cards.next("MID RO E PR - DT=1e20");      // names, unused, default
///     material.density = c.real("RO", POSITIVE);
///     c.harmless("DT");                                  // set or not, the answer is the same
///
/// A blank or zero field has the default of the layout. A field that a handler neither reads nor
/// calls harmless is one that nothing acts on: set, it is a fault that says so.
namespace corpuscle::io {

/// Columns beyond are remarks.
inline constexpr std::size_t CARD_END = 80, LONG_CARD_END = 160;

/// How wide the columns of fixed cards are: as in the manual, ids of 10 instead of 8, all 20.
enum class Columns : std::uint8_t { STANDARD, I10, LONG };

struct Line {
    std::string_view text;
    std::uint32_t number = 0;
};

struct Inclusion;

/// A keyword and its lines, comments taken out.
struct Block {
    std::string keyword;  ///< upper case, without *
    Place place;
    Columns columns = Columns::STANDARD;
    std::span<const Line> lines;
    const Inclusion* inclusion = nullptr;  ///< the *INCLUDE_TRANSFORM around it, the nearest
    std::size_t defined = static_cast<std::size_t>(-1);  ///< parameters' definitions before it

    /// From where its cards see parameters.
    [[nodiscard]] Viewpoint viewpoint() const { return {place.file, defined}; }
};

/// Numbers that a field may hold.
struct Range {
    double low = -INF, high = INF;
    bool low_is_out = false, high_is_out = false;

    [[nodiscard]] bool holds(double value) const;
    [[nodiscard]] std::string text() const;
};
inline constexpr Range ANY{};
inline constexpr Range POSITIVE{0.0, INF, true};
inline constexpr Range NON_NEGATIVE{0.0};
constexpr Range within(double low, double high) {
    return {low, high};
}

/// Names, widths and defaults of a card's fields: "NID:8 X:16 - SF=1". Without a width it is 10
/// columns; - is an unused field. The text is a literal: it is
/// kept.
class Layout {
public:
    static constexpr std::size_t MOST_FIELDS = 10;
    struct Field {
        std::string_view name;
        int width = 10;
        double fallback = 0.0;
    };

    Layout(const char* text);  // NOLINT: a card is written as its layout

    [[nodiscard]] std::span<const Field> fields() const { return {fields_.data(), size_}; }

private:
    std::array<Field, MOST_FIELDS> fields_{};
    std::size_t size_ = 0;
};

class Cards;

/// One line, cut into the fields of its layout. Faults and warnings go to the deck's list; what is
/// returned for a bad field is its default.
class Card {
public:
    Card(Cards& cards, const Layout& layout, const Line& line, bool is_missing, bool plus);
    ~Card();  ///< complains of fields that are set and that nothing acts on
    Card(const Card&) = delete;
    Card& operator=(const Card&) = delete;

    double real(std::string_view name, const Range& range = ANY) { return real(at(name), range); }
    int integer(std::string_view name, const Range& range = ANY) {
        return integer(at(name), range);
    }
    /// One of a few choices; `later` are choices that LS-DYNA has and nothing acts on yet.
    int choice(std::string_view name, std::initializer_list<int> known,
               std::initializer_list<int> later = {});
    Vec3 vector(std::string_view x, std::string_view y, std::string_view z);
    std::string text(std::string_view name);

    /// Where the card's file lies in the scene.
    [[nodiscard]] const FilePlace& file() const;
    /// A place that is written in coordinates, in those of the scene.
    Vec3 point(std::string_view x, std::string_view y, std::string_view z);
    /// A direction or a velocity, in the axes of the scene.
    Vec3 direction(std::string_view x, std::string_view y, std::string_view z) {
        return file().direction(vector(x, y, z));
    }
    /// An angular velocity, in the axes of the scene.
    Vec3 spin(std::string_view x, std::string_view y, std::string_view z) {
        return file().spin(vector(x, y, z));
    }

    // Ids are those of the deck: *INCLUDE_TRANSFORM adds its offsets to what is written.

    /// An id that no registry knows.
    int id(std::string_view name, IdKind kind, const Range& range = ANY) {
        return id(at(name), kind, range);
    }
    /// What a number names that stands for an id, such as the curve of FLC = -7: id = 7. nullptr:
    /// nothing.
    const Registry::Entry* named(std::string_view name, double id, const Registry& registry);
    /// An id of one's own: above 0 and not used before for this kind.
    int new_id(std::string_view name, Registry& registry, std::size_t row) {
        return new_id(at(name), registry, row);
    }
    /// The same of a _COLLECT, which shares its id with others: the row of the first of them.
    Index collected_row(std::string_view name, Registry& registry, std::size_t row);
    /// Row of the thing that the field names; -1 and a fault when there is none.
    Index row(std::string_view name, const Registry& registry) { return row(at(name), registry); }
    /// The same; blank or 0: -1.
    Index row_or_none(std::string_view name, const Registry& registry);

    // By position, for tables
    double real(std::size_t i, const Range& range = ANY);
    int integer(std::size_t i, const Range& range = ANY);
    int id(std::size_t i, IdKind kind, const Range& range = ANY);
    int new_id(std::size_t i, Registry& registry, std::size_t row);
    Index row(std::size_t i, const Registry& registry);
    [[nodiscard]] std::string_view raw(std::size_t i);  ///< as written; counts as read
    [[nodiscard]] bool given(std::size_t i) const { return !field_[i].empty(); }

    [[nodiscard]] bool given(std::string_view name) { return given(at(name)); }
    void harmless(std::string_view names);  ///< cannot change the answer here
    void harmless_all() { read_ = ~0U; }
    void noted(std::string_view names, std::string_view why);  ///< the same, with a warning if set
    void noted(std::string_view name, double value, std::string_view why);  ///< if it is this value
    /// Names of fields that have another value than 0 and than their default.
    [[nodiscard]] std::vector<std::string_view> set_fields() const;
    [[nodiscard]] bool is_blank() const;  ///< no field is written, or all are 0

    void fault(std::string_view name, const std::string& expected) { fault(at(name), expected); }
    void fault(std::size_t i, const std::string& expected);
    void warn(std::string_view name, const std::string& remark);
    void note(std::string_view name, const std::string& remark);
    [[nodiscard]] bool good() const { return good_; }  ///< no fault in this card so far
    [[nodiscard]] Place place() const;

private:
    struct Number {
        double value = 0.0;
        bool is_good = false;  ///< false: blank, or a fault that is reported
    };
    [[nodiscard]] std::size_t at(std::string_view name) const;
    void cut(std::string_view line, Columns columns, bool plus);
    Number number(std::size_t i, bool whole);
    [[nodiscard]] static bool is_named(std::string_view text);  ///< by parameter or expression?
    [[nodiscard]] double named_value(std::string_view text) const;
    Number named_number(std::size_t i);
    double in_range(std::size_t i, Number number, const Range& range);
    /// What the field stands for as an id of this kind. None: a fault, it would be no id.
    std::optional<int> shifted(std::size_t i, IdKind kind, double written);
    void mark_id(std::size_t i, IdKind kind);
    /// Nothing that is read has this id: faults of the field say what else has it.
    void remember_unread(std::size_t i, int id, const Registry& registry);
    [[nodiscard]] std::string shift_text(std::size_t i) const;
    [[nodiscard]] std::string written(std::size_t i) const;
    [[nodiscard]] std::string label(std::size_t i) const;
    [[nodiscard]] std::string cause(std::size_t i, const std::string& remark) const;
    void write_log() const;
    void complain_of_unread();
    void warn_of_rest();

    Cards& cards_;
    Layout layout_;
    Line line_;
    std::array<std::string_view, Layout::MOST_FIELDS> field_{};
    std::string_view rest_;                 ///< after the last field
    std::string_view beyond_;               ///< numbers beyond the last column of a card
    std::size_t unread_at_ = 0;             ///< field whose id is that of
    bool is_spoilt_ = false;                ///< that field's id is no further fault
    std::string unread_;                    ///< something that is not read; empty: none
    std::uint32_t read_ = 0;                ///< bit i: field i was read or is harmless
    std::uint32_t acted_ = 0, warned_ = 0;  ///< bit i: it was read to be acted on; to be warned of
    std::array<std::uint8_t, Layout::MOST_FIELDS> id_kind_{};  ///< of ids, from 1; 0: no id
    int card_number_ = 0;
    bool is_missing_ = false;
    bool good_ = true;
};

/// The lines of one keyword, handed out in order.
class Cards {
public:
    Cards(const Block& block, Faults& faults, const Parameters& parameters,
          std::vector<std::string_view> suffixes = {});

    /// Does the keyword carry this suffix?
    [[nodiscard]] bool has(std::string_view suffix) const;
    [[nodiscard]] bool more() const;  ///< is there another line that is not blank?
    /// Lines up to the last one that is not blank.
    [[nodiscard]] std::size_t lines_left() const;
    [[nodiscard]] bool rows();  ///< the same, for tables: steps over blank lines
    [[nodiscard]] bool starts_with(char sign) const;  ///< column 1 of the next line
    [[nodiscard]] bool plus() const { return starts_with('+'); }

    /// The next line, blank or not. When there is none: a fault, and a card that is blank.
    Card next(const Layout& layout);
    Card next_plus(const Layout& layout);
    std::string title();  ///< the next line as it is, without blanks around it

    [[nodiscard]] bool good() const { return faults_.block_is_good(); }  ///< no fault so far
    /// A fault of the keyword as a whole.
    void fault(const std::string& what);
    void warn(const std::string& what);
    void note(const std::string& what);
    /// The rest cannot be made sense of; what is wrong is reported.
    void abandon();
    /// No line may be left.
    void finish();

    [[nodiscard]] const Block& block() const { return block_; }
    [[nodiscard]] const FilePlace& file() const;  ///< where the keyword's file lies in the scene
    [[nodiscard]] Faults& faults() { return faults_; }
    [[nodiscard]] const Parameters& parameters() const { return parameters_; }
    [[nodiscard]] int card_number() const { return static_cast<int>(next_); }

private:
    const Line* take(std::string_view what);

    const Block& block_;
    Faults& faults_;
    const Parameters& parameters_;
    std::vector<std::string_view> suffixes_;
    std::size_t next_ = 0;
    bool told_missing_ = false;
};

}  // namespace corpuscle::io
