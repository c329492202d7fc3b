// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// corpuscle verify: the cases of models/verification through the whole program, held to what is
// known exactly.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "io/system/atomic_file.hpp"
#include "io/system/folder_lock.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/study/workers.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/page.hpp"
#include "tools/verify/runner.hpp"
#include "tools/verify/table.hpp"
#include "tools/version.hpp"

namespace corpuscle::tools {
namespace {

namespace fs = std::filesystem;

int list(const std::vector<verify::Card>& cards) {
    for (const verify::Card& card : cards) {
        fmt::print("{:<20} {} ({})\n", card.name, card.title, card.family);
        for (const verify::Quantity& q : card.quantities)
            fmt::print("    {:<16} {}, {}; quick {}\n", q.name, q.what, shown(q, q.budget_full),
                       shown(q, q.budget_quick));
    }
    return 0;
}

void write(const fs::path& file, const std::vector<verify::Row>& rows, verify::Mode mode) {
    const std::string settings =
        fmt::format("corpuscle {}, by `corpuscle verify --{}`{}.", version(),
                    mode == verify::Mode::QUICK ? "quick" : "full",
                    mode == verify::Mode::QUICK ? ": fewer particles, coarser meshes and fewer "
                                                  "seeds than --full, with budgets of their own"
                                                : "");
    io::replace_text(file, file.extension() == ".md" ? verify::table_markdown(rows, settings)
                                                     : verify::page(rows, settings));
}

/// 0: all holds but what was known not to.
int verdict(const std::vector<verify::Row>& rows, const std::vector<std::string>& known) {
    int status = 0;
    for (const verify::Row& row : rows) {
        const bool is_known = std::find(known.begin(), known.end(), row.name()) != known.end();
        if (row.holds() && is_known) fmt::print("{} holds: --known is not needed\n", row.name());
        if (!row.holds() && !is_known) status = 1;
    }
    return status;
}

}  // namespace

int verify_program(const VerifyArguments& arguments) {
    const std::string program = study::this_program();
    const fs::path folder =
        arguments.cases.empty() ? verify::find_cases(program) : fs::path(arguments.cases);
    const std::vector<verify::Card> cards = verify::read_cards(folder, arguments.names);
    for (const verify::Card& card : cards) static_cast<void>(verify::method_of(card));
    if (arguments.only_list) return list(cards);

    verify::Plan plan;
    plan.mode = arguments.full ? verify::Mode::FULL : verify::Mode::QUICK;
    plan.program = program;
    const fs::path page = arguments.output.empty() ? "verification.html" : arguments.output;
    plan.folder = arguments.folder.empty() ? fs::path(page).replace_extension("runs")
                                           : fs::path(arguments.folder);
    plan.workers = arguments.workers > 0
                       ? arguments.workers
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const io::FolderLock lock(plan.folder);
    const std::vector<verify::Row> rows = verify::verify(
        cards, plan, [](const std::string& line) { fmt::print(stderr, "{}\n", line); });
    fmt::print("{}", table_text(rows, isatty(STDOUT_FILENO) != 0));
    write(page, rows, plan.mode);
    fmt::print("{:.0f} s of CPU time; {}, runs in {}\n", total_cpu(rows), page.string(),
               plan.folder.string());
    return verdict(rows, arguments.known);
}

}  // namespace corpuscle::tools
