// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Energy that walls' points and their hits owe each other.

#include "gas/wall_load/wall_load.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

double WallLoad::book(std::span<const Vec3> v_mid, double span) {
    double work = 0.0;
    for (std::size_t r = 0; r < owed_.size() && !is_at_rest(); ++r)
        work += book_hits(r, v_mid, span);
    for (std::size_t j = 0; j < jets_.nodes.size(); ++j) {
        const double own = span * jets_.force[j].dot(v_mid[jets_.nodes[j]]);
        jets_.account[jets_.room[j]] -= own;
        work += own;
    }
    return work;
}

/// Accounts of points that gas has left go to those of their room where it is, by area: a few
/// particles would leave gains at one place, pay losses at another, and owe more than they hold.
double WallLoad::book_hits(std::size_t room, std::span<const Vec3> v_mid, double span) {
    struct Sums {
        double work = 0.0, swept = 0.0, wet = 0.0, left = 0.0;  ///< [W], [m^3/s], [m^2], [J]
        std::size_t leavers = 0;  ///< points that gas has left, with an account
        Sums& operator+=(const Sums& o) {
            work += o.work;
            swept += o.swept;
            wet += o.wet;
            left += o.left;
            leavers += o.leavers;
            return *this;
        }
    };
    const auto is_of_room = [&](std::size_t p) {
        return surface_->room_of_point(p) == static_cast<Index>(room);
    };
    const Sums all = parallel::sum(size_.size(), Sums{}, [&](std::size_t p) {
        Sums own;
        if (!is_of_room(p)) return own;
        const Vec3& v = v_mid[surface_->node(p)];
        own.work = released_.force[p].dot(v);
        own.swept = area_[p].dot(v);
        account_[p] += fresh_[p] - span * own.work;
        fresh_[p] = 0.0;
        if (is_wet(p)) {
            own.wet = size_[p];
        } else {
            own.left = account_[p];
            own.leavers = account_[p] != 0.0 ? 1 : 0;
        }
        return own;
    });
    released_.swept[room] = all.swept;
    if (all.leavers > 0 && all.wet > 0.0 && !hits_are_over()) {
        const double per_area = all.left / all.wet;
        parallel::for_each(account_.size(), [&](std::size_t p) {
            if (is_of_room(p)) account_[p] = is_wet(p) ? account_[p] + per_area * size_[p] : 0.0;
        });
    }
    return span * all.work;
}

double WallLoad::drain(std::size_t room, double share) {
    double sum = 0.0;
    for (std::size_t p = 0; p < account_.size(); ++p) {
        if (surface_->room_of_point(p) != static_cast<Index>(room)) continue;
        const double own = share * account_[p];
        account_[p] -= own;
        sum += own;
    }
    taken_ -= sum;
    return sum;
}

}  // namespace corpuscle::gas
