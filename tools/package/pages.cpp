// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// usage: corpuscle_pages FOLDER            writes man pages and completions there: man1/, bash/, zsh/
//        corpuscle_pages --parse ARGS ...   would corpuscle take these arguments? 0 yes, 2 no, with a reason
#include "tools/package/pages.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "tools/command_line.hpp"

namespace corpuscle::tools {

std::vector<std::string> spellings(const CLI::Option& option) {
    std::vector<std::string> all;
    for (const std::string& name : option.get_snames()) all.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) all.push_back("--" + name);
    return all;
}

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

}  // namespace corpuscle::tools

namespace {

using namespace corpuscle;

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file);
    out << text;
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

int write_all(const std::filesystem::path& to) {
    const tools::CommandLine line;
    write(to / "man1/corpuscle.1", tools::man_page(line.app));
    for (const CLI::App* command : line.app.get_subcommands({}))
        write(to / fmt::format("man1/corpuscle-{}.1", command->get_name()),
              tools::man_page(line.app, *command));
    write(to / "bash/corpuscle", tools::bash_completion(line.app));
    write(to / "zsh/_corpuscle", tools::zsh_completion(line.app));
    return 0;
}

int try_arguments(int argc, char** argv) {
    tools::CommandLine line;
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return line.app.exit(error) == 0 ? 0 : 2;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc > 1 && std::string_view(argv[1]) == "--parse")
        return try_arguments(argc - 1, argv + 1);
    if (argc == 2 && *argv[1] != '-') return write_all(argv[1]);
    fmt::print(stderr, "usage: corpuscle_pages FOLDER | --parse ARGS ...\n");
    return 2;
} catch (const std::exception& error) {
    fmt::print(stderr, "corpuscle_pages: {}\n", error.what());
    return 1;
}
