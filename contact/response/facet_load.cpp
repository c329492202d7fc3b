// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/facet_load.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {

FacetLoad::FacetLoad(const Cloth& cloth) : cloth_(cloth), taken_(cloth.inverse_mass.size()) {}

void FacetLoad::add(const Contact& c) {
    if (c.impulse <= 0.0) return;
    const Vec3& n = c.normal;
    const Tensor nn = {n.x() * n.x(), n.y() * n.y(), n.z() * n.z(),
                       n.x() * n.y(), n.y() * n.z(), n.z() * n.x()};
    for (int k = 0; k < 4; ++k) {
        const double J = std::abs(c.weight[k]) * c.impulse;
        Tensor& T = taken_[c.node[k]];
        for (std::size_t i = 0; i < T.size(); ++i) T[i] += J * nn[i];
    }
}

void FacetLoad::clear() {
    std::fill(taken_.begin(), taken_.end(), Tensor{});
    time_ = 0.0;
}

std::vector<double> FacetLoad::forces(const Points& x) const {
    std::vector<double> force(cloth_.triangles.size(), 0.0);
    if (time_ == 0.0) return force;
    std::vector<double> facing, area;
    for (const Index node : cloth_.nodes) {
        const auto& [xx, yy, zz, xy, yz, zx] = taken_[node];
        const double load = xx + yy + zz;
        if (load == 0.0) continue;
        const auto around = cloth_.triangles_of(node);
        facing.clear();
        area.clear();
        double all_facing = 0.0, all_area = 0.0;
        for (const Index t : around) {
            const Triangle& corner = cloth_.triangles[t];
            const Vec3 a = vector_area(x[corner[0]], x[corner[1]], x[corner[2]]);
            const double size = a.norm();
            const double aTa = a.x() * a.x() * xx + a.y() * a.y() * yy + a.z() * a.z() * zz +
                               2.0 * (a.x() * a.y() * xy + a.y() * a.z() * yz + a.z() * a.x() * zx);
            facing.push_back(size > 0.0 ? std::max(aTa, 0.0) / size : 0.0);
            area.push_back(size);
            all_facing += facing.back();
            all_area += size;
        }
        // what meets cloth edge on faces none of its facets; those without area share alike
        constexpr double EDGE_ON = 1e-12;
        const bool is_faced = all_facing > EDGE_ON * load * all_area;
        for (std::size_t k = 0; k < around.size(); ++k) {
            const double share = is_faced         ? facing[k] / all_facing
                                 : all_area > 0.0 ? area[k] / all_area
                                                  : 1.0 / static_cast<double>(around.size());
            force[around[k]] += share * load / time_;
        }
    }
    return force;
}

}  // namespace corpuscle::contact
