// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/file_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace corpuscle::io {

namespace {

using Eigen::Affine3d;

constexpr double FARTHEST = 1e100;                          ///< as far as a field may lie     [m]
constexpr double LEAST_LENGTH = 1e-30, MOST_LENGTH = 1e30;  ///< of a unit vector's image

/// The *INCLUDE_TRANSFORM around a node's card, or nullptr.
const Inclusion* file_of(Index node, const Draft& draft) {
    const auto& blocks = draft.node_files;
    const auto next =
        std::upper_bound(blocks.begin(), blocks.end(), node,
                         [](Index row, const auto& block) { return row < block.first; });
    return next == blocks.begin() ? nullptr : std::prev(next)->second;
}

/// Maps of files, each worked out when it is first asked for: rows that name nodes ask for those of
/// other files.
class Maps {
public:
    Maps(const DeckText& text, const Parameters& parameters, Faults& faults, const Draft& draft)
        : parameters_(parameters), faults_(faults), draft_(draft) {
        for (const Inclusion& file : text.inclusions)
            entries_[&file].row =
                transformation_of(file, draft.transformations, parameters_, faults_);
    }

    /// From the coordinates that a file is written in to those of the deck; nullptr: the deck.
    Affine3d whole(const Inclusion* file) {
        if (file == nullptr) return Affine3d::Identity();
        return whole(file->block.inclusion) * own(file);
    }
    [[nodiscard]] Index row(const Inclusion* file) const { return entries_.at(file).row; }

private:
    struct Entry {
        Index row = -1;  ///< of its transformation
        bool is_known = false, is_asked_for = false;
        Affine3d map = Affine3d::Identity();
    };

    /// To the coordinates of the file around it.
    Affine3d own(const Inclusion* file) {
        Entry& entry = entries_.at(file);
        if (entry.is_known || entry.row < 0) return entry.map;
        const auto& by = draft_.transformation[static_cast<std::size_t>(entry.row)];
        if (entry.is_asked_for) {
            faults_.begin_block();
            faults_.fault(
                file->block.place,
                fmt::format("*INCLUDE_TRANSFORM {}: *DEFINE_TRANSFORMATION {} has nodes "
                            "whose places depend on where this file lies, expected others",
                            file->name, by.id));
            entry.is_known = true;
            return entry.map;
        }
        entry.is_asked_for = true;
        const Affine3d map = by.map(
            [&](Index node, const Affine3d& so_far) { return node_place(file, node, so_far); },
            faults_);
        entry.is_known = true;
        return entry.map = map;
    }

    /// Nodes of the file are where it and the files within it put them, and what is done so far
    /// moves them on; others are where they are, as the file around sees them.
    Vec3 node_place(const Inclusion* file, Index node, const Affine3d& so_far) {
        const Vec3& x = draft_.model.x[static_cast<std::size_t>(node)];
        const Inclusion* of = file_of(node, draft_);
        Affine3d to_here = Affine3d::Identity();
        for (const Inclusion* at = of; at != nullptr; at = at->block.inclusion) {
            if (at == file) return so_far * (to_here * x);
            to_here = own(at) * to_here;
        }
        return whole(file->block.inclusion).inverse() * (to_here * x);
    }

    const Parameters& parameters_;
    Faults& faults_;
    const Draft& draft_;
    std::map<const Inclusion*, Entry> entries_;
};

/// Products of many rows may leave what numbers can hold.
bool is_sound(const Affine3d& map) {
    if (!map.matrix().allFinite() || !(map.translation().array().abs() <= FARTHEST).all())
        return false;
    const Eigen::RowVector3d lengths = map.linear().colwise().norm();
    return (lengths.array() >= LEAST_LENGTH).all() && (lengths.array() <= MOST_LENGTH).all();
}

std::string note_of(const Inclusion& file, Index row, const Draft& draft) {
    const std::string offsets = told(file.offsets);
    std::string place = "in its place";
    if (row >= 0)
        place = fmt::format("placed by *DEFINE_TRANSFORMATION {}",
                            draft.transformation[static_cast<std::size_t>(row)].id);
    if (file.block.inclusion != nullptr && file.block.inclusion->place.moves())
        place += ", then with the file around it";
    return fmt::format("*INCLUDE_TRANSFORM {}: ids {}; {}{}", file.name,
                       offsets.empty() ? "as written" : offsets, place,
                       file.place.mirrors() ? ", mirrored with the normals of its facets" : "");
}

void move_nodes(Draft& draft, Faults& faults) {
    for (std::size_t b = 0; b < draft.node_files.size(); ++b) {
        const auto [first, file] = draft.node_files[b];
        const std::size_t end = b + 1 < draft.node_files.size()
                                    ? static_cast<std::size_t>(draft.node_files[b + 1].first)
                                    : draft.model.x.size();
        if (file == nullptr || !file->place.moves()) continue;
        for (auto node = static_cast<std::size_t>(first); node < end; ++node) {
            Vec3& x = draft.model.x[node];
            x = file->place.point(x);
            if ((x.array().abs() <= FARTHEST).all()) continue;
            faults.fault(file->block.place,
                         fmt::format("*INCLUDE_TRANSFORM {} moves node {}, expected no farther "
                                     "than {:g}",
                                     file->name, draft.model.node_id[node], FARTHEST));
            x.setZero();
        }
    }
}

/// TC and RC of nodes, the only supports that are read so far.
void turn_supports(Draft& draft, Faults& faults) {
    for (Support& support : draft.model.supports) {
        const Inclusion* file = file_of(support.node, draft);
        if (file == nullptr || !file->place.turns()) continue;
        if (const auto held = file->place.held(support.fixed))
            support.fixed = *held;
        else
            faults.fault(file->block.place,
                         fmt::format("*INCLUDE_TRANSFORM {} turns node {}, expected TC and RC "
                                     "that hold it along axes of the deck",
                                     file->name,
                                     draft.model.node_id[static_cast<std::size_t>(support.node)]));
    }
}

}  // namespace

void place_files(DeckText& text, const Parameters& parameters, Faults& faults, Draft& draft) {
    if (text.inclusions.empty()) return;
    Maps maps(text, parameters, faults, draft);
    for (Inclusion& file : text.inclusions) {
        const Affine3d map = maps.whole(&file);
        if (is_sound(map)) {
            file.place = FilePlace(map.linear(), map.translation());
        } else {
            faults.begin_block();
            faults.fault(file.block.place,
                         fmt::format("*INCLUDE_TRANSFORM {}, expected a transformation that keeps "
                                     "lengths within {:g} and {:g} times what they are",
                                     file.name, LEAST_LENGTH, MOST_LENGTH));
        }
        faults.note(file.block.place, note_of(file, maps.row(&file), draft));
        if (file.place.stretches())
            faults.warn(file.block.place,
                        fmt::format("*INCLUDE_TRANSFORM {}: SCALE acts on places alone; thickness, "
                                    "radii, areas, masses, velocities and curves stay as written",
                                    file.name));
    }
    faults.begin_block();
    move_nodes(draft, faults);
    turn_supports(draft, faults);
}

}  // namespace corpuscle::io
