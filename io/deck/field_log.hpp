// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace corpuscle::io {

/// What happens to a field that a deck sets, the most that any card does with it.
enum class FieldUse {
    REFUSED,   ///< it is a fault
    HARMLESS,  ///< it cannot change the answer
    WARNED,    ///< it does not count, and that is said
    ACTED_ON
};

/// What readers do with the fields of cards, as they do it: for the table of keywords.
class FieldLog {
public:
    struct Field {
        std::string name;
        FieldUse use = FieldUse::REFUSED;
        unsigned ids = 0;  ///< bit k: it was read as an id of kind k (IdKind)
    };
    using Fields = std::vector<Field>;  ///< in order of first sight

    /// Cards from now on are of this keyword, as the table has it.
    void begin(std::string_view keyword) { keyword_ = keyword; }
    void add(std::string_view name, FieldUse use, unsigned ids) {
        Fields& fields = keywords_[keyword_];
        auto known = std::find_if(fields.begin(), fields.end(),
                                  [&](const Field& field) { return field.name == name; });
        if (known == fields.end()) known = fields.insert(fields.end(), {std::string(name)});
        known->use = std::max(known->use, use);
        known->ids |= ids;
    }
    [[nodiscard]] const std::map<std::string, Fields>& keywords() const { return keywords_; }

private:
    std::string keyword_;
    std::map<std::string, Fields> keywords_;
};

}  // namespace corpuscle::io
