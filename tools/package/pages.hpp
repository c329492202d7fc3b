// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

/// What is made from the description of the command line beside --help.
namespace corpuscle::tools {

/// Of the program itself, with a list of its commands; or of one command.
std::string man_page(const CLI::App& app);
std::string man_page(const CLI::App& app, const CLI::App& command);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

/// "-o", "--output": short ones first.
std::vector<std::string> spellings(const CLI::Option& option);
/// Does a value follow it?
bool takes_value(const CLI::Option& option);

}  // namespace corpuscle::tools
