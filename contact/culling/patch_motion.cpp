// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/patch_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/base/sorted.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t MOVING_PATCHES_A_CHUNK = 4;  ///< patches

}  // namespace

PatchMotion::PatchMotion(const Cloth& cloth)
    : cloth_(cloth),
      start_{0},
      gone_(cloth.patches.size()),
      ahead_(gone_.size()),
      own_(gone_.size()),
      mean_(gone_.size(), Vec3::Zero()),
      from_(mean_) {
    std::vector<Index> nodes;
    for (std::size_t p = 0; p < gone_.size(); ++p) {
        nodes.clear();
        for (const Index t : cloth.patches[p])
            nodes.insert(nodes.end(), cloth.triangles[t].begin(), cloth.triangles[t].end());
        sort_unique(nodes);
        node_.insert(node_.end(), nodes.begin(), nodes.end());
        start_.push_back(static_cast<Index>(node_.size()));
        const auto is_of_body = [&](Index n) { return cloth.body[n] >= 0; };
        all_.push_back(static_cast<Index>(p));
        if (std::any_of(nodes.begin(), nodes.end(), is_of_body)) of_bodies_.push_back(all_.back());
    }
}

void PatchMotion::start(const Points& x) {
    last_ = x;
    dt_ = 0.0;
    mark(x);
}

/// Bounds a patch's displacements by how far they are off what they were in the mean before, per
/// unit of time: any vector will do, and this one needs one look at each node.
template <class Velocity>
void PatchMotion::bound(const std::vector<Index>& patches, double dt, Velocity&& velocity) {
    const auto one = [&](std::size_t i) {
        const Index p = patches[i];
        const Vec3 mean = mean_[p];
        Vec3 sum = Vec3::Zero();
        double square = 0.0;
        for (const Index n : nodes(p)) {
            const Vec3 off = velocity(n) - mean;
            sum += off;
            square = std::max(square, off.squaredNorm());
        }
        from_[p] = mean;
        mean_[p] += sum / static_cast<double>(nodes(p).size());
        own_[p] = dt * std::sqrt(square);
    };
    parallel::for_each(patches.size(), one, MOVING_PATCHES_A_CHUNK);
    const Vec3 common = std::accumulate(from_.begin(), from_.end(), Vec3(Vec3::Zero())) /
                        static_cast<double>(std::max<std::size_t>(1, from_.size()));
    common_ahead_ = dt * common;
    for (std::size_t p = 0; p < ahead_.size(); ++p)
        ahead_[p] = own_[p] + dt * (from_[p] - common).norm();
}

void PatchMotion::foresee(const Points& v, double dt) {
    const auto velocity = [&](Index n) -> const Vec3& { return v[n]; };
    if (std::exchange(dt_, dt) == 0.0) bound(all_, dt, velocity);  // only for the means
    bound(all_, dt, velocity);
}

/// What belongs to bodies turns a little in a step: it has gone where it is now.
void PatchMotion::follow(const Points& x) {
    if (!of_bodies_.empty()) {
        bound(of_bodies_, dt_, [&](Index n) -> Vec3 { return (x[n] - last_[n]) / dt_; });
        for (const Index p : of_bodies_)
            for (const Index n : nodes(p)) last_[n] = x[n];
    }
    for (std::size_t p = 0; p < gone_.size(); ++p) gone_[p] += ahead_[p];
    common_ += common_ahead_;
}

void PatchMotion::mark(const Points& x) {
    parallel::copy(x, marked_);
    common_.setZero();
    std::fill(gone_.begin(), gone_.end(), 0.0);
}

void PatchMotion::measure(Index patch, const Points& x) {
    double square = 0.0;
    for (const Index n : nodes(patch))
        square = std::max(square, (x[n] - marked_[n] - common_).squaredNorm());
    gone_[patch] = std::sqrt(square);
}

}  // namespace corpuscle::contact
