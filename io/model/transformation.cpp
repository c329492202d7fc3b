// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/transformation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corpuscle::io {

namespace {

using Eigen::Affine3d;
using Kind = TransformationStep::Kind;

/// About the line through `at` along `axis`, right-handed.
Affine3d rotation(const Vec3& at, const Vec3& axis, double angle) {
    return Eigen::Translation3d(at) * Eigen::AngleAxisd(angle, axis.normalized()) *
           Eigen::Translation3d(-at);
}

/// Columns: along a-b, in the plane a-b-c, across it.
Mat3 frame_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 x = (b - a).normalized(), z = x.cross(c - a).normalized();
    Mat3 frame;
    frame << x, z.cross(x), z;
    return frame;
}

std::string label(const Transformation& of, const char* option, const char* expected) {
    return fmt::format("*DEFINE_TRANSFORMATION {}: {}, expected {}", of.id, option, expected);
}

}  // namespace

bool spans_plane(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double IN_LINE = 1e-9;  // sine of the angle at a
    const Vec3 u = b - a, v = c - a;
    return u.cross(v).norm() > IN_LINE * u.norm() * v.norm();
}

Affine3d six_points(const std::array<Vec3, 6>& p) {
    const Mat3 turn = frame_of(p[3], p[4], p[5]) * frame_of(p[0], p[1], p[2]).transpose();
    Affine3d map = Affine3d::Identity();
    map.linear() = turn;
    map.translation() = p[3] - turn * p[0];
    return map;
}

bool Transformation::needs_nodes() const {
    return std::any_of(steps.begin(), steps.end(),
                       [](const TransformationStep& step) { return step.nodes[0] >= 0; });
}

Affine3d Transformation::map(const NodePlace& place_of, Faults& faults) const {
    Affine3d whole = Affine3d::Identity();
    for (const TransformationStep& step : steps) {
        std::array<Vec3, 6> x{};
        for (std::size_t i = 0; i < x.size(); ++i)
            if (step.nodes[i] >= 0) x[i] = place_of(step.nodes[i], whole);
        const auto fault = [&](const char* option, const char* expected) {
            faults.begin_block();
            faults.fault(step.place, label(*this, option, expected));
        };
        Affine3d one = Affine3d::Identity();
        switch (step.kind) {
            case Kind::FIXED:
                one = step.map;
                break;
            case Kind::ROTATE_BY_POINTS: {
                const Vec3 from = whole * step.points[0];
                one = rotation(from, whole * step.points[1] - from, step.amount);
                break;
            }
            case Kind::ROTATE_BY_NODES:
                if (x[0] == x[1])
                    fault("ROTATE3NA", "two nodes apart, for the axis");
                else
                    one = rotation(x[2], x[1] - x[0], step.amount);
                break;
            case Kind::TRANSLATE_BY_NODES:
                if (x[0] == x[1])
                    fault("TRANSL2ND", "two nodes apart, for the direction");
                else
                    one.translation() = step.amount == 0.0
                                            ? Vec3(x[1] - x[0])
                                            : Vec3(step.amount * (x[1] - x[0]).normalized());
                break;
            case Kind::SIX_POINTS: {
                std::array<Vec3, 6> points = step.points;  // targets stay where they are
                for (std::size_t i = 0; i < 3; ++i) points[i] = whole * points[i];
                one = six_points(points);
                break;
            }
            case Kind::SIX_NODES:
                if (!spans_plane(x[0], x[1], x[2]) || !spans_plane(x[3], x[4], x[5]))
                    fault("POS6N", "three nodes that span a plane, twice");
                else
                    one = six_points(x);
                break;
        }
        whole = one * whole;
    }
    return whole;
}

}  // namespace corpuscle::io
