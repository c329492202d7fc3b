// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/frame_crossings.hpp"

#include <algorithm>

#include "contact/broad_phase/intersections.hpp"
#include "io/results/hdf5.hpp"
#include "io/results/results_content.hpp"

namespace corpuscle::verify {

FrameCrossings frame_crossings(const std::filesystem::path& results) {
    const io::Hdf5Reader file(results);
    const auto corners = file.read<std::int32_t>("/mesh/shell_nodes");
    std::vector<Triangle> triangles;
    for (std::size_t s = 0; s < corners.size(); s += 4) {
        triangles.push_back({corners[s], corners[s + 1], corners[s + 2]});
        if (corners[s + 2] != corners[s + 3])
            triangles.push_back({corners[s], corners[s + 2], corners[s + 3]});
    }
    const auto frame = [&](const std::string& group) {
        const auto x = file.read<double>(group + "coordinates");
        Points points;
        for (std::size_t i = 0; i < x.size(); i += 3) points.emplace_back(x[i], x[i + 1], x[i + 2]);
        return points;
    };
    const contact::Patches patches = contact::make_patches(frame("/frames/00000/"), triangles);
    FrameCrossings all;
    for (const std::string& group : io::frame_groups(file)) {
        const std::size_t here = contact::crossings(triangles, patches, frame(group)).size();
        ++all.frames;
        all.crossings += here;
        all.worst = std::max(all.worst, here);
    }
    return all;
}

}  // namespace corpuscle::verify
