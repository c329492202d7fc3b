// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Study -> points -> runs.

#include <algorithm>
#include <numeric>

#include "solver/base/random.hpp"
#include "tools/study/study.hpp"

namespace corpuscle::study {
namespace {

using Levels = std::vector<std::vector<double>>;

/// Of plans, not of the physics.
constexpr Stream PLANS{64};

Levels full(const std::vector<Factor>& factors) {
    Levels table{{}};
    for (const Factor& factor : factors) {
        Levels next;
        for (const std::vector<double>& point : table)
            for (const double value : factor.values) {
                next.push_back(point);
                next.back().push_back(value);
            }
        table = std::move(next);
    }
    return table;
}

/// u in (0, 1) to the factor's values.
double value_at(const Factor& factor, double u) {
    if (factor.is_range) return factor.from + u * (factor.to - factor.from);
    const auto n = static_cast<double>(factor.values.size());
    return factor.values[static_cast<std::size_t>(u * n)];
}

Levels latin(const Study& study) {
    const auto n = static_cast<std::uint32_t>(study.samples);
    Levels table(n);
    for (std::size_t f = 0; f < study.factors.size(); ++f) {
        Random draw(study.plan_seed, PLANS, f, 0);
        std::vector<std::uint32_t> share(n);
        std::iota(share.begin(), share.end(), 0U);
        for (std::uint32_t k = n - 1; k > 0; --k) std::swap(share[k], share[draw.below(k + 1)]);
        for (std::uint32_t k = 0; k < n; ++k)
            table[k].push_back(value_at(study.factors[f], (share[k] + draw.uniform()) / n));
    }
    return table;
}

Levels star(const std::vector<Factor>& factors) {
    std::vector<double> centre;
    for (const Factor& factor : factors) centre.push_back(factor.values.front());
    Levels table{centre};
    for (std::size_t f = 0; f < factors.size(); ++f)
        for (std::size_t k = 1; k < factors[f].values.size(); ++k) {
            table.push_back(centre);
            table.back()[f] = factors[f].values[k];
        }
    return table;
}

}  // namespace

Levels points(const Study& study) {
    switch (study.plan) {
        case Plan::FULL:
            return full(study.factors);
        case Plan::LATIN:
            return latin(study);
        case Plan::STAR:
            return star(study.factors);
        case Plan::POINTS:
            break;
    }
    return study.listed;
}

std::vector<Row> rows(const Study& study) {
    std::vector<Row> all;
    const Levels table = points(study);
    for (std::size_t p = 0; p < table.size(); ++p)
        for (int k = 0; k < study.repeats; ++k)
            all.push_back(
                {all.size() + 1, p, table[p], study.first_seed + static_cast<std::uint64_t>(k)});
    return all;
}

}  // namespace corpuscle::study
