// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/loads.hpp"

#include <algorithm>

#include "solver/base/surface.hpp"

namespace corpuscle {

Loads::Loads(const Model& model) {
    for (const BodyLoad& load : model.body_loads)
        body_.push_back({load.axis,
                         load.scale,
                         load.curve >= 0 ? model.curves[load.curve] : Curve{},
                         load.parts,
                         {}});
    for (const PressureLoad& load : model.pressure_loads) {
        Pressure pressure{{}, load.scale, load.arrival, {}};
        if (load.curve >= 0) pressure.curve = model.curves[load.curve];
        for (const auto& q : load.facets) {
            pressure.triangles.push_back({q[0], q[1], q[2]});
            if (q[2] != q[3]) pressure.triangles.push_back({q[0], q[2], q[3]});
        }
        pressure_.push_back(std::move(pressure));
    }
    for (const NodeLoad& load : model.node_loads)
        node_.push_back({load.nodes, load.axis, load.scale, model.curves[load.curve]});
}

namespace {

bool holds(const std::vector<Index>& parts, Index part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

void Loads::share_mass(const Model& model, const std::vector<double>& shell_mass) {
    for (Body& load : body_) {
        if (load.parts.empty()) continue;
        std::vector<double> all(model.x.size(), 0.0);
        load.share.assign(model.x.size(), 0.0);
        for (std::size_t s = 0; s < model.shells.size(); ++s) {
            const Shell& shell = model.shells[s];
            const int corners = shell.is_triangle() ? 3 : 4;
            for (int k = 0; k < corners; ++k) {
                all[shell.nodes[k]] += shell_mass[s] / corners;
                if (holds(load.parts, shell.part))
                    load.share[shell.nodes[k]] += shell_mass[s] / corners;
            }
        }
        for (std::size_t n = 0; n < all.size(); ++n)
            if (all[n] > 0.0) load.share[n] /= all[n];
    }
}

Vec3 Loads::acceleration(double t, Index part) const {
    Vec3 all = Vec3::Zero();
    for (const Body& load : body_)
        if (load.parts.empty() || holds(load.parts, part)) all[load.axis] -= load.value(t);
    return all;
}

void Loads::find_force(double t, const Points& x, const std::vector<double>& mass,
                       Points& f) const {
    std::fill(f.begin(), f.end(), Vec3::Zero());
    for (const Body& load : body_) {
        const double a = load.value(t);
        for (std::size_t n = 0; n < f.size(); ++n)
            f[n][load.axis] -= (load.share.empty() ? mass[n] : load.share[n] * mass[n]) * a;
    }
    for (const Pressure& load : pressure_) {
        if (t < load.arrival) continue;
        const double p = load.scale * (load.curve.empty() ? 1.0 : load.curve(t - load.arrival));
        for (const auto& c : load.triangles) {
            const Vec3 corner = -p / 3.0 * vector_area(x[c[0]], x[c[1]], x[c[2]]);
            for (const Index node : c) f[node] += corner;
        }
    }
    for (const Node& load : node_) {
        const double force = load.scale * load.curve(t);
        for (const Index node : load.nodes) f[node][load.axis] += force;
    }
}

}  // namespace corpuscle
