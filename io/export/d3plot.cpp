// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/d3plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "io/export/d3plot_particles.hpp"
#include "io/export/history_source.hpp"
#include "io/results/results_content.hpp"

namespace corpuscle::io {
namespace {

using Lines = std::vector<double>;

constexpr float END_MARK = -999999.0F;
constexpr std::size_t STRESSES = 6, EXTRAS = 1, STRAINS = 12;  ///< strains: inner, outer face
constexpr int IS_THERE = 1000, IS_NOT_THERE = 999;
constexpr std::size_t RUN_TIME = 10, SOURCE = 12, RELEASE = 13;  ///< control words that stay 0
/// Of LS-DYNA, as a number: readers tell word size and byte order by it.
constexpr std::size_t VERSION = 14;
constexpr float VERSION_HERE = 960.0F;

class Writer {
public:
    Writer(const Hdf5Reader& results, const D3plotFile& write, bool has_particles)
        : results_(results),
          write_(write),
          node_id_(results.read<std::int32_t>("/mesh/node_id")),
          shell_id_(results.read<std::int32_t>("/mesh/shell_id")),
          shell_part_(results.read<std::int32_t>("/mesh/shell_part")),
          parts_(shell_part_),
          titles_(part_titles(results)) {
        if (has_particles) particles_.emplace(results);
        std::sort(parts_.begin(), parts_.end());
        parts_.erase(std::unique(parts_.begin(), parts_.end()), parts_.end());
    }

    void write() {
        D3plotWords file;
        header(file);
        if (particles_) particles_->variables(file);
        geometry(file);
        numbering(file);
        if (particles_) particles_->bags(file);
        titles(file);
        write_("d3plot", std::move(file).padded());
        const Lines time = results_.read<double>("/frames/time");
        std::size_t frame = 0;
        for (const std::string& group : frame_groups(results_)) {
            D3plotWords state;
            this->state(state, group, time.at(frame));
            write_(fmt::format("d3plot{:02}", ++frame), std::move(state).padded());
        }
    }

private:
    [[nodiscard]] std::size_t numbering_size() const {
        return 16 + node_id_.size() + shell_id_.size() + 3 * parts_.size();
    }

    void header(D3plotWords& file) {
        file.text(results_.text("/", "deck"), 10);
        std::array<std::int64_t, 64> word{};
        const auto parts = static_cast<std::int64_t>(parts_.size());
        word[11] = 1;  // this is a d3plot
        word[15] = 4;  // three dimensions, five words a shell
        word[16] = static_cast<std::int64_t>(node_id_.size());
        word[17] = 6;  // written as LS-DYNA does
        word[18] = 6 + 7 * parts;
        word[20] = word[21] = 1;  // coordinates and velocities in every state
        word[31] = static_cast<std::int64_t>(shell_id_.size());
        word[32] = parts;
        word[33] = STRESSES + EXTRAS + STRAINS;  // values a shell; that many tell of strains
        word[35] = EXTRAS;
        word[36] = -(10000 + 1);  // one point of integration, a table of deleted elements
        word[39] = static_cast<std::int64_t>(numbering_size());
        word[43] = IS_THERE;                            // stresses
        word[44] = word[45] = word[46] = IS_NOT_THERE;  // plastic strain, resultants, thickness
        word[51] = parts;
        word[54] = particles_ ? particles_->flag() : 0;
        word[VERSION] = std::bit_cast<std::int32_t>(VERSION_HERE);
        for (std::size_t k = 10; k < word.size(); ++k) file.integer(word[k]);
    }

    void geometry(D3plotWords& file) {
        file.reals(results_.read<double>("/mesh/coordinates"));
        const auto nodes = results_.read<std::int32_t>("/mesh/shell_nodes");
        for (std::size_t s = 0; s < shell_id_.size(); ++s) {
            for (std::size_t c = 0; c < 4; ++c) file.integer(nodes[4 * s + c] + 1);
            const auto part = std::lower_bound(parts_.begin(), parts_.end(), shell_part_[s]);
            file.integer(part - parts_.begin() + 1);
        }
    }

    /// The deck's own ids: 16 words of where is what, nodes, shells, parts sorted, as they are,
    /// and where the sorted ones are.
    void numbering(D3plotWords& file) {
        const auto nodes = static_cast<std::int64_t>(node_id_.size());
        const auto shells = static_cast<std::int64_t>(shell_id_.size());
        const auto parts = static_cast<std::int64_t>(parts_.size());
        const std::int64_t after = 1 + nodes + shells;
        for (const std::int64_t word :
             {std::int64_t{-1}, 1 + nodes, 1 + nodes, 1 + nodes, after, nodes, std::int64_t{0},
              std::int64_t{0}, shells, std::int64_t{0}, after, after + parts, after + 2 * parts,
              parts, std::int64_t{0}, parts})
            file.integer(word);
        for (const std::int32_t id : node_id_) file.integer(id);
        for (const std::int32_t id : shell_id_) file.integer(id);
        for (int twice = 0; twice < 2; ++twice)
            for (const std::int32_t id : parts_) file.integer(id);
        for (std::int64_t k = 1; k <= parts; ++k) file.integer(k);
    }

    /// Behind the end mark; the parts' come first, for VTK's reader takes the first table for theirs.
    void titles(D3plotWords& file) {
        file.real(END_MARK);
        file.integer(90001);
        file.integer(static_cast<std::int64_t>(parts_.size()));
        for (const std::int32_t id : parts_) {
            file.integer(id);
            const auto title = titles_.find(id);
            file.text(title != titles_.end() && !title->second.empty() ? title->second
                                                                       : fmt::format("part {}", id),
                      18);
        }
        file.integer(90000);
        file.text(results_.text("/", "deck"), 18);
        file.real(END_MARK);
    }

    void state(D3plotWords& file, const std::string& at, double time) {
        file.real(time);
        const std::size_t row = row_at(time);
        globals(file, row);
        file.reals(results_.read<double>(at + "coordinates"));
        file.reals(results_.read<double>(at + "velocity"));
        const Lines stress = results_.read<double>(at + "shell_stress");
        const Lines strain = results_.read<double>(at + "shell_strain");
        const Lines pressure = results_.read<double>(at + "shell_pressure");
        const auto six = [&](const Lines& of, std::size_t s) {  // xx, yy, zz, xy, yz, zx
            for (const double value : {of[3 * s], of[3 * s + 1], 0.0, of[3 * s + 2], 0.0, 0.0})
                file.real(value);
        };
        for (std::size_t s = 0; s < shell_id_.size(); ++s) {
            six(stress, s);
            file.real(pressure[s]);
            six(strain, s);  // of the inner face, and of the outer: a membrane has one
            six(strain, s);
        }
        for (const std::uint8_t is_alive : results_.read<std::uint8_t>(at + "shell_active"))
            file.real(is_alive);
        if (particles_) particles_->state(file, at, row);
        file.real(END_MARK);
    }

    /// The nearest row of the histories.
    [[nodiscard]] std::size_t row_at(double time) const {
        const Lines times = results_.read<double>("/history/time");
        std::size_t row = 0;
        for (std::size_t k = 1; k < times.size(); ++k)
            if (std::abs(times[k] - time) < std::abs(times[row] - time)) row = k;
        return row;
    }

    /// Energies of a row of the histories.
    void globals(D3plotWords& file, std::size_t row) {
        const auto value = [&](const std::string& path) {
            if (!results_.has(path)) return 0.0;
            const Lines values = results_.read<double>(path);
            return row < values.size() ? values[row] : 0.0;
        };
        file.real(value("/history/energy/kinetic"));
        file.real(value("/history/energy/strain") + value("/history/energy/gas"));
        file.real(value("/history/energy/total"));
        for (int axis = 0; axis < 3; ++axis) file.real(0.0);
        for (const char* of : {"strain_energy", "kinetic_energy"})
            for (const std::int32_t id : parts_)
                file.real(value(fmt::format("/history/part/{}/{}", id, of)));
        for (std::size_t k = 0; k < 5 * parts_.size(); ++k) file.real(0.0);
    }

    const Hdf5Reader& results_;
    const D3plotFile& write_;
    std::vector<std::int32_t> node_id_, shell_id_, shell_part_, parts_;
    std::map<int, std::string> titles_;
    std::optional<D3plotParticles> particles_;
};

}  // namespace

void write_d3plot(const Hdf5Reader& results, const D3plotFile& write, bool has_particles) {
    Writer(results, write, has_particles).write();
}

bool is_own_d3plot(std::string_view beginning) {
    if (beginning.size() < 4 * (VERSION + 1)) return false;
    const auto word = [&](std::size_t k) {
        std::int32_t value = 0;
        std::memcpy(&value, beginning.data() + 4 * k, 4);
        return value;
    };
    return word(RUN_TIME) == 0 && word(SOURCE) == 0 && word(RELEASE) == 0 &&
           word(VERSION) == std::bit_cast<std::int32_t>(VERSION_HERE);
}

}  // namespace corpuscle::io
