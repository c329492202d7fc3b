// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/pieces.hpp"

namespace corpuscle::contact {

void Pieces::list(const Cloth& cloth, const PatchMotion& motion, std::span<const PatchPair> pairs) {
    patches.clear();
    nodes.clear();
    triangles.clear();
    is_met_.assign(motion.size(), 0);
    for (const auto& [p, q] : pairs) is_met_[p] = is_met_[q] = 1;
    for (std::size_t p = 0; p < is_met_.size(); ++p)
        if (is_met_[p]) patches.push_back(static_cast<Index>(p));
    if (patches.empty()) return;
    is_met_.assign(cloth.inverse_mass.size(), 0);
    for (const Index p : patches)
        for (const Index n : motion.nodes(p)) is_met_[n] = 1;
    for (const Index n : cloth.nodes)
        if (is_met_[n]) nodes.push_back(n);
    is_met_.assign(cloth.triangles.size(), 0);
    for (const Index p : patches)
        for (const Index t : cloth.patches[p]) is_met_[t] = 1;
    for (std::size_t t = 0; t < is_met_.size(); ++t)
        if (is_met_[t]) triangles.push_back(static_cast<Index>(t));
}

}  // namespace corpuscle::contact
