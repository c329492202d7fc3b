// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/keyword_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>

#include "io/deck/comment_settings.hpp"
#include "io/deck/included/file_names.hpp"
#include "io/deck/parameter_cards.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t MOST_FILES = 10000;               ///< includes may double at every level
constexpr std::size_t MOST_DEPTH = 100;                 ///< files within each other
constexpr std::uintmax_t MOST_TEXT = 2'000'000'000ULL;  ///< bytes, of all files together

/// "*NODE +" -> NODE, and the columns that its sign asks for.
struct Head {
    std::string name, rest;
    std::optional<Columns> columns;
};

Head parse_head(std::string_view line) {
    line = trim(line.substr(1));
    const std::size_t end = line.find(' ');
    Head head{upper(line.substr(0, end)),
              end == std::string_view::npos ? "" : upper(trim(line.substr(end))),
              {}};
    char sign = head.rest.size() == 1 ? head.rest.front() : ' ';
    if (!head.name.empty() &&
        std::string_view("+-%").find(head.name.back()) != std::string_view::npos) {
        sign = head.name.back();
        head.name.pop_back();
    }
    if (sign == '+') head.columns = Columns::LONG;
    if (sign == '-') head.columns = Columns::STANDARD;
    if (sign == '%') head.columns = Columns::I10;
    return head;
}

/// What LS-DYNA knows on the line of *KEYWORD and nothing here depends on.
bool is_of_ls_dyna(std::string_view option) {
    if (option.front() >= '0' && option.front() <= '9') return true;  // words of memory
    bool found = false;
    for_each_word("MEMORY MEMORY2 NCPU PROJECT JOBID NUM STAGE ID", [&](std::string_view name) {
        found |= option.starts_with(name) && option.substr(name.size()).starts_with('=');
    });
    return found;
}

/// The options of *KEYWORD: "LONG = Y, NCPU=2" -> "LONG=Y NCPU=2".
std::string plain_options(const Head& head) {
    const std::string glued = head.name.substr(std::string_view("KEYWORD").size());
    const std::string written = (glued.starts_with('_') ? "" : glued) + ' ' + head.rest;
    std::string plain;
    for (const char c : written) {
        const bool is_blank = c == ' ' || c == ',';
        if (is_blank && plain.ends_with('=')) continue;
        while (c == '=' && plain.ends_with(' ')) plain.pop_back();
        plain += is_blank ? ' ' : c;
    }
    return plain;
}

/// LONG=Y or K reads 20 columns; LONG=S is about files that LS-DYNA writes.
Columns keyword_columns(const Head& head, Columns now, Place place, Faults& faults) {
    std::string unknown;
    for_each_word(plain_options(head), [&](std::string_view word) {
        if (word == "LONG=Y" || word == "LONG=YES" || word == "LONG=K")
            now = Columns::LONG;
        else if (word == "LONG=S" || word == "LONG=N" || word == "LONG=NO")
            now = Columns::STANDARD;
        else if (word == "I10=Y" || word == "I10=YES")
            now = Columns::I10;
        else if (word != "I10=N" && word != "I10=NO" && !is_of_ls_dyna(word))
            unknown.append(unknown.empty() ? "" : " ").append(word);
    });
    if (!unknown.empty())
        faults.warn(place,
                    fmt::format("*KEYWORD {} is ignored, expected LONG = Y, K, S or N, or I10 = Y",
                                unknown));
    return now;
}

class Reader {
public:
    Reader(const fs::path& deck, Parameters& parameters, Faults& faults)
        : deck_(deck), parameters_(parameters), faults_(faults) {}

    DeckText read() {
        const std::uint32_t file = open(deck_, {});
        text_.end = {file, 1};
        if (const std::string why = load(deck_); !why.empty()) {
            text_.is_incomplete = true;
            faults_.fault(text_.end, why);
        } else
            read_file(file, deck_, Columns::STANDARD);
        read_offsets(text_.inclusions, parameters_, faults_);
        return std::move(text_);
    }

private:
    std::uint32_t open(const fs::path& path, std::optional<std::uint32_t> parent) {
        const std::uint32_t file = faults_.add_file(path.string());
        parameters_.add_file(file, parent);
        return file;
    }

    /// Appends the file's text; says why when that does not work.
    std::string load(const fs::path& path) {
        std::error_code error;
        if (!fs::is_regular_file(path, error)) return "expected a file that can be read";
        const std::uintmax_t size = fs::file_size(path, error);
        if (error) return "expected a file that can be read";
        if (text_.files.size() >= MOST_FILES || (total_ += size) > MOST_TEXT)
            return "expected less text: the includes of this deck grow without end";
        std::ifstream in(path, std::ios::binary);
        DeckText::File& file = text_.files.emplace_back();
        file.text.resize(size);
        in.read(file.text.data(), static_cast<std::streamsize>(size));
        if (!in) return "expected a file that can be read";
        if (std::string why = why_no_lines(file.text); !why.empty()) return why;
        file.lines = split_lines(file.text);
        return {};
    }

    /// Every keyword of the file loaded last. *END ends this file: one that includes it goes on.
    void read_file(std::uint32_t file, const fs::path& path, Columns columns) {
        open_files_.push_back(canonical(path));
        const std::span<const Line> lines = text_.files.back().lines;
        read_comment_settings(text_.files.back().text, file, parameters_, faults_);
        std::size_t i = skip_to_keyword(lines, 0);
        if (i > 0 && !trim(lines[0].text).empty() && !is_encrypted(lines.first(i), file))
            faults_.fault({file, lines[0].number}, fmt::format("expected a *KEYWORD before \"{}\"",
                                                               trim(lines[0].text).substr(0, 60)));
        while (i < lines.size()) {
            const std::size_t end = skip_to_keyword(lines, i + 1);
            const Head head = parse_head(lines[i].text);
            if (file == 0) text_.end.line = lines[i].number;
            if (head.name == "END") break;
            if (head.name.starts_with("KEYWORD"))
                columns = keyword_columns(head, columns, {file, lines[i].number}, faults_);
            Block block{head.name,
                        {file, lines[i].number},
                        head.columns.value_or(columns),
                        lines.subspan(i + 1, end - i - 1),
                        inclusion_};
            if (!is_parameter_keyword(head.name)) block.defined = parameters_.definitions();
            if (!is_encrypted(block.lines, file)) take(block, path, columns);
            i = end;
        }
        open_files_.pop_back();
    }

    static std::size_t skip_to_keyword(std::span<const Line> lines, std::size_t i) {
        while (i < lines.size() && !lines[i].text.starts_with('*')) ++i;
        return i;
    }

    /// Encrypted lines among these: one fault, and what they say is not known.
    bool is_encrypted(std::span<const Line> lines, std::uint32_t file) {
        for (const Line& line : lines) {
            if (!line.text.starts_with("-----BEGIN PGP")) continue;
            text_.is_incomplete = true;
            faults_.fault({file, line.number},
                          "encrypted keywords (PGP), which LS-DYNA alone can read, expected them "
                          "as plain text");
            return true;
        }
        return false;
    }

    void take(const Block& block, const fs::path& path, Columns columns) {
        const std::string& name = block.keyword;
        if (name.empty())
            faults_.fault(block.place, "*, expected the name of a keyword behind it");
        else if (name == "INCLUDE")
            include(block, path, columns);
        else if (name == "INCLUDE_TRANSFORM")
            include_placed(block, path, columns);
        else if (name == "INCLUDE_PATH" || name == "INCLUDE_PATH_RELATIVE")
            add_path(block, path);
        else if (is_parameter_keyword(name))
            read_parameters(block, parameters_, faults_);
        else if (!name.starts_with("KEYWORD")) {
            text_.is_incomplete |= name.starts_with("INCLUDE");  // of a kind that is refused
            text_.blocks.push_back(block);
        }
    }

    void include(const Block& block, const fs::path& path, Columns columns) {
        const auto names = file_names(block.lines);
        if (names.empty()) faults_.fault(block.place, "*INCLUDE, expected the name of a file");
        for (std::size_t i = 0; i < names.size(); ++i)
            include_one(block, names[i], i + 1, path, columns);
    }

    /// The cards behind the name are read when all parameters are known.
    void include_placed(const Block& block, const fs::path& path, Columns columns) {
        const FileName file = file_name(block.lines);
        if (file.name.empty())
            return faults_.fault(block.place, "*INCLUDE_TRANSFORM, expected the name of a file");
        const Inclusion* outer = inclusion_;
        inclusion_ =
            &text_.inclusions.emplace_back(Inclusion{block, file.lines, file.name, {}, {}});
        include_one(block, file, 1, path, columns);
        inclusion_ = outer;
    }

    void include_one(const Block& block, const FileName& file, std::size_t card,
                     const fs::path& path, Columns columns) {
        const std::string& name = file.name;
        const Place at{block.place.file, file.line.number};
        const auto complain = [&](const std::string& expected) {
            text_.is_incomplete = true;
            faults_.fault(at, fmt::format("*{} card {}, field 1 (FILENAME) = {}, {}", block.keyword,
                                          card, name, expected));
        };
        const fs::path found = look_for(name, path);
        const fs::path real = canonical(found);
        if (std::find(open_files_.begin(), open_files_.end(), real) != open_files_.end())
            return complain("expected no file that includes itself: " + cycle(real));
        if (open_files_.size() > MOST_DEPTH)
            return complain(fmt::format("expected at most {} files within each other", MOST_DEPTH));
        if (const std::string why = load(found); !why.empty()) return complain(why);
        read_file(open(found, at.file), found, columns);
    }

    static fs::path canonical(const fs::path& path) {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(path, error);
        return error ? path : real;
    }

    /// Without its dots where that names the same file: behind a linked folder ".." is another one.
    static fs::path plain(const fs::path& path) {
        std::error_code error;
        const fs::path short_one = path.lexically_normal();
        return fs::equivalent(path, short_one, error) ? short_one : path;
    }

    fs::path look_for(const std::string& name, const fs::path& including) const {
        std::vector<fs::path> places = {including.parent_path(),
                                        canonical(including).parent_path(),  // behind a link
                                        deck_.parent_path(), canonical(deck_).parent_path()};
        places.insert(places.end(), paths_.begin(), paths_.end());
        std::error_code error;
        for (const fs::path& place : places)
            if (fs::is_regular_file(place / name, error)) return plain(place / name);
        return (including.parent_path() / name).lexically_normal();
    }

    [[nodiscard]] std::string cycle(const fs::path& back_to) const {
        std::string chain;
        bool in_cycle = false;
        for (const fs::path& file : open_files_) {
            in_cycle |= file == back_to;
            if (in_cycle) chain += file.filename().string() + " -> ";
        }
        return chain + back_to.filename().string();
    }

    void add_path(const Block& block, const fs::path& path) {
        const bool relative = block.keyword == "INCLUDE_PATH_RELATIVE";
        const fs::path& from = relative ? path : deck_;
        for (const FileName& file : file_names(block.lines))
            for (const fs::path& folder : {from.parent_path(), canonical(from).parent_path()})
                paths_.push_back(folder / file.name);
    }

    fs::path deck_;
    Parameters& parameters_;
    Faults& faults_;
    DeckText text_;
    std::vector<fs::path> open_files_;  ///< canonical, the deck first
    std::vector<fs::path> paths_;
    const Inclusion* inclusion_ = nullptr;  ///< that is being read, the nearest
    std::uintmax_t total_ = 0;
};

}  // namespace

DeckText read_keywords(const fs::path& deck, Parameters& parameters, Faults& faults) {
    return Reader(deck, parameters, faults).read();
}

}  // namespace corpuscle::io
