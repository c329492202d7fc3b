// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <filesystem>

#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

namespace corpuscle::tools {

int report(const ReportArguments& arguments) {
    const std::vector<std::filesystem::path> folders(arguments.folders.begin(),
                                                     arguments.folders.end());
    const std::filesystem::path file = arguments.output.empty()
                                           ? folders.front() / "report.html"
                                           : std::filesystem::path(arguments.output);
    if (!arguments.png.empty() && std::filesystem::exists(folders.front() / "study.csv"))
        throw InputError(fmt::format("--png: expected the folder of a run first, {} is a study",
                                     folders.front().string()));
    for (const std::filesystem::path& folder : folders)
        expect_no_input(file, {folder / "results.h5", folder / "study.csv"});
    const std::string page = report::page(folders);
    io::replace_text(file, page);
    fmt::print("{}: {:.1f} MB, opens in any browser\n", file.string(),
               1e-6 * static_cast<double>(page.size()));
    if (!arguments.png.empty()) {
        std::filesystem::create_directories(arguments.png);
        for (const report::PictureFile& picture : report::pictures(page)) {
            const std::filesystem::path to = std::filesystem::path(arguments.png) / picture.name;
            io::replace_text(to, picture.bytes);
            fmt::print("{}\n", to.string());
        }
    }
    return 0;
}

}  // namespace corpuscle::tools
