// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>

#include "contact/candidates/shared_nodes.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// Compares all lanes of all blocks with what their nodes say. Returns how many share one.
template <int A, int B>
std::size_t compare(const Cloth& cloth) {
    const Blocks<A> mine(cloth);
    const Blocks<B> others(cloth);
    const SharedNodes shared(mine, others);
    std::size_t found = 0, wrong = 0;
    for (Index i = 0; i < mine.start().back(); ++i)
        for (Index j = 0; j < others.start().back(); ++j)
            for (int l = 0; l < EIGHT; ++l)
                for (int m = 0; m < EIGHT; ++m) {
                    const auto& a = mine[i].node[l];
                    const auto& b = others[j].node[m];
                    const bool is_there = mine[i].triangle[l] >= 0 && others[j].triangle[m] >= 0;
                    const bool share = is_there && std::any_of(a.begin(), a.end(), [&](Index n) {
                                           return std::find(b.begin(), b.end(), n) != b.end();
                                       });
                    const bool is_said = of_lane(shared.lanes(i, j), l) >> m & 1U;
                    found += share;
                    wrong += share != is_said;
                }
    CHECK(wrong == 0);
    return found;
}

}  // namespace

TEST_CASE("lanes that share a node are all known", "[contact]") {
    const support::Sheet sheet = support::square_sheet(9, 0.3);
    const support::SpringCloth spring(sheet);
    const Cloth cloth(spring.setup({}, spring.x));
    // 10 x 10 nodes, 162 triangles: each triangle has three of them, each its own
    CHECK(compare<1, 3>(cloth) == 3 * cloth.triangles.size());
    CHECK(compare<3, 1>(cloth) == 3 * cloth.triangles.size());
    CHECK(compare<2, 2>(cloth) > 0);
}
