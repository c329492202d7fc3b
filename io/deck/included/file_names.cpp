// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/included/file_names.hpp"

#include <algorithm>

#include "io/text/text.hpp"

namespace corpuscle::io {

FileName file_name(std::span<const Line> lines) {
    FileName file;
    for (bool goes_on = true; goes_on && file.lines < lines.size(); ++file.lines) {
        std::string_view text = trim(lines[file.lines].text);
        goes_on = text.ends_with(" +");
        if (goes_on) text = trim(text.substr(0, text.size() - 2));
        if (text.size() > 1 && text.front() == '"' && text.back() == '"')
            text = text.substr(1, text.size() - 2);
        if (file.name.empty()) file.line = lines[file.lines];
        file.name += text;
        goes_on = goes_on || file.name.empty();
    }
    std::replace(file.name.begin(), file.name.end(), '\\', '/');
    return file;
}

std::vector<FileName> file_names(std::span<const Line> lines) {
    std::vector<FileName> names;
    while (!lines.empty()) {
        names.push_back(file_name(lines));
        lines = lines.subspan(names.back().lines);
    }
    std::erase_if(names, [](const FileName& file) { return file.name.empty(); });
    return names;
}

}  // namespace corpuscle::io
