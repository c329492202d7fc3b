// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/runs/scene_outside.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "gas/bag_gas.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/enclosure/inside.hpp"
#include "io/deck.hpp"
#include "io/results/hdf5.hpp"
#include "solver/simulation.hpp"
#include "tests/support/geometry/inside.hpp"

namespace corpuscle::test {
namespace {

constexpr double ROUNDING = 1e-9;  ///< of the surface's size

Points points_of(const std::vector<double>& rows) {
    Points points;
    for (std::size_t i = 0; i < rows.size(); i += 3)
        points.emplace_back(rows[i], rows[i + 1], rows[i + 2]);
    return points;
}

/// A bag's surface in one frame. The columns of gas/enclosure/inside.hpp let pass what they find
/// inside; the sum of solid angles judges the others.
class Surface {
public:
    Surface(const std::vector<Triangle>& outward, const Points& x) : columns_(outward, x) {
        for (const auto& [a, b, c] : outward) triangles_.push_back({x[a], x[b], x[c]});
        slack_ = ROUNDING * (columns_.high() - columns_.low()).maxCoeff();
    }
    [[nodiscard]] bool holds(const Vec3& point) const {
        return columns_.winding(point).value_or(0) > 0 ||
               oracle::is_inside(point, triangles_, slack_);
    }

private:
    gas::InsideTest columns_;
    std::vector<std::array<Vec3, 3>> triangles_;
    double slack_;
};

}  // namespace

Outside particles_outside(const std::filesystem::path& deck, const std::filesystem::path& results) {
    const Simulation start(io::read_deck(deck));
    const io::Hdf5Reader file(results);
    Outside all;
    for (const std::string& name : file.names("/frames")) {
        const std::string frame = "/frames/" + name;
        if (name == "time" || !file.has(frame + "/particles")) continue;
        const Points x = points_of(file.read<double>(frame + "/coordinates")),
                     gas = points_of(file.read<double>(frame + "/particles/position"));
        const auto of_bag = file.read<std::int32_t>(frame + "/particles/bag");
        all.seen += gas.size();
        for (const gas::BagGas& bag : start.bags()) {
            const Surface surface(bag.enclosure().triangles(), x);
            for (std::size_t i = 0; i < gas.size(); ++i)
                if (of_bag[i] == bag.card().id && !surface.holds(gas[i])) ++all.particles;
        }
    }
    return all;
}

}  // namespace corpuscle::test
