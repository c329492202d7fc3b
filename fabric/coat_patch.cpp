// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/coat_patch.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>

#include "fabric/coat_bending.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {
namespace {

constexpr std::size_t ENOUGH = 8;    // neighbours: those of a node among quads
constexpr double ILL_FITTED = 1e-8;  // least over greatest pivot of a fit that knows nothing
constexpr double SAME_PLACE = 1e-6;  // of an edge's length

}  // namespace

CoatPatch::CoatPatch(const MembraneSetup& setup, Index part) {
    add_pieces(setup, part);
    find_edges();
    for (Node& node : nodes_)
        if (node.bends) fit(node);
    share_areas();
}

void CoatPatch::add_pieces(const MembraneSetup& setup, Index part) {
    std::set<Index> rows;
    for (std::size_t s = 0; s < setup.shells.size(); ++s) {
        const Shell& shell = setup.shells[s];
        if (shell.part != part) continue;
        const ReferenceShape corners = distinct_corners(shell);
        CoatTriangle p{corners.corners, {}, {}, Vec3::Zero(), 0.0};
        for (std::size_t i = 0; i < static_cast<std::size_t>(p.count); ++i) {
            const auto c = static_cast<std::size_t>(corners.corner[i]);
            p.node[i] = shell.nodes[c];
            p.X[i] = setup.reference[s][c];
            rows.insert(p.node[i]);
            fan_[p.node[i]].push_back(triangles_.size());
        }
        p.normal = p.count == 4 ? (p.X[2] - p.X[0]).cross(p.X[3] - p.X[1])
                                : (p.X[1] - p.X[0]).cross(p.X[2] - p.X[0]);
        p.area = 0.5 * p.normal.norm();
        p.normal.normalize();
        triangles_.push_back(p);
    }
    for (const Index row : rows) {
        place_.emplace(row, nodes_.size());
        nodes_.push_back({row, true, true, 0.0, 0.0, {}});
    }
    for (const CoatTriangle& p : triangles_)
        for (std::size_t i = 0; i < static_cast<std::size_t>(p.count); ++i)
            at(p.node[i]).area += p.area / p.count;
}

void CoatPatch::find_edges() {
    for (std::size_t e = 0; e < triangles_.size(); ++e) {
        const CoatTriangle& p = triangles_[e];
        for (std::size_t i = 0, n = static_cast<std::size_t>(p.count); i < n; ++i)
            beside_[std::minmax(p.node[i], p.node[(i + 1) % n])].push_back(e);
    }
    for (const auto& [edge, pieces] : beside_)
        for (const Index n : {edge.first, edge.second}) {
            if (pieces.size() < 2) at(n).is_inner = false;
            if (!runs_on(edge)) at(n).bends = false;
        }
}

/// Whether the cloth runs on over an edge: two shells that meet there and lie in one plane.
bool CoatPatch::runs_on(const Edge& edge) const {
    const auto& pieces = beside_.at(edge);
    if (pieces.size() != 2) return false;
    const CoatTriangle &a = triangles_[pieces[0]], &b = triangles_[pieces[1]];
    const auto corner = [](const CoatTriangle& p, Index node) {
        return static_cast<std::size_t>(std::find(p.node.begin(), p.node.end(), node) -
                                        p.node.begin());
    };
    const auto is_forward = [&](const CoatTriangle& p) {
        return (corner(p, edge.first) + 1) % static_cast<std::size_t>(p.count) ==
               corner(p, edge.second);
    };
    const double length = (a.X[corner(a, edge.first)] - a.X[corner(a, edge.second)]).norm();
    for (const Index n : {edge.first, edge.second})
        if ((a.X[corner(a, n)] - b.X[corner(b, n)]).norm() > SAME_PLACE * length) return false;
    const Vec3 other = is_forward(a) == is_forward(b) ? Vec3(-b.normal) : b.normal;
    return std::atan2(a.normal.cross(other).norm(), a.normal.dot(other)) < CoatBending::SEAM;
}

/// X of the neighbours of a node, itself included.
std::map<Index, Vec3> CoatPatch::places_around(const Node& node) const {
    std::map<Index, Vec3> places;
    const auto add = [&](const CoatTriangle& p) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(p.count); ++i)
            places.emplace(p.node[i], p.X[i]);
    };
    const auto& fan = fan_.at(node.row);
    for (const std::size_t e : fan) add(triangles_[e]);
    if (places.size() > ENOUGH) return places;
    for (const std::size_t e : fan) {
        const CoatTriangle& p = triangles_[e];
        for (std::size_t i = 0, n = static_cast<std::size_t>(p.count); i < n; ++i) {
            const Edge edge = std::minmax(p.node[i], p.node[(i + 1) % n]);
            if (edge.first == node.row || edge.second == node.row || !runs_on(edge)) continue;
            for (const std::size_t beyond : beside_.at(edge)) add(triangles_[beyond]);
        }
    }
    return places;
}

void CoatPatch::fit(Node& node) const {
    const std::map<Index, Vec3> places = places_around(node);
    const Vec3 origin = places.at(node.row);
    const Vec3 normal = triangles_[fan_.at(node.row).front()].normal;
    const Vec3 e_1 = normal.unitOrthogonal(), e_2 = normal.cross(e_1);
    const auto count = static_cast<Eigen::Index>(places.size()) - 1;
    Eigen::Matrix<double, Eigen::Dynamic, 5> terms(count, 5);  // of g and H, weighted
    Eigen::VectorXd weight(count);
    double size = 0.0;  // makes the terms of g and H alike
    for (const auto& [row, X] : places) size = std::max(size, (X - origin).norm());
    Eigen::Index m = 0;
    for (const auto& [row, X] : places) {
        if (row == node.row) continue;
        const double u = e_1.dot(X - origin) / size, v = e_2.dot(X - origin) / size;
        weight(m) = 1.0 / std::hypot(u, v);
        terms.row(m) << u, v, 0.5 * u * u, 0.5 * v * v, u * v;
        terms.row(m) *= weight(m);
        ++m;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(terms);
    const auto pivots = solver.matrixR().diagonal().cwiseAbs();
    if (count < 5 || pivots.head(5).minCoeff() < ILL_FITTED * pivots.maxCoeff()) {
        node.bends = false;
        return;
    }
    const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd(weight.asDiagonal()));
    m = 0;
    for (const auto& [row, X] : places) {
        if (row == node.row) continue;
        const double scale = 1.0 / (size * size);
        node.neighbours.push_back(
            {row, {scale * inverse(2, m), scale * inverse(3, m), scale * inverse(4, m)}});
        ++m;
    }
}

/// The area of a node that does not bend goes to those that do in the same shells.
void CoatPatch::share_areas() {
    std::map<Index, std::set<Index>> takers;
    for (const CoatTriangle& p : triangles_)
        for (std::size_t i = 0; i < static_cast<std::size_t>(p.count); ++i)
            for (std::size_t j = 0; j < static_cast<std::size_t>(p.count); ++j)
                if (!at(p.node[i]).bends && at(p.node[j]).bends)
                    takers[p.node[i]].insert(p.node[j]);
    for (Node& n : nodes_) n.reckoned_area = n.area;
    for (const auto& [giver, all] : takers)
        for (const Index n : all)
            at(n).reckoned_area += at(giver).area / static_cast<double>(all.size());
}

std::size_t CoatPatch::inner_count() const {
    return static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.is_inner; }));
}

std::size_t CoatPatch::sewn_count() const {
    return static_cast<std::size_t>(std::count_if(
        nodes_.begin(), nodes_.end(), [](const Node& n) { return n.is_inner && !n.bends; }));
}

}  // namespace corpuscle::fabric
