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
    using Fields = std::vector<std::pair<std::string, FieldUse>>;  ///< in order of first sight

    /// Cards from now on are of this keyword, as the table has it.
    void begin(std::string_view keyword) { keyword_ = keyword; }
    void add(std::string_view field, FieldUse use) {
        Fields& fields = keywords_[keyword_];
        const auto known = std::find_if(fields.begin(), fields.end(),
                                        [&](const auto& f) { return f.first == field; });
        if (known == fields.end())
            fields.emplace_back(field, use);
        else
            known->second = std::max(known->second, use);
    }
    [[nodiscard]] const std::map<std::string, Fields>& keywords() const { return keywords_; }

private:
    std::string keyword_;
    std::map<std::string, Fields> keywords_;
};

}  // namespace corpuscle::io
