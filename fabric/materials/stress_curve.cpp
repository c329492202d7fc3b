// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/stress_curve.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::fabric {

StressCurve::StressCurve(double slope, Below below)
    : e_{-1.0, 0.0, 1.0}, s_{below == Below::NOTHING ? 0.0 : -slope, 0.0, slope} {
    integrate();
}

StressCurve::StressCurve(const Curve& curve, Below below) {
    const bool has_negative = curve.x.front() < 0.0 && below == Below::STRAIGHT;
    const double first = *std::upper_bound(curve.x.begin(), curve.x.end(), 0.0);
    if (below == Below::MIRRORED) {
        for (std::size_t i = curve.x.size(); i-- > 0;)
            if (curve.x[i] > 0.0) {
                e_.push_back(-curve.x[i]);
                s_.push_back(-curve.y[i]);
            }
    } else if (!has_negative) {
        e_.push_back(-first);
        s_.push_back(below == Below::NOTHING ? 0.0 : -curve(first));
    }
    for (std::size_t i = 0; has_negative && curve.x[i] < 0.0; ++i) {
        e_.push_back(curve.x[i]);
        s_.push_back(curve.y[i]);
    }
    e_.push_back(0.0);
    s_.push_back(0.0);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (curve.x[i] > 0.0) {
            e_.push_back(curve.x[i]);
            s_.push_back(curve.y[i]);
        }
    integrate();
}

void StressCurve::integrate() {
    w_.assign(e_.size(), 0.0);
    for (std::size_t i = 1; i < e_.size(); ++i)
        w_[i] = w_[i - 1] + 0.5 * (s_[i - 1] + s_[i]) * (e_[i] - e_[i - 1]);
    const auto zero = std::find(e_.begin(), e_.end(), 0.0);
    const double at_zero = w_[static_cast<std::size_t>(zero - e_.begin())];
    for (double& w : w_) w -= at_zero;
}

StressCurve::Point StressCurve::at(double strain) const {
    const auto right = std::upper_bound(e_.begin() + 1, e_.end() - 1, strain);
    const auto i = static_cast<std::size_t>(right - e_.begin()) - 1;
    const double along = strain - e_[i], k = slope(i);
    return {s_[i] + k * along, w_[i] + along * (s_[i] + 0.5 * k * along)};
}

double StressCurve::steepest() const {
    double most = 0.0;
    for (std::size_t i = 0; i + 1 < e_.size(); ++i) most = std::max(most, slope(i));
    return most;
}

std::string loading_fault(const Curve& curve, Below below) {
    if (curve.x.size() < 2 || !(curve.x.back() > 0.0))
        return "a curve that reaches strains above 0";
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        if (!(curve.x[i] > curve.x[i - 1])) return "a curve without jumps";
        if (!(curve.y[i] >= curve.y[i - 1])) return "a curve that never falls";
    }
    if (curve.x.front() > 0.0 || curve(0.0) != 0.0) return "a curve through (0, 0)";
    if (!(curve.y.back() > 0.0)) return "a curve that rises above 0";
    if (below == Below::MIRRORED && curve.x.front() < 0.0)
        return "strains from 0 on: the curve is mirrored for the other way";
    return {};
}

}  // namespace corpuscle::fabric
