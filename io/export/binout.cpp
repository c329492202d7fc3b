// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/binout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "io/export/history_source.hpp"
#include "io/export/lsda.hpp"

namespace corpuscle::io {
namespace {

constexpr std::array AXES{"x", "y", "z"};
constexpr std::string_view UNDATED = "\4date-";  ///< length of a name, name, value

/// The histories by path.
class Rows {
public:
    explicit Rows(const Hdf5Reader& results) {
        for (History& history : read_histories(results, "/history"))
            all_.emplace(history.path, std::move(history));
    }
    [[nodiscard]] std::size_t count() const { return all_.at("time").values.size(); }
    [[nodiscard]] double at(const std::string& path, std::size_t row, std::size_t axis = 0) const {
        const History& history = all_.at(path);
        return history.values[row * history.columns + axis];
    }
    /// Ids below a group, ascending.
    [[nodiscard]] std::vector<std::int32_t> ids(const std::string& group) const {
        std::vector<std::int32_t> found;
        for (const auto& [path, history] : all_) {
            if (!path.starts_with(group + "/")) continue;
            const int id = std::stoi(path.substr(group.size() + 1));
            if (std::find(found.begin(), found.end(), id) == found.end()) found.push_back(id);
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    /// Is it other than 0 in some row?
    [[nodiscard]] bool is_ever(const std::string& path) const {
        const std::vector<double>& values = all_.at(path).values;
        return std::any_of(values.begin(), values.end(), [](double v) { return v != 0.0; });
    }
    /// Change per time since the row before; 0 in the first.
    [[nodiscard]] double rate(const std::string& path, std::size_t row) const {
        if (row == 0) return 0.0;
        return (at(path, row) - at(path, row - 1)) / (at("time", row) - at("time", row - 1));
    }

private:
    std::map<std::string, History> all_;
};

class Binout {
public:
    explicit Binout(const Hdf5Reader& results)
        : rows_(results),
          version_(results.text("/", "version")),
          deck_(results.text("/", "deck")) {}

    std::string write() {
        branch("glstat", {}, [&](std::size_t row) { glstat(row); });
        for_ids("part", "matsum", [&](std::size_t row) { matsum(row); });
        for_ids("airbag", "abstat", [&](std::size_t row) { abstat(row); });
        abstat_cpm();
        for_ids("rigid_body", "rbdout", [&](std::size_t row) { rbdout(row); });
        for_ids("contact", "rcforc", [&](std::size_t row) { rcforc(row); });
        for_ids("rigidwall", "rwforc/forces", [&](std::size_t row) { rwforc(row); });
        for_ids("joint", "jntforc/joints", [&](std::size_t row) { jntforc(row); });
        for_ids("node", "nodout", [&](std::size_t row) { nodout(row); });
        return lsda_.finish();
    }

private:
    using State = std::function<void(std::size_t row)>;

    void for_ids(const std::string& group, const std::string& name, const State& state) {
        group_ = group;
        ids_ = rows_.ids(group);
        if (!ids_.empty()) branch(name, ids_, state);
    }
    void branch(const std::string& name, const std::vector<std::int32_t>& ids, const State& state) {
        lsda_.folder(fmt::format("/{}/metadata", name));
        lsda_.write("title", std::string_view(deck_));
        lsda_.write("version", std::string_view(version_));
        lsda_.write("date", std::string_view("-"));  // UNDATED
        if (!ids.empty()) lsda_.write("ids", std::span(ids));
        const std::vector<std::int32_t> in_global_axes(ids.size(), 0);
        if (name == "jntforc/joints") lsda_.write("local", std::span(in_global_axes));
        for (std::size_t row = 0; row < rows_.count(); ++row) {
            lsda_.folder(fmt::format("/{}/d{:06}", name, row + 1));
            lsda_.write("time", rows_.at("time", row));
            lsda_.write("cycle", static_cast<std::int32_t>(row));
            if (!ids.empty() && name != "rwforc/forces") lsda_.write("ids", std::span(ids));
            state(row);
        }
    }
    [[nodiscard]] std::string path(std::int32_t id, const std::string& name) const {
        return fmt::format("{}/{}/{}", group_, id, name);
    }
    /// One value an id.
    void column(std::string_view name, const std::function<double(std::int32_t)>& value) {
        std::vector<double> values;
        for (const std::int32_t id : ids_) values.push_back(value(id));
        lsda_.write(name, std::span<const double>(values));
    }
    /// One history an id.
    void column(std::string_view name, const std::string& history, std::size_t row,
                std::size_t axis = 0) {
        column(name, [&](std::int32_t id) { return rows_.at(path(id, history), row, axis); });
    }

    void glstat(std::size_t row) {
        const auto book = [&](const char* name) {
            return rows_.at(fmt::format("energy/{}", name), row);
        };
        const auto outside = [&](std::size_t r) {
            const auto at = [&](const char* name) {
                return rows_.at(fmt::format("energy/{}", name), r);
            };
            return at("external") + at("inflow") - at("outflow") - at("ambient");
        };
        const double inside = book("total") - book("outflow") - book("ambient");
        const double start = rows_.at("energy/total", 0) - rows_.at("energy/outflow", 0) -
                             rows_.at("energy/ambient", 0);
        const double work = outside(row) - outside(0);
        lsda_.write("kinetic_energy", book("kinetic"));
        lsda_.write("internal_energy", book("strain") + book("gas") + book("smoothing"));
        lsda_.write("sliding_interface_energy", book("contact") + book("friction"));
        lsda_.write("system_damping_energy", book("damping"));
        lsda_.write("external_work", work);
        lsda_.write("total_energy", inside);
        lsda_.write("energy_ratio", start + work == 0.0 ? 1.0 : inside / (start + work));
    }
    void matsum(std::size_t row) {
        column("internal_energy", "strain_energy", row);
        column("kinetic_energy", "kinetic_energy", row);
        for (std::size_t a = 0; a < 3; ++a)
            column(fmt::format("{}_momentum", AXES[a]), "momentum", row, a);
    }
    void abstat(std::size_t row) {
        column("volume", "volume", row);
        column("pressure", "pressure", row);
        column("internal_energy", "energy", row);
        column("dm_dt_in", [&](std::int32_t id) { return rows_.rate(path(id, "mass_in"), row); });
        column("dm_dt_out", [&](std::int32_t id) {
            return rows_.rate(path(id, "mass_out_vent"), row) +
                   rows_.rate(path(id, "mass_out_fabric"), row);
        });
        column("density", [&](std::int32_t id) {
            return rows_.at(path(id, "mass"), row) / rows_.at(path(id, "volume"), row);
        });
        column("total_mass", "mass", row);
        column("gas_temp", "temperature", row);
        column("surface_area", [&](std::int32_t id) {
            double area = 0.0;
            for (const std::int32_t part : rows_.ids(path(id, "part")))
                area += rows_.at(path(id, fmt::format("part/{}/area", part)), row);
            return area;
        });
        column("reaction", [](std::int32_t) { return 0.0; });
    }
    /// Bags that ever held particles, and what presses on their parts.
    void abstat_cpm() {
        group_ = "airbag";
        ids_ = rows_.ids(group_);
        std::erase_if(ids_, [&](std::int32_t id) { return !rows_.is_ever(path(id, "particles")); });
        if (ids_.empty()) return;
        std::vector<std::int32_t> parts, count;
        std::vector<std::string> of;  // the parts' groups, bag by bag
        for (const std::int32_t id : ids_) {
            const std::vector<std::int32_t> own = rows_.ids(path(id, "part"));
            count.push_back(static_cast<std::int32_t>(own.size()));
            for (const std::int32_t part : own) {
                parts.push_back(part);
                of.push_back(path(id, fmt::format("part/{}/", part)));
            }
        }
        const auto of_parts = [&](const char* name, const char* history, std::size_t row) {
            std::vector<double> values;
            for (const std::string& part : of) values.push_back(rows_.at(part + history, row));
            lsda_.write(name, std::span<const double>(values));
        };
        branch("abstat_cpm", ids_, [&](std::size_t row) {
            abstat(row);
            column("Trans_ke", "translational_energy", row);
            lsda_.folder(fmt::format("/abstat_cpm/d{:06}/bag_data", row + 1));
            of_parts("pressure", "pressure", row);
            of_parts("area_tot", "area", row);
        });
        lsda_.folder("/abstat_cpm/metadata");
        lsda_.write("nparts", std::span<const std::int32_t>(count));
        lsda_.write("pid", std::span<const std::int32_t>(parts));
    }
    void rbdout(std::size_t row) {
        for (std::size_t a = 0; a < 3; ++a) {
            column(fmt::format("global_{}", AXES[a]), "position", row, a);
            column(fmt::format("global_d{}", AXES[a]), [&](std::int32_t id) {
                return rows_.at(path(id, "position"), row, a) -
                       rows_.at(path(id, "position"), 0, a);
            });
            column(fmt::format("global_v{}", AXES[a]), "velocity", row, a);
            column(fmt::format("global_a{}", AXES[a]), "acceleration", row, a);
        }
    }
    void rcforc(std::size_t row) {
        const std::vector<std::int32_t> side(ids_.size(), 0);
        lsda_.write("side", std::span(side));
        for (std::size_t a = 0; a < 3; ++a)
            column(fmt::format("{}_force", AXES[a]), "force", row, a);
    }
    void rwforc(std::size_t row) {
        for (std::size_t a = 0; a < 3; ++a)
            column(fmt::format("{}_force", AXES[a]), "force", row, a);
    }
    void jntforc(std::size_t row) {
        for (const char* of : {"force", "moment"}) {
            for (std::size_t a = 0; a < 3; ++a)
                column(fmt::format("{}_{}", AXES[a], of), of, row, a);
            column(fmt::format("resultant_{}", of), [&](std::int32_t id) {
                return std::hypot(rows_.at(path(id, of), row, 0), rows_.at(path(id, of), row, 1),
                                  rows_.at(path(id, of), row, 2));
            });
        }
    }
    void nodout(std::size_t row) {
        for (std::size_t a = 0; a < 3; ++a) {
            column(fmt::format("{}_coordinate", AXES[a]), "coordinates", row, a);
            column(fmt::format("{}_displacement", AXES[a]), [&](std::int32_t id) {
                return rows_.at(path(id, "coordinates"), row, a) -
                       rows_.at(path(id, "coordinates"), 0, a);
            });
            column(fmt::format("{}_velocity", AXES[a]), "velocity", row, a);
        }
    }

    Rows rows_;
    std::string version_, deck_, group_;
    std::vector<std::int32_t> ids_;
    LsdaWriter lsda_;
};

}  // namespace

std::string binout(const Hdf5Reader& results) {
    return Binout(results).write();
}

bool is_own_binout(std::string_view beginning) {
    return beginning.find(UNDATED) != std::string_view::npos;
}

}  // namespace corpuscle::io
