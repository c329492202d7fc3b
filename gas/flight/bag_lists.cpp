// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/bag_lists.hpp"

#include <algorithm>

#include "contact/geometry/box.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t MOST_CELLS = 2'000'000;

/// Box of the nodes at x_0 and x_1.
contact::Box box_of(const FacetLists& lists, const Points& x_0, const Points& x_1) {
    return parallel::fold(
        lists.nodes().size(), contact::Box{},
        [&](contact::Box& box, std::size_t i) {
            box.include(x_0[lists.nodes()[i]]);
            box.include(x_1[lists.nodes()[i]]);
        },
        [](contact::Box& box, const contact::Box& more) { box.include(more); });
}

/// Neither finer than a hundredth of the bag, which only costs, nor coarser than a quarter of it.
double sensible(double edge, const contact::Box& bag) {
    const double size = (bag.high - bag.low).maxCoeff();
    return std::clamp(edge, size / 100.0, size / 4.0);
}

}  // namespace

void build_over_bag(FacetLists& lists, double edge, double margin, double reach, const Points& x_0,
                    const Points& x_1) {
    contact::Box bag = box_of(lists, x_0, x_1);
    edge = sensible(edge, bag);
    bag.inflate(margin);
    lists.build(Grid::over(bag.low, bag.high, edge, MOST_CELLS), x_0, x_1, margin, reach);
}

void build_fitted_to_bag(FacetLists& lists, double edge, double margin, const Points& x) {
    const contact::Box bag = box_of(lists, x, x);
    lists.build(Grid::fitted(bag.low, bag.high, sensible(edge, bag), MOST_CELLS), x, x, margin);
}

double displacement_over_size(const FacetLists& lists, const Points& x_0, const Points& x_1) {
    contact::Box box;
    for (const Index n : lists.nodes()) box.include(x_0[n]);
    const double size = (box.high - box.low).maxCoeff();
    for (const Index n : lists.nodes()) box.include(x_1[n]);
    return (box.high - box.low).maxCoeff() / size;
}

}  // namespace corpuscle::gas
