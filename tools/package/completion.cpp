// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tools/package/pages.hpp"

namespace corpuscle::tools {
namespace {

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> all;
    for (const CLI::Option* option : app.get_options({}))
        for (const std::string& name : spellings(*option)) all.push_back(name);
    return all;
}

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> all;
    for (const CLI::App* command : app.get_subcommands({})) all.push_back(command->get_name());
    return all;
}

/// Inside single quotes and brackets of zsh.
std::string quoted(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\'')
            out += "'\\''";
        else if (c == '[' || c == ']' || c == ':')
            out += fmt::format("\\{}", c);
        else
            out += c;
    }
    return out;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
    std::string text =
        "# Completion of corpuscle's commands and options for bash; file names complete as ever.\n"
        "_corpuscle() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} words=\"\"\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n";
    text +=
        fmt::format("        words=\"{} {}\"\n", joined(commands_of(app)), joined(options_of(app)));
    text +=
        "    elif [[ $word == -* ]]; then\n"
        "        case ${COMP_WORDS[1]} in\n";
    for (const CLI::App* command : app.get_subcommands({}))
        text += fmt::format("            {}) words=\"{}\" ;;\n", command->get_name(),
                            joined(options_of(*command)));
    return text +
           "        esac\n"
           "    fi\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
           "}\n"
           "complete -o default -F _corpuscle corpuscle\n";
}

std::string zsh_completion(const CLI::App& app) {
    std::string text =
        "#compdef corpuscle\n"
        "# Completion of corpuscle's commands and options for zsh.\n"
        "local -a commands=(\n";
    for (const CLI::App* command : app.get_subcommands({}))
        text +=
            fmt::format("    '{}:{}'\n", command->get_name(), quoted(command->get_description()));
    text +=
        ")\n"
        "if (( CURRENT == 2 )); then\n"
        "    _describe command commands\n"
        "    return\n"
        "fi\n"
        "shift words\n"
        "(( CURRENT-- ))\n"
        "case ${words[1]} in\n";
    for (const CLI::App* command : app.get_subcommands({})) {
        text += fmt::format("    {})\n        _arguments \\\n", command->get_name());
        for (const CLI::Option* option : command->get_options({}))
            for (const std::string& name : spellings(*option))
                text += fmt::format("            '{}[{}]{}' \\\n", name,
                                    quoted(option->get_description()),
                                    takes_value(*option) ? ":value:_files" : "");
        text += "            '*:file:_files'\n        ;;\n";
    }
    return text + "esac\n";
}

}  // namespace corpuscle::tools
