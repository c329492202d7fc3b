// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::parallel {

/// Line of a source that calls: std::source_location, which clang 14 does not have.
struct CallSite {
    const char* file = "";  ///< as the compiler was given it
    int line = 0;           ///< from 1 on

    /// Of the caller, as a default argument.
    [[nodiscard]] static constexpr CallSite current(const char* file = __builtin_FILE(),
                                                    int line = __builtin_LINE()) {
        return {file, line};
    }
};

}  // namespace corpuscle::parallel
