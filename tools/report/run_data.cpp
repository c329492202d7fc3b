// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/report/run_data.hpp"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "io/export/history_source.hpp"
#include "io/responses/body_responses.hpp"
#include "io/results/hdf5.hpp"
#include "io/results/results_content.hpp"
#include "io/text/json.hpp"
#include "tools/report/labels.hpp"
#include "tools/report/pack.hpp"
#include "tools/report/picture.hpp"

namespace corpuscle::report {
namespace {

namespace fs = std::filesystem;
using io::json;

class Packer {
public:
    explicit Packer(const fs::path& folder) : folder_(folder), file_(folder / "results.h5") {}

    RunData pack() {
        settings();
        mesh();
        frames();
        histories();
        responses();
        summary();
        return {fmt::format("{{{}}}", fmt::join(members_, ",\n")), blob_.bytes(), frames_};
    }

private:
    void member(const std::string& name, const std::string& value) {
        members_.push_back(json(name) + ": " + value);
    }

    void settings() {
        member("name", json(fs::path(folder_ / ".").parent_path().filename().string()));
        for (const char* name : {"program", "version", "deck", "unit_system", "termination"})
            member(name, json(file_.text("/", name)));
        member("seed", fmt::format("\"{}\"", file_.number<std::uint64_t>("/", "seed")));
        member("threads", fmt::format("{}", file_.number<std::int32_t>("/", "threads")));
        system_ = file_.text("/", "unit_system");
        member("up", json(file_.has_attribute("/", "up") ? file_.text("/", "up") : "z"));
        titles();
    }

    void titles() {
        std::vector<std::string> entries;
        titles_ = io::part_titles(file_);
        for (const auto& [id, title] : titles_)
            entries.push_back(fmt::format("\"{}\":{}", id, json(title)));
        member("part_titles", fmt::format("{{{}}}", fmt::join(entries, ",")));
    }

    [[nodiscard]] io::SpokenUnit unit(io::Quantity quantity) const {
        return io::spoken(quantity, system_);
    }
    /// Stress is said in MPa.
    [[nodiscard]] io::SpokenUnit stress_unit() const {
        io::SpokenUnit of = unit(io::Quantity::PRESSURE);
        return of.unit == "kPa" ? io::SpokenUnit{1e-3 * of.factor, "MPa"} : of;
    }

    void mesh() {
        const auto nodes = file_.read<std::int32_t>("/mesh/shell_nodes");
        const auto part = file_.read<std::int32_t>("/mesh/shell_part");
        std::vector<std::uint32_t> corners, shell;
        for (std::size_t s = 0; s < part.size(); ++s) {
            const auto* n = &nodes[4 * s];
            const auto triangle = [&](int a, int b, int c) {
                for (const int k : {a, b, c}) corners.push_back(static_cast<std::uint32_t>(n[k]));
                shell.push_back(static_cast<std::uint32_t>(s));
            };
            triangle(0, 1, 2);
            if (n[3] != n[2]) triangle(0, 2, 3);
        }
        member("nodes", fmt::format("{}", file_.shape("/mesh/node_id").at(0)));
        member("shells", fmt::format("{}", part.size()));
        member("shell_part", fmt::format("[{}]", fmt::join(part, ",")));
        member("triangles", fmt::format("{}", shell.size()));
        member("corners_at", fmt::format("{}", blob_.add(corners)));
        member("shell_of_at", fmt::format("{}", blob_.add(shell)));
    }

    /// Twice through the frames: once for ranges, once to pack; never more than one in memory.
    void frames() {
        const Lines all = file_.read<double>("/frames/time");
        const std::size_t every = stride(all.size(), MOST_FRAMES);
        std::vector<std::size_t> shown;
        for (std::size_t f = 0; f < all.size(); ++f)
            if (f % every == 0 || f + 1 == all.size()) shown.push_back(f);
        const std::vector<std::string> names = io::frame_groups(file_);
        PictureRanges ranges;
        for (const std::size_t f : shown) ranges.take(read_picture(file_, names.at(f)));
        std::vector<std::uint16_t> before;
        std::vector<std::string> entries;
        for (const std::size_t f : shown)
            entries.push_back(frame(read_picture(file_, names.at(f)), all[f], ranges, before));
        member("frames", fmt::format("[{}]", fmt::join(entries, ",\n")));
        member("frames_in_file", fmt::format("{}", all.size()));
        say(ranges);
        units();
    }

    /// Packs one frame; returns its entry.
    /// @param before  places in the frame before; then those of this one
    std::string frame(const Picture& picture, double t, const PictureRanges& ranges,
                      std::vector<std::uint16_t>& before) {
        const std::vector<std::uint16_t> x = ranges.quantised(picture.x);
        const std::vector<std::uint8_t> species(picture.species.begin(), picture.species.end());
        Blob blob;
        std::string entry =
            fmt::format("\"t\":{},\"x\":{},\"pressure\":{},\"stress\":{}",
                        json(unit(io::Quantity::TIME).factor * t), blob.add(change(x, before)),
                        blob.add(in_bytes(picture.pressure, ranges.pressure)),
                        blob.add(in_bytes(picture.stress, ranges.stress)));
        if (!ranges.contact.is_empty)
            entry +=
                fmt::format(",\"contact\":{}", blob.add(in_bytes(picture.contact, ranges.contact)));
        entry += fmt::format(",\"count\":{},\"particles\":{},\"species\":{},\"speed\":{}",
                             species.size(), blob.add(ranges.quantised(picture.particles)),
                             blob.add(species), blob.add(in_bytes(picture.speed, ranges.speed)));
        if (!ranges.temperature.is_empty)
            entry += fmt::format(",\"temperature\":{}",
                                 blob.add(in_bytes(picture.temperature, ranges.temperature)));
        frames_.push_back(blob.bytes());
        before = x;
        return "{" + entry + "}";
    }

    void say(const PictureRanges& ranges) {
        const auto range = [](const Range& r, const io::SpokenUnit& in) {
            return fmt::format("[{},{}]", json(in.factor * r.low), json(in.factor * r.high));
        };
        const io::SpokenUnit deck, kPa = unit(io::Quantity::PRESSURE);
        const auto& box = ranges.box;
        member("box", fmt::format("[{},{},{}]", range(box[0], deck), range(box[1], deck),
                                  range(box[2], deck)));
        const std::string touching =
            ranges.contact.is_empty ? ""
                                    : fmt::format("\"contact\":{},", range(ranges.contact, kPa));
        const std::string heat =
            ranges.temperature.is_empty
                ? ""
                : fmt::format(",\"temperature\":{}",
                              range(ranges.temperature, unit(io::Quantity::TEMPERATURE)));
        member("ranges",
               fmt::format("{{\"pressure\":{},\"stress\":{},{}\"speed\":{}{}}}",
                           range(ranges.pressure, kPa), range(ranges.stress, stress_unit()),
                           touching, range(ranges.speed, unit(io::Quantity::VELOCITY)), heat));
    }

    void units() {
        using enum io::Quantity;
        member("units",
               fmt::format("{{\"time\":{},\"length\":{},\"pressure\":{},\"stress\":{},\"speed\":{},"
                           "\"temperature\":{}}}",
                           json(unit(TIME).unit), json(io::unit_of(LENGTH, system_)),
                           json(unit(PRESSURE).unit), json(stress_unit().unit),
                           json(unit(VELOCITY).unit), json(unit(TEMPERATURE).unit)));
    }

    /// Pressure outside of the airbag that a history is of; NaN: it is no pressure of one, or what
    /// is outside is not known.
    [[nodiscard]] double outside(const std::string& path) const {
        std::istringstream words(path);
        std::string group, id, last;
        std::getline(words, group, '/');
        std::getline(words, id, '/');
        last = path.substr(path.rfind('/') + 1);
        const std::string name = "ambient_pressure_" + id;
        if (group != "airbag" || last != "pressure" || !file_.has_attribute("/", name)) return NaN;
        return file_.number<double>("/", name);
    }

    void histories() {
        std::vector<std::string> entries;
        std::size_t rows = 0;
        for (const io::History& history : io::read_histories(file_, "/history")) {
            rows = history.values.size() / history.columns;
            const io::SpokenUnit in = io::spoken(history.unit, system_);
            const auto add = [&](const std::string& name, const std::string& label, std::size_t c,
                                 double less) {
                std::vector<float> column;
                for (std::size_t row = 0; row < rows; ++row)
                    column.push_back(static_cast<float>(
                        in.factor * (history.values[row * history.columns + c] - less)));
                entries.push_back(fmt::format("{{\"name\":{},\"label\":{},\"unit\":{},\"at\":{}}}",
                                              json(name), json(label), json(in.unit),
                                              blob_.add(column)));
            };
            for (std::size_t c = 0; c < history.columns; ++c) {
                const std::string name = history.columns == 1
                                             ? history.path
                                             : fmt::format("{}.{}", history.path, "xyz"[c]);
                const std::string label = label_of(name, titles_);
                const double less = outside(name);
                if (std::isnan(less)) {
                    add(name, label, c, 0.0);
                    continue;
                }
                add(name + "_gauge", label + ", gauge", c, less);
                add(name, label + ", absolute", c, 0.0);
            }
        }
        member("rows", fmt::format("{}", rows));
        member("histories", fmt::format("[{}]", fmt::join(entries, ",\n")));
    }

    void responses() {
        std::vector<io::BodyTable> tables;
        const bool is_sampled =
            file_.has("/history_fast/time") && file_.shape("/history_fast/time").at(0) > 1;
        if (is_sampled)
            for (const int id : io::tracked_bodies(file_))
                tables.push_back({id, io::body_responses(io::read_motion(file_, id),
                                                         file_.text("/", "unit_system"))});
        member("responses", io::responses_json(tables));
    }

    /// Warnings and timings, as the run left them beside its results.
    void summary() {
        std::ifstream in(folder_ / "run.json");
        std::stringstream text;
        text << in.rdbuf();
        member("summary", text.str().empty() ? "null" : text.str());
    }

    fs::path folder_;
    io::Hdf5Reader file_;
    Blob blob_;
    std::vector<std::string> frames_;
    std::vector<std::string> members_;
    std::string system_;  ///< of units
    std::map<int, std::string> titles_;
};

}  // namespace

RunData run_data(const fs::path& folder) {
    return Packer(folder).pack();
}

}  // namespace corpuscle::report
