// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/loads.hpp"

#include <algorithm>

#include "solver/base/surface.hpp"

namespace corpuscle {

Loads::Loads(const Model& model) {
    for (const BodyLoad& load : model.body_loads)
        body_.push_back({load.axis, load.scale, model.curves[load.curve]});
    for (const PressureLoad& load : model.pressure_loads) {
        Pressure pressure{{}, load.scale, load.arrival, {}};
        if (load.curve >= 0) pressure.curve = model.curves[load.curve];
        for (const auto& q : load.facets) {
            pressure.triangles.push_back({q[0], q[1], q[2]});
            if (q[2] != q[3]) pressure.triangles.push_back({q[0], q[2], q[3]});
        }
        pressure_.push_back(std::move(pressure));
    }
}

Vec3 Loads::acceleration(double t) const {
    Vec3 all = Vec3::Zero();
    for (const Body& load : body_) all[load.axis] -= load.scale * load.curve(t);
    return all;
}

void Loads::find_force(double t, const Points& x, const std::vector<double>& mass,
                       Points& f) const {
    std::fill(f.begin(), f.end(), Vec3::Zero());
    if (!body_.empty()) {
        const Vec3 all = acceleration(t);
        for (std::size_t n = 0; n < f.size(); ++n) f[n] += mass[n] * all;
    }
    for (const Pressure& load : pressure_) {
        if (t < load.arrival) continue;
        const double p = load.scale * (load.curve.empty() ? 1.0 : load.curve(t - load.arrival));
        for (const auto& c : load.triangles) {
            const Vec3 corner = -p / 3.0 * vector_area(x[c[0]], x[c[1]], x[c[2]]);
            for (const Index node : c) f[node] += corner;
        }
    }
}

}  // namespace corpuscle
