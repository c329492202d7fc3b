// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "fabric/membrane_block.hpp"
#include "fabric/membranes.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::fabric {

namespace {

constexpr std::size_t TASK_ELEMENTS = 32;  // smaller spreads better over threads, costs more calls

ElementKind kind_of(const Part& part, int corners) {
    if (corners == 3) return ElementKind::TRIANGLE;
    return part.element_form == 9 ? ElementKind::QUAD_FOUR_POINT : ElementKind::QUAD_ONE_POINT;
}

std::unique_ptr<MembraneBlock> make_block(const BlockInput& in) {
    switch (in.kind) {
        case ElementKind::TRIANGLE:
            return make_triangles(in);
        case ElementKind::QUAD_ONE_POINT:
            return make_one_point_quads(in);
        case ElementKind::QUAD_FOUR_POINT:
            return make_four_point_quads(in);
    }
    return nullptr;
}

void add_shell(BlockInput& block, const MembraneSetup& setup, std::size_t row,
               const ReferenceShape& shape) {
    block.shells.push_back(static_cast<Index>(row));
    block.shapes.push_back(shape);
    auto& nodes = block.nodes.emplace_back();
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape.corners); ++i)
        nodes[i] = setup.shells[row].nodes[static_cast<std::size_t>(shape.corner[i])];
}

/// Part by part, triangles before quads; all faults are gathered before any is thrown.
std::vector<BlockInput> sort_into_blocks(const MembraneSetup& setup) {
    std::vector<Fault> faults;
    std::map<Index, std::optional<PartLaw>> laws;  // by part row
    std::map<std::pair<Index, ElementKind>, BlockInput> blocks;
    for (std::size_t row = 0; row < setup.shells.size(); ++row) {
        if (!setup.active[row]) continue;
        const Shell& shell = setup.shells[row];
        const Part& part = setup.parts[static_cast<std::size_t>(shell.part)];
        const Material& material = setup.materials[static_cast<std::size_t>(part.material)];
        if (const auto [law, is_new] = laws.try_emplace(shell.part); is_new) {
            try {
                law->second = make_law(material, setup.curves, part.thickness);
            } catch (const InputError& e) {
                faults.insert(faults.end(), e.typed.begin(), e.typed.end());
            }
            if (!(part.thickness > 0))
                faults.push_back({.of = fmt::format("part {}", part.id),
                                  .property = Property::THICKNESS,
                                  .value = part.thickness,
                                  .why = "expected > 0"});
        }
        std::string fault;
        const ReferenceShape shape = lay_flat(shell, setup.reference[row], material.card, fault);
        if (!fault.empty()) faults.push_back({.of = {}, .why = std::move(fault)});
        if (!faults.empty()) continue;
        const ElementKind kind = kind_of(part, shape.corners);
        BlockInput& block = blocks[{shell.part, kind}];
        if (block.shells.empty()) {
            block.part = shell.part;
            block.kind = kind;
            block.thickness = part.thickness;
            block.law = *laws.at(shell.part);
            block.start = setup.start;
        }
        add_shell(block, setup, row, shape);
    }
    if (!faults.empty()) throw InputError(std::move(faults));
    std::vector<BlockInput> out;
    for (auto& [key, block] : blocks) out.push_back(std::move(block));
    return out;
}

}  // namespace

Membranes::Membranes(const MembraneSetup& setup)
    : part_energy_(setup.parts.size(), 0.0), node_count_(setup.node_count) {
    std::size_t elastic = 0, damped = 0;
    for (const BlockInput& in : sort_into_blocks(setup)) {
        blocks_.push_back(make_block(in));
        const MembraneBlock& block = *blocks_.back();
        block_start_.push_back(elastic);
        damped_start_.push_back(damped);
        elastic += block.doubles();
        if (block.is_damped) damped += block.doubles();
        element_count_ += block.size();
        if (in.law.restoration.any())
            add_restoring(blocks_.size() - 1, in.law.restoration, setup.curves);
        const std::size_t step = TASK_ELEMENTS / LANES;
        for (std::size_t p = 0; p < block.packs(); p += step)
            tasks_.push_back({blocks_.size() - 1, p, std::min(p + step, block.packs())});
    }
    found_.resize(tasks_.size());
    corner_force_.resize(elastic);
    corner_damping_.resize(damped);
    if (damped > 0) damping_force_.assign(setup.node_count, Vec3::Zero());
    gather_ = gather_of(setup.node_count, /*damped=*/false);
    damping_gather_ = gather_of(setup.node_count, /*damped=*/true);
    gather_check_.resize(chunks_of(gather_));
    damping_check_.resize(chunks_of(damping_gather_));
    const std::vector<double> mass =
        setup.node_mass.empty()
            ? lumped_mass(setup)
            : std::vector<double>(setup.node_mass.begin(), setup.node_mass.end());
    coat_ = CoatBending(setup, mass);
    find_rest_rates(mass);
}

Membranes::~Membranes() = default;
Membranes::Membranes(Membranes&&) noexcept = default;
Membranes& Membranes::operator=(Membranes&&) noexcept = default;

/// Counting sort of all corners by node; within a node in the order of blocks, elements, corners.
Membranes::Gather Membranes::gather_of(std::size_t node_count, bool damped) const {
    const auto for_corners = [&](auto&& body) {
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const MembraneBlock& block = *blocks_[b];
            if (damped && !block.is_damped) continue;
            const std::size_t start = damped ? damped_start_[b] : block_start_[b];
            for (std::size_t e = 0; e < block.size(); ++e)
                for (int c = 0; c < block.corners; ++c) {
                    const std::size_t pack = e / LANES * static_cast<std::size_t>(block.corners);
                    body(block.node(e, c),
                         start + (pack + static_cast<std::size_t>(c)) * 3 * LANES + e % LANES);
                }
        }
    };
    std::vector<std::uint32_t> count(node_count, 0), next(node_count, 0);
    for_corners([&](Index node, std::size_t) { ++count[static_cast<std::size_t>(node)]; });
    Gather out;
    std::uint32_t total = 0;
    for (std::size_t n = 0; n < node_count; ++n) {
        if (count[n] == 0) continue;
        out.nodes.push_back(static_cast<Index>(n));
        out.starts.push_back(total);
        next[n] = total;
        total += count[n];
    }
    out.starts.push_back(total);
    out.places.resize(total);
    for_corners([&](Index node, std::size_t place) {
        out.places[next[static_cast<std::size_t>(node)]++] = static_cast<std::uint32_t>(place);
    });
    return out;
}

}  // namespace corpuscle::fabric
