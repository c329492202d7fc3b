// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/report/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace corpuscle::report {
namespace {

struct Word {
    const char *written, *said;
};

/// Groups whose next word is a number.
constexpr std::array GROUPS{Word{"airbag", "bag"},
                            Word{"species", "gas"},
                            Word{"chamber", "chamber"},
                            Word{"part", "part"},
                            Word{"rigid_body", "rigid body"},
                            Word{"rigidwall", "rigid wall"},
                            Word{"contact", "contact"},
                            Word{"node", "node"},
                            Word{"cpm_sensor", "sensor"}};

constexpr std::array QUANTITIES{Word{"mass_in", "gas come in"},
                                Word{"mass_out", "gas gone out"},
                                Word{"mass_out_vent", "gas gone through vents"},
                                Word{"mass_out_fabric", "gas gone through fabric"},
                                Word{"mass", "gas inside"},
                                Word{"particles", "particles inside"},
                                Word{"particles_out", "particles gone"},
                                Word{"smoothing", "on its way to the fabric"},
                                Word{"residual", "error of the books"}};

std::string said_of(const std::string& word) {
    for (const Word& known : QUANTITIES)
        if (word == known.written) return known.said;
    std::string text = word;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

}  // namespace

std::string label_of(const std::string& path, const std::map<int, std::string>& titles) {
    std::vector<std::string> words;
    std::istringstream in(path);
    for (std::string word; std::getline(in, word, '/');) words.push_back(word);
    std::string whose, what = words.back();
    for (std::size_t k = 0; k + 1 < words.size(); ++k) {
        const auto group = std::find_if(GROUPS.begin(), GROUPS.end(), [&](const Word& known) {
            return words[k] == known.written;
        });
        whose += whose.empty() ? "" : ", ";
        if (group == GROUPS.end() || k + 2 >= words.size()) {
            whose += said_of(words[k]);
            continue;
        }
        const std::string& number = words[++k];
        whose += fmt::format("{} {}", group->said, number);
        if (words[k - 1] != "part" && words[k - 1] != "rigid_body") continue;
        const auto title = titles.find(std::atoi(number.c_str()));
        if (title != titles.end() && !title->second.empty())
            whose += fmt::format(" \"{}\"", title->second);
    }
    std::string axis;
    if (const std::size_t dot = what.rfind('.'); dot != std::string::npos) {
        axis = ", " + what.substr(dot + 1);
        what.resize(dot);
    }
    return fmt::format("{}{}{}{}", whose, whose.empty() ? "" : ": ", said_of(what), axis);
}

}  // namespace corpuscle::report
