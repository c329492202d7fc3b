// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/held_bodies.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <optional>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/model/loose_ends.hpp"
#include "solver/bodies/rigid_parts.hpp"

namespace corpuscle::io {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Row6 = Eigen::Matrix<double, 1, 6>;

constexpr double ROUNDING = 1e-9;

/// A body and the supports of its nodes.
struct HeldBody {
    Index lead = -1;
    std::vector<Index> nodes;
    std::vector<Support> supports;
};

std::string name_of_part(const Draft& draft, Index part) {
    return fmt::format("*PART {}", draft.model.parts[static_cast<std::size_t>(part)].id);
}

std::vector<HeldBody> held_bodies(const Draft& draft) {
    const Model& model = draft.model;
    std::vector<std::vector<Support>> of_node(model.x.size());
    for (const Support& support : model.supports)
        if (support.node >= 0) of_node[static_cast<std::size_t>(support.node)].push_back(support);
    std::vector<HeldBody> bodies;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        if (!keywords::is_rigid(draft, part) || keywords::lead_of(draft, part) != part) continue;
        HeldBody body{part, nodes_of_rigid_parts(model, merged_parts(model, part)), {}};
        for (const Index node : body.nodes)
            for (const Support& support : of_node[static_cast<std::size_t>(node)])
                if (support.fixed != 0) body.supports.push_back(support);
        if (!body.supports.empty()) bodies.push_back(std::move(body));
    }
    return bodies;
}

/// Velocities and spins, six numbers about a node, that are held: the rows that supports make of
/// them, put together.
class HeldMotions {
public:
    HeldMotions(const Points& x, const HeldBody& body) : origin_(x[body.nodes.front()]) {
        for (const Index n : body.nodes) extent_ = std::max(extent_, (x[n] - origin_).norm());
        if (extent_ == 0.0) extent_ = 1.0;
        for (const Support& support : body.supports)
            for (int k = 0; k < 3; ++k) {
                if ((support.fixed >> k & 1U) != 0) add(row(x[support.node], k));
                if ((support.fixed >> (k + 3) & 1U) != 0) add(Row6::Unit(k + 3));
            }
        // a turn that moves no node is nobody's
        for (int k = 3; k < 6; ++k)
            if (std::all_of(body.nodes.begin(), body.nodes.end(), [&](Index n) {
                    return Vec3::Unit(k - 3).cross(x[n] - origin_).norm() < ROUNDING * extent_;
                }))
                add(Row6::Unit(k));
    }
    /// Bits 0-2: x, y, z; 3-5: about them; nothing where what is left free is none of these.
    [[nodiscard]] std::optional<DofMask> mask() const {
        const Eigen::CompleteOrthogonalDecomposition<Matrix6> rows(sum_);
        const Matrix6 held = rows.pseudoInverse() * sum_;  // projects on the rows
        DofMask fixed = 0;
        for (int k = 0; k < 6; ++k) {
            if (held(k, k) > 1.0 - ROUNDING)
                fixed |= 1U << k;
            else if (held(k, k) > ROUNDING)
                return {};
        }
        // about another place a turn is a move across its axis too
        for (int k = 0; k < 3; ++k)
            for (int m = 0; m < 3; ++m)
                if (m != k && (fixed >> (k + 3) & 1U) == 0 && (fixed >> m & 1U) != 0) return {};
        return fixed;
    }

private:
    /// Along axis k of a place: (v + w x r) · e_k = e_k · v + (r x e_k) · w.
    [[nodiscard]] Row6 row(const Vec3& place, int k) const {
        Row6 out;
        out << Vec3::Unit(k).transpose(),
            ((place - origin_) / extent_).cross(Vec3::Unit(k)).transpose();
        return out;
    }
    void add(const Row6& row) { sum_ += row.transpose() * row; }

    Vec3 origin_;
    double extent_ = 0.0;
    Matrix6 sum_ = Matrix6::Zero();
};

/// The rigid material of a part, for it alone.
fabric::RigidCard& own_card(Draft& draft, Index part) {
    Model& model = draft.model;
    Index& material = model.parts[static_cast<std::size_t>(part)].material;
    const bool is_shared = std::count_if(model.parts.begin(), model.parts.end(),
                                         [&](const Part& p) { return p.material == material; }) > 1;
    if (is_shared) {
        model.materials.push_back(model.materials[static_cast<std::size_t>(material)]);
        material = static_cast<Index>(model.materials.size()) - 1;
    }
    return std::get<fabric::RigidCard>(model.materials[static_cast<std::size_t>(material)].card);
}

bool has_local_axes(const Draft& draft, Index part) {
    const Index material = draft.model.parts[static_cast<std::size_t>(part)].material;
    return std::any_of(draft.local_constraints.begin(), draft.local_constraints.end(),
                       [&](const auto& local) { return local.first == material; });
}

}  // namespace

void hold_bodies(Draft& draft, Faults& faults) {
    Model& model = draft.model;
    std::vector<std::uint8_t> is_handed_on(model.x.size(), 0);
    for (const HeldBody& body : held_bodies(draft)) {
        const std::optional<DofMask> held = HeldMotions(model.x, body).mask();
        const Index first = body.supports.front().node;
        if (!held || has_local_axes(draft, body.lead)) {
            faults.fault(
                place_of(draft, body.lead),
                fmt::format("{} is rigid and held by *BOUNDARY_SPC or TC at nodes (first node {}), "
                            "which leaves it other motions than some along and about x, y, z, "
                            "expected CON1 and CON2 of its *MAT_RIGID, or joints",
                            name_of_part(draft, body.lead),
                            model.node_id[static_cast<std::size_t>(first)]));
            continue;
        }
        faults.note(place_of(draft, body.lead),
                    fmt::format("{}: supports of its nodes (first node {}) hold the body",
                                name_of_part(draft, body.lead),
                                model.node_id[static_cast<std::size_t>(first)]));
        fabric::RigidCard& card = own_card(draft, body.lead);
        card.fixed_moves |= *held & 7U;
        card.fixed_turns |= *held >> 3;
        for (const Index node : body.nodes) is_handed_on[static_cast<std::size_t>(node)] = 1;
    }
    std::erase_if(model.supports, [&](const Support& support) {
        return support.node >= 0 && is_handed_on[static_cast<std::size_t>(support.node)] != 0;
    });
}

}  // namespace corpuscle::io
