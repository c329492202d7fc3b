// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <sstream>

#include "tools/package/pages.hpp"
#include "tools/version.hpp"

namespace corpuscle::tools {
namespace {

/// Text as roff takes it: a backslash and a hyphen mean something else there, and so does a full
/// stop or a quote that begins a line.
std::string plain(const std::string& text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
        begins = c == '\n';
    }
    return out;
}

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

std::string head(const std::string& name, const std::string& does) {
    return fmt::format(
        ".TH {} 1 \"\" \"corpuscle {}\" \"corpuscle\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
        plain(upper(name)), version(), plain(name), plain(does));
}

/// -o, --output TEXT; positionals: their name alone.
std::string entry(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : spellings(option))
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", plain(name));
    if (names.empty()) names = fmt::format("\\fI{}\\fR", plain(option.get_name()));
    if (!spellings(option).empty() && takes_value(option)) {
        const std::string type = option.get_type_name();  // "INT:INT in [1 - 1024]"
        names += fmt::format(" \\fI{}\\fR", plain(type.substr(0, type.find(':'))));
    }
    std::string text = plain(option.get_description());
    if (!option.get_default_str().empty())
        text += fmt::format(" (default: {})", plain(option.get_default_str()));
    return fmt::format(".TP\n{}\n{}\n", names, text);
}

std::string entries(const CLI::App& app, bool positional) {
    std::string text;
    for (const CLI::Option* option : app.get_options({}))
        if (option->get_positional() == positional) text += entry(*option);
    return text;
}

/// A footer's lines that begin with two spaces are commands; "Examples:" is a heading.
std::string examples(const CLI::App& app) {
    std::istringstream lines(app.get_footer());
    std::string commands, words;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  "))
            commands += plain(line.substr(2)) + "\n";
        else if (!line.starts_with("Example"))
            words += plain(line) + "\n";
    }
    std::string text;
    if (!commands.empty()) text += ".SH EXAMPLES\n.nf\n" + commands + ".fi\n";
    if (!words.empty()) text += ".SH NOTES\n" + words;
    return text;
}

constexpr const char* EXIT_STATUS =
    ".SH EXIT STATUS\n"
    ".TP\n0\nnormal termination\n"
    ".TP\n1\nthe system refused something: no memory, no room on the disk, ...\n"
    ".TP\n2\nbad input; each fault with file, line, keyword, card, field, value and what was "
    "expected\n"
    ".TP\n3\nthe physics broke; results up to then are readable\n";

}  // namespace

std::string man_page(const CLI::App& app) {
    std::string text = head("corpuscle", "deploys airbags: fabric, gas and contact");
    text += "\\fBcorpuscle\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n.SH DESCRIPTION\n";
    text += plain(app.get_description()) + "\n.SH COMMANDS\n";
    for (const CLI::App* command : app.get_subcommands({}))
        text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", plain(command->get_name()),
                            plain(command->get_description()));
    text += ".SH OPTIONS\n" + entries(app, /*positional=*/false) + examples(app) + EXIT_STATUS;
    text += ".SH SEE ALSO\n";
    std::string others;
    for (const CLI::App* command : app.get_subcommands({}))
        others += fmt::format("{}\\fBcorpuscle\\-{}\\fR(1)", others.empty() ? "" : ",\n",
                              command->get_name());
    return text + others + "\n";
}

std::string man_page(const CLI::App& app, const CLI::App& command) {
    const std::string name = app.get_name().empty() ? "corpuscle" : app.get_name();
    std::string text = head(name + "-" + command.get_name(), command.get_description());
    text += fmt::format("\\fBcorpuscle {}\\fR [\\fIOPTIONS\\fR]", plain(command.get_name()));
    for (const CLI::Option* option : command.get_options({}))
        if (option->get_positional()) text += fmt::format(" \\fI{}\\fR", plain(option->get_name()));
    text += "\n.SH DESCRIPTION\n" + plain(command.get_description()) + ".\n";
    text += ".SH ARGUMENTS\n" + entries(command, /*positional=*/true);
    text += ".SH OPTIONS\n" + entries(command, /*positional=*/false);
    return text + examples(command) + EXIT_STATUS + ".SH SEE ALSO\n\\fBcorpuscle\\fR(1)\n";
}

}  // namespace corpuscle::tools
