// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/report/pictures.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "solver/base/error.hpp"
#include "tools/report/pack.hpp"
#include "tools/report/page.hpp"

namespace corpuscle::report {
namespace {

namespace fs = std::filesystem;

/// A folder for the browser, gone at the end of the scope.
struct Desk {
    fs::path path = fs::temp_directory_path() / fmt::format("corpuscle_png_{}", getpid());
    Desk() { fs::create_directories(path); }
    ~Desk() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;
};

std::string printed_by(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) throw SystemError("--png: cannot start the browser");
    std::string text;
    std::array<char, 65536> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        text.append(part.data(), n);
    ::pclose(pipe);
    return text;
}

/// Words of a command that opens `page` without a window and prints what has become of its text;
/// the browser's own files go to `profile`.
std::string dump_command(const std::string& browser, const fs::path& page,
                         const fs::path& profile) {
    // the software renderer of WebGL draws the same everywhere; time jumps ahead when nothing waits
    return fmt::format(
        "{} --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
        "--no-first-run --disable-background-networking --disable-component-update --disable-sync "
        "--user-data-dir='{}' --window-size=1280,960 --virtual-time-budget=600000 --dump-dom "
        "'file://{}' 2>/dev/null",
        browser, profile.string(), fs::absolute(page).string());
}

}  // namespace

std::string browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (std::system(fmt::format("command -v {} > /dev/null 2>&1", name).c_str()) == 0)
            return name;
    return "";
}

std::vector<PictureFile> pictures(std::string page) {
    const std::string program = browser();
    if (program.empty())
        throw SystemError(
            "--png: there is no Chromium on the PATH (chromium, chromium-browser or "
            "google-chrome; Debian: apt-get install chromium); the page itself needs none");
    const Desk desk;
    page.replace(page.rfind("</body>"), 0,
                 fmt::format("<script>\n{}</script>\n", PAGE_PICTURES_SCRIPT));
    std::ofstream(desk.path / "page.html", std::ios::binary) << page;
    const std::string text =
        printed_by(dump_command(program, desk.path / "page.html", desk.path / "profile"));

    constexpr std::string_view BEGIN = "<pre id=\"pictures\">", URL = " data:image/png;base64,";
    std::vector<PictureFile> all;
    std::size_t at = text.find(BEGIN);
    if (at == std::string::npos)
        throw SystemError(fmt::format("--png: {} showed nothing of the page", program));
    at += BEGIN.size();
    for (std::size_t end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
        const std::string_view line = std::string_view(text).substr(at, end - at);
        const std::size_t url = line.find(URL);
        if (url == std::string_view::npos) break;
        all.push_back(
            {std::string(line.substr(0, url)), from_base64(line.substr(url + URL.size()))});
    }
    if (all.empty())
        throw SystemError(fmt::format("--png: {} could not draw the page: {}", program,
                                      text.substr(at, text.find("</pre>", at) - at)));
    return all;
}

}  // namespace corpuscle::report
