// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fabric/element_frequency.hpp"
#include "fabric/membrane_block.hpp"
#include "fabric/membranes.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::fabric {

namespace {

/// Rounds of sharing. On discs and on grids jittered by up to 30 % these come within 2 % of 40
/// rounds.
constexpr int ROUNDS = 8;

using Blocks = std::vector<std::unique_ptr<MembraneBlock>>;

template <class Body>  // body(block, element, corner, node)
void for_corners(const Blocks& blocks, const Body& body) {
    for (const auto& block : blocks)
        for (std::size_t e = 0; e < block->size(); ++e)
            for (int c = 0; c < block->corners; ++c)
                body(*block, e,
                     e * static_cast<std::size_t>(block->corners) + static_cast<std::size_t>(c),
                     static_cast<std::size_t>(block->node(e, c)));
}

/// Scales what corners bring to each node so that they add up to its mass.
void share_out(const Blocks& blocks, const std::vector<double>& mass) {
    std::vector<double> sum(mass.size(), 0.0);
    for_corners(blocks, [&](MembraneBlock& b, std::size_t, std::size_t corner, std::size_t node) {
        sum[node] += b.mass[corner];
    });
    for_corners(blocks, [&](MembraneBlock& b, std::size_t, std::size_t corner, std::size_t node) {
        b.mass[corner] *= mass[node] / sum[node];
    });
}

/// (2/dt)² of every element with the mass it has been given; the largest.
double find_rates(const Blocks& blocks) {
    double most = 0.0;
    for (const auto& block : blocks) {
        const auto corners = static_cast<std::size_t>(block->corners);
        parallel::for_each(block->size(), [&](std::size_t e) {
            const double frequency =
                highest_frequency_squared(block->stiffness[e], block->mass.data() + e * corners);
            block->set_rate(e, step_rate(frequency, block->damping_time(e)));
        });
        for (std::size_t e = 0; e < block->size(); ++e) most = std::max(most, block->rate(e));
    }
    return most;
}

}  // namespace

/// No mesh vibrates faster than its fastest element, however the nodes' masses are shared among the
/// elements [Irons & Treharne 1971]. With equal shares small elements are held to be light that in
/// truth lean on heavy neighbours; so mass is handed to whoever vibrates faster, and the best round
/// is kept.
void Membranes::find_rest_rates(const std::vector<double>& mass) {
    double least = INF;
    std::vector<std::vector<double>> best(blocks_.size());
    for (int round = 0; round < ROUNDS; ++round) {
        share_out(blocks_, mass);
        if (const double most = find_rates(blocks_); most < least) {
            least = most;
            for (std::size_t b = 0; b < blocks_.size(); ++b) best[b] = blocks_[b]->mass;
        }
        for_corners(blocks_, [&](MembraneBlock& b, std::size_t e, std::size_t corner, std::size_t) {
            b.mass[corner] *= b.rate(e) / least;
        });
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) blocks_[b]->mass = std::move(best[b]);
    find_rates(blocks_);
    for (const auto& block : blocks_) {
        block->stiffness.clear();
        block->stiffness.shrink_to_fit();
    }
    find_rest_step();
}

/// The step of the reference shapes, for use before any force is known.
void Membranes::find_rest_step() {
    double rate = 0.0;
    step_ = {};
    rest_ = {};
    for (const auto& block : blocks_)
        for (std::size_t e = 0; e < block->size(); ++e)
            if (block->rate(e) > rate) {
                rate = block->rate(e);
                rest_ = {rate, block->shells[e]};
            }
    if (rate > 0.0) step_ = HeldStep(coat_.shortened(2.0 / std::sqrt(rate)), rest_.shell);
    for (const auto& block : blocks_) {
        block->rest_rate = rate;
        block->take_masses();
    }
}

Membranes::AddedMass Membranes::scale_mass(double wish, Scaling where) {
    AddedMass added{std::vector<double>(node_count_, 0.0), 0.0};
    const double step = coat_.lengthened(wish);
    if (step == INF)
        throw InputError(
            Fault{.of = "the run",
                  .property = Property::MASS_SCALED_STEP,
                  .value = wish,
                  .why = fmt::format("longer than bending of the coat allows, expected less than "
                                     "{:g}",
                                     1.0 / std::sqrt(coat_.rate()))});
    for (const auto& block : blocks_)
        for (std::size_t e = 0; e < block->size(); ++e) {
            const double factor =
                mass_factor(2.0 / std::sqrt(block->rate(e)), step, block->damping_time(e));
            if (where == Scaling::WHERE_NEEDED && factor <= 1.0) continue;
            for (int c = 0; c < block->corners; ++c) {
                const double more =
                    (factor - 1.0) * block->mass[e * static_cast<std::size_t>(block->corners) +
                                                 static_cast<std::size_t>(c)];
                added.node[static_cast<std::size_t>(block->node(e, c))] += more;
                block->mass[e * static_cast<std::size_t>(block->corners) +
                            static_cast<std::size_t>(c)] += more;
                added.total += more;
            }
            block->set_rate(e, 4.0 / (step * step));
        }
    find_rest_step();
    return added;
}

}  // namespace corpuscle::fabric
