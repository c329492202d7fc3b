// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/report/page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "io/text/json.hpp"
#include "solver/base/error.hpp"
#include "tools/report/pack.hpp"
#include "tools/report/run_data.hpp"

namespace corpuscle::report {
namespace {

namespace fs = std::filesystem;

std::string element(const std::string& id, const std::string& type, const std::string& content) {
    return fmt::format("<script type=\"{}\" id=\"{}\">{}</script>\n", type, id, content);
}

/// For HTML's own text.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '<')
            out += "&lt;";
        else if (c == '&')
            out += "&amp;";
        else
            out += c;
    }
    return out;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Every @NAME@ of the template by its text, in one pass.
std::string filled(std::string_view form,
                   const std::vector<std::pair<std::string_view, std::string>>& texts) {
    std::string out;
    for (std::size_t at = 0; at < form.size();) {
        bool is_mark = false;
        for (const auto& [mark, text] : texts)
            if (form.substr(at, mark.size()) == mark) {
                out += text;
                at += mark.size();
                is_mark = true;
                break;
            }
        if (!is_mark) out += form[at++];
    }
    return out;
}

}  // namespace

std::string page(const std::vector<fs::path>& folders) {
    std::vector<std::string> faults;
    std::string data, frames, title;
    std::size_t runs = 0, studies = 0;
    for (const fs::path& folder : folders) {
        if (!title.empty()) title += ", ";
        title += (folder / ".").parent_path().filename().string();
        if (fs::exists(folder / "study.csv")) {
            if (++studies > 1)
                faults.push_back(fmt::format("{}: expected one study a page", folder.string()));
            data += element("study", "application/json", io::json(text_of(folder / "study.csv")));
        } else if (fs::exists(folder / "results.h5")) {
            const RunData run = run_data(folder);
            data += element(fmt::format("run{}", runs), "application/json", run.json);
            data += element(fmt::format("bytes{}", runs), "application/octet-stream",
                            base64(deflated(run.bytes)));
            for (std::size_t k = 0; k < run.frames.size(); ++k)
                (k == 0 ? data : frames) +=
                    element(fmt::format("frame{}_{}", runs, k), "application/octet-stream",
                            base64(deflated(run.frames[k])));
            ++runs;
        } else {
            faults.push_back(
                fmt::format("{}: expected a folder with results.h5 or study.csv", folder.string()));
        }
    }
    if (!faults.empty()) throw InputError(faults);
    return filled(PAGE_HTML, {{"@TITLE@", escaped(title)},
                              {"@STYLE@", std::string(PAGE_STYLE)},
                              {"@LIBRARIES@", std::string(PAGE_LIBRARIES)},
                              {"@SCRIPT@", std::string(PAGE_SCRIPT)},
                              {"@DATA@", data},
                              {"@FRAMES@", frames}});
}

}  // namespace corpuscle::report
