// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"

namespace corpuscle::tools {

void expect_no_input(const std::filesystem::path& output,
                     const std::vector<std::filesystem::path>& inputs) {
    for (const std::filesystem::path& input : inputs) {
        std::error_code is_not_there;
        if (std::filesystem::equivalent(output, input, is_not_there))
            throw InputError(fmt::format("-o {}: expected another file: this is {}, which is read",
                                         output.string(), input.string()));
    }
}

}  // namespace corpuscle::tools
