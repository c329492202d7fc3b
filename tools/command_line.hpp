// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "tools/commands/commands.hpp"

namespace corpuscle::tools {

/// What the command line may hold, and after parsing what it held. --help, the man pages and the
/// shells' completions all come from here.
struct CommandLine {
    CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    CLI::App app;
    RunArguments run;
    DeckArguments check;
    bool check_as_json = false;
    MeshArguments mesh;
    NewArguments begin;
    FoldArguments fold;
    ResponsesArguments responses;
    StudyArguments study;
    ExportArguments exports;
    ReportArguments report;
    VerifyArguments verify;
};

}  // namespace corpuscle::tools
