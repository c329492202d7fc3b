// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <filesystem>

#include "io/atomic_file.hpp"
#include "tools/commands.hpp"
#include "tools/report/page.hpp"

namespace corpuscle::tools {

int report(const ReportArguments& arguments) {
    const std::vector<std::filesystem::path> folders(arguments.folders.begin(),
                                                     arguments.folders.end());
    const std::filesystem::path file = arguments.output.empty()
                                           ? folders.front() / "report.html"
                                           : std::filesystem::path(arguments.output);
    const std::string page = report::page(folders);
    io::replace_text(file, page);
    fmt::print("{}: {:.1f} MB, opens in any browser\n", file.string(),
               1e-6 * static_cast<double>(page.size()));
    return 0;
}

}  // namespace corpuscle::tools
