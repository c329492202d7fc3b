// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/bag_lists.hpp"

#include <algorithm>

#include "contact/geometry/box.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t MOST_CELLS = 2'000'000;

}  // namespace

void build_over_bag(FacetLists& lists, double edge, double margin, double reach, const Points& x_0,
                    const Points& x_1) {
    contact::Box bag;
    for (const Index n : lists.nodes()) {
        bag.include(x_0[n]);
        bag.include(x_1[n]);
    }
    const double size = (bag.high - bag.low).maxCoeff();
    edge = std::clamp(edge, size / 100.0, size / 4.0);
    bag.inflate(margin);
    lists.build(Grid::over(bag.low, bag.high, edge, MOST_CELLS), x_0, x_1, margin, reach);
}

double displacement_over_size(const FacetLists& lists, const Points& x_0, const Points& x_1) {
    contact::Box box;
    for (const Index n : lists.nodes()) box.include(x_0[n]);
    const double size = (box.high - box.low).maxCoeff();
    for (const Index n : lists.nodes()) box.include(x_1[n]);
    return (box.high - box.low).maxCoeff() / size;
}

}  // namespace corpuscle::gas
