// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/wall_load.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Answer of a gas to a wall that moves: dp/dw = -4 times the mass that hits it per area and time,
/// since p = 2 int (v - w)² f dv over all that come.
constexpr double ANSWER = 4.0;

/// Share of its energy that a particle pays, or is paid, at one hit at most; the rest waits for the
/// next. More: single particles take on debts that their group can hardly share.
constexpr double MOST_PAID = 0.25;

/// Internal energy below nothing that a particle takes on, in its energy of motion: a monatomic gas
/// has no other, and its group shares the debt at the next collision. More: the next wall may take
/// the motion that is to pay for it.
constexpr double MOST_DEBT = 0.1;

/// Share of a room's free wall that must be wet to bear the correction of momentum alone.
constexpr double LEAST_WET = 0.25;

/// Times of release after the last hit from which a point counts as one that gas has not reached.
constexpr double DRY_AFTER = 4.0;

/// By wall point: is its node held?
std::vector<std::uint8_t> held_at(const WettedSurface& surface,
                                  std::span<const std::uint8_t> held) {
    std::vector<std::uint8_t> at(surface.points());
    for (std::size_t p = 0; p < at.size(); ++p) at[p] = held[surface.node(p)];
    return at;
}

}  // namespace

WallLoad::WallLoad(std::shared_ptr<const WettedSurface> surface, std::span<const std::uint8_t> held,
                   std::span<const Index> jet_nodes, double time, double extra_damping)
    : surface_(std::move(surface)),
      smoother_(*surface_),
      recoil_(*surface_, held_at(*surface_, held)),
      jet_nodes_(jet_nodes.begin(), jet_nodes.end()),
      time_(time),
      dry_after_(DRY_AFTER * time),
      extra_damping_(extra_damping) {
    const std::size_t points = surface_->points();
    held_ = held_at(*surface_, held);
    for (const Index n : jet_nodes_) jet_held_.push_back(held[n]);
    takes_part_.assign(points, 0);
    place_.assign(held.size(), -1);
    for (std::size_t p = 0; p < points; ++p) nodes_.push_back(surface_->node(p));
    nodes_.insert(nodes_.end(), jet_nodes_.begin(), jet_nodes_.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (std::size_t i = 0; i < nodes_.size(); ++i) place_[nodes_[i]] = static_cast<Index>(i);
    node_start_.assign(nodes_.size() + 1, 0);
    for (std::size_t p = 0; p < points; ++p) ++node_start_[place_[surface_->node(p)] + 1];
    for (std::size_t i = 0; i < nodes_.size(); ++i) node_start_[i + 1] += node_start_[i];
    of_node_.resize(points);
    std::vector<Index> fill(node_start_.begin(), node_start_.end() - 1);
    for (std::size_t p = 0; p < points; ++p)
        of_node_[fill[place_[surface_->node(p)]]++] = static_cast<Index>(p);

    for (Points* all : {&area_, &along_, &force_, &arrived_}) all->assign(points, Vec3::Zero());
    for (auto* all :
         {&size_, &kept_, &answered_, &mass_, &account_, &fresh_, &pressure_, &arrived_mass_})
        all->assign(points, 0.0);
    brought_.resize(points);
    age_.assign(points, INF);
    node_force_.assign(held.size(), Vec3::Zero());
    owed_.resize(surface_->rooms());
    jet_owed_.assign(jet_nodes_.size(), Vec3::Zero());
    jet_force_.assign(jet_nodes_.size(), Vec3::Zero());
}

// ---- what comes

void WallLoad::receive(FlightResult& flight, std::span<const double> mass, Particles& particles) {
    std::size_t i = 0;
    for (auto& hits : flight.hits)
        for (Hit& hit : hits) {
            const auto side = static_cast<std::size_t>(sides_[i++]);
            if (!hit.has_left()) recoil(hit, side, mass[particles.species[hit.row()]], particles);
            take_in(hit, side, mass, particles);
        }
}

/// Gives back to the particle what a wall that recoils did not take, (1 - f) J.
void WallLoad::recoil(Hit& hit, std::size_t side, double mass, Particles& particles) {
    const double share = recoil_.share(*surface_, side, hit.at, mass, smoother_.links());
    if (share == 1.0) return;
    Vec3& v = particles.v[hit.row()];
    const double before = v.squaredNorm();
    v += (1.0 - share) / mass * hit.impulse;
    hit.impulse *= share;
    hit.energy -= 0.5 * mass * (v.squaredNorm() - before);
}

void WallLoad::find_sides(const FlightResult& flight, std::span<const Vec3> x_0,
                          std::span<const Vec3> x_1) {
    sides_.clear();
    for (const auto& hits : flight.hits)
        for (const Hit& hit : hits) sides_.push_back(static_cast<Index>(side_of(hit, x_0, x_1)));
}

void WallLoad::charge(std::span<const Index> points, double energy) {
    double all = 0.0;
    for (const Index p : points) all += size_[p];
    for (const Index p : points) account_[p] -= energy * size_[p] / all;
    taken_ -= energy;
}

/// On which side a facet was hit: gas pushes away from itself.
std::size_t WallLoad::side_of(const Hit& hit, std::span<const Vec3> x_0,
                              std::span<const Vec3> x_1) const {
    const auto facet = static_cast<std::size_t>(hit.facet);
    if (surface_->closes(facet)) return surface_->side(facet, false);
    std::array<Vec3, 3> x;
    for (int c = 0; c < 3; ++c) {
        const Index n = surface_->triangles()[facet][c];
        x[c] = 0.5 * (x_0[n] + x_1[n]);
    }
    return surface_->side(facet, hit.impulse.dot(vector_area(x[0], x[1], x[2])) < 0.0);
}

void WallLoad::take_in(const Hit& hit, std::size_t side, std::span<const double> mass,
                       Particles& particles) {
    const std::size_t row = hit.row();
    const double m = mass[particles.species[row]];
    Wrench& owed = owed_[surface_->room(side)];
    double due = 0.0, free = 0.0;
    for (int c = 0; c < 3; ++c) {
        const Index p = surface_->points(side)[c];
        const Vec3 own = hit.at[c] * hit.impulse;
        arrived_[p] += own;
        arrived_mass_[p] += hit.at[c] * m;
        fresh_[p] += hit.at[c] * hit.energy;
        due += hit.at[c] * account_[p];
        if (held_[p] == 0) free += hit.at[c];
    }
    owed.add(hit.where, free * hit.impulse);
    held_owed_.add(hit.where, (1.0 - free) * hit.impulse);
    taken_ += hit.energy;
    if (due == 0.0 || hit.has_left()) return;
    double& internal = particles.e[row];
    const double motion = 0.5 * m * particles.v[row].squaredNorm();
    const double most = MOST_PAID * std::max(0.0, motion + internal),
                 bearable = std::max(0.0, internal + MOST_DEBT * motion);
    const double paid = std::clamp(due, -std::min(most, bearable), most);
    internal += paid;
    taken_ -= paid;
    for (int c = 0; c < 3; ++c) {
        const Index p = surface_->points(side)[c];
        account_[p] -= paid / due * hit.at[c] * account_[p];
    }
}

void WallLoad::press(std::span<const double> pressure, Points& f) const {
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        Vec3 force = Vec3::Zero();
        for (Index k = node_start_[i]; k < node_start_[i + 1]; ++k) {
            const Index p = of_node_[k];
            force += pressure[surface_->room_of_point(p)] * area_[p];
        }
        f[nodes_[i]] = force;
    });
}

void WallLoad::owe_jet(Index node, const Vec3& at, const Vec3& impulse, double energy) {
    const auto j = static_cast<std::size_t>(std::find(jet_nodes_.begin(), jet_nodes_.end(), node) -
                                            jet_nodes_.begin());
    jet_owed_[j] += impulse;
    jet_wrench_.add(at, impulse);
    jet_account_ += energy;
    taken_ += energy;
}

double WallLoad::pay_jets() {
    taken_ -= jet_account_;
    return std::exchange(jet_account_, 0.0);
}

void WallLoad::begin_with(double pressure, double mass_flux, std::span<const Vec3> x) {
    measure(x);
    for (std::size_t p = 0; p < size_.size(); ++p) {
        age_[p] = 0.0;
        mass_[p] = mass_flux * size_[p] * time_;
        if (held_[p] != 0) continue;
        kept_[p] = pressure * size_[p] * time_;
        owed_[surface_->room_of_point(p)].add(x[surface_->node(p)], kept_[p] * normal(p));
    }
}

void WallLoad::end_of_hits(std::span<const double> pressure, std::span<const Vec3> x) {
    measure(x);
    hits_are_over_ = true;
    for (std::size_t p = 0; p < size_.size(); ++p) {
        mass_[p] = 0.0;
        age_[p] = 0.0;  // all that is owed goes to all of the wall
        if (held_[p] != 0) continue;
        const Index room = surface_->room_of_point(p);
        const double replaced = pressure[room] * size_[p] * time_;
        kept_[p] -= replaced;
        owed_[room].add(x[surface_->node(p)], -replaced * normal(p));
    }
}

// ---- what is given

void WallLoad::measure(std::span<const Vec3> x) {
    surface_->point_areas(x, area_);
    parallel::for_each(size_.size(), [&](std::size_t p) { size_[p] = area_[p].norm(); });
}

void WallLoad::release(double span, std::span<const Vec3> x, std::span<const Vec3> v,
                       std::span<const double> mass, std::span<Vec3> f) {
    measure(x);
    recoil_.weigh(*surface_, mass);
    const std::size_t points = size_.size();
    parallel::for_each(points, [&](std::size_t p) {
        if (!hits_are_over_) age_[p] = arrived_mass_[p] > 0.0 ? 0.0 : age_[p] + span;
        takes_part_[p] = held_[p] == 0 && is_wet(p) && size_[p] > 0.0;
        const double own = arrived_[p].dot(normal(p)), along = own + answered_[p];
        const Vec3 beside = arrived_[p] - own * normal(p);
        const double per_area = takes_part_[p] != 0 ? 1.0 / size_[p] : 0.0;
        brought_[p] = {along * per_area, arrived_mass_[p] * per_area,
                       v[surface_->node(p)].dot(normal(p)), beside * per_area};
        if (held_[p] != 0 || takes_part_[p] != 0) return;
        kept_[p] += along;
        along_[p] += beside;
        mass_[p] += arrived_mass_[p];
    });
    smoother_.prepare(*surface_, area_, size_, takes_part_);
    smoother_.spread(*surface_, brought_);
    last_given_ = owed();
    // F = Q / time, with what has come in this step: late by `time` on average in steps of any
    // length up to that.
    const double share = std::min(1.0, span / time_);
    release_points(share, span, v, mass);
    release_jets(share, span, x);
    balance_momentum(share, span, x);
    held_owed_ = {};
    last_given_ -= owed();
    parallel::for_each(nodes_.size(), [&](std::size_t i) {
        Vec3 sum = Vec3::Zero();
        for (Index k = node_start_[i]; k < node_start_[i + 1]; ++k) sum += force_[of_node_[k]];
        node_force_[nodes_[i]] = sum;
    });
    for (std::size_t j = 0; j < jet_nodes_.size(); ++j) node_force_[jet_nodes_[j]] += jet_force_[j];
    parallel::for_each(nodes_.size(),
                       [&](std::size_t i) { f[nodes_[i]] += node_force_[nodes_[i]]; });
}

/// Force of each point: what is kept is released, and the gas answers to flutter at once.
void WallLoad::release_points(double share, double span, std::span<const Vec3> v,
                              std::span<const double> mass) {
    const double answer = ANSWER + extra_damping_ * std::sqrt(2.0 * std::numbers::pi);
    parallel::for_each(size_.size(), [&](std::size_t p) {
        const Vec3 n = normal(p);
        if (held_[p] != 0) {
            mass_[p] += arrived_mass_[p];
            force_[p] = arrived_[p] / span;
        } else {
            if (takes_part_[p] != 0) {
                kept_[p] += size_[p] * brought_[p].push;
                along_[p] += size_[p] * brought_[p].beside;
                mass_[p] += size_[p] * brought_[p].mass;
            }
            // D A, implicit in the motion that it damps: stable in any step.
            const double damper = answer * share * mass_[p] / span;
            const Index node = surface_->node(p);
            const double flutter = v[node].dot(n) - brought_[p].speed;
            const double damped = damper / (1.0 + damper * span / mass[node]) * flutter;
            answered_[p] = span * damped;
            const double given = share * kept_[p];
            const Vec3 beside = share * along_[p];
            kept_[p] -= given;
            along_[p] -= beside;
            force_[p] = (given / span - damped) * n + beside / span;
        }
        mass_[p] -= share * mass_[p];
        pressure_[p] = size_[p] > 0.0 ? force_[p].dot(n) / size_[p] : 0.0;
        arrived_[p].setZero();
        arrived_mass_[p] = 0.0;
    });
}

void WallLoad::release_jets(double share, double span, std::span<const Vec3> x) {
    for (std::size_t j = 0; j < jet_nodes_.size(); ++j) {
        const Vec3 given = jet_held_[j] != 0 ? jet_owed_[j] : Vec3(share * jet_owed_[j]);
        jet_owed_[j] -= given;
        jet_force_[j] = given / span;
        Wrench done;
        done.add(x[jet_nodes_[j]], given);
        jet_wrench_ -= done;
    }
}

/// What each room's free wall is owed, less what its points keep, is given over its wetted points
/// as a rigid field,
///
///     F_p = A_p (a + b × (x_p - c)),
///
/// c: their centre by area; a and b such that force and moment are right.
void WallLoad::balance_momentum(double share, double span, std::span<const Vec3> x) {
    struct Sums {
        Wrench given, kept;
        double area = 0.0;
        Vec3 first = Vec3::Zero();
        Mat3 second = Mat3::Zero();
        Sums& operator+=(const Sums& o) {
            given += o.given;
            kept += o.kept;
            area += o.area;
            first += o.first;
            second += o.second;
            return *this;
        }
    };
    const Vec3 origin = x[surface_->node(0)];
    std::vector<double> wet(owed_.size(), 0.0), free(owed_.size(), 0.0);
    for (std::size_t p = 0; p < size_.size(); ++p) {
        if (held_[p] != 0) continue;
        const Index room = surface_->room_of_point(p);
        free[room] += size_[p];
        if (takes_part_[p] != 0) wet[room] += size_[p];
    }
    for (std::size_t r = 0; r < owed_.size(); ++r) {
        const auto room = static_cast<Index>(r);
        const auto counts = [&](std::size_t p) {
            return surface_->room_of_point(p) == room && held_[p] == 0;
        };
        // A few wet points have no lever: then all of the wall bears it.
        const bool is_spread = wet[r] > LEAST_WET * free[r];
        const auto bears = [&](std::size_t p) {
            return counts(p) && size_[p] > 0.0 && (!is_spread || takes_part_[p] != 0);
        };
        const Sums sums = parallel::sum(size_.size(), Sums{}, [&](std::size_t p) {
            Sums own;
            if (!counts(p)) return own;
            const Vec3& at = x[surface_->node(p)];
            own.given.add(at, span * force_[p]);
            own.kept.add(at, (kept_[p] + answered_[p]) * normal(p) + along_[p]);
            if (!bears(p)) return own;
            const Vec3 d = at - origin;
            own.area = size_[p];
            own.first = size_[p] * d;
            own.second = size_[p] * d * d.transpose();
            return own;
        });
        Wrench& owed = owed_[r];
        owed -= sums.given;
        if (!(sums.area > 0.0)) continue;
        const Vec3 centre = sums.first / sums.area;  // from origin
        const Mat3 second = sums.second - sums.area * centre * centre.transpose();
        const Mat3 inertia = second.trace() * Mat3::Identity() - second;
        Wrench rest = owed;
        rest -= sums.kept;
        const Vec3 a = share * rest.linear / sums.area;
        const Vec3 moment = share * (rest.angular - (origin + centre).cross(rest.linear));
        constexpr double FLAT = 1e-3;  // of its size³: points on a line have no moment about it
        const double size = inertia.trace();
        const bool turns = inertia.determinant() > FLAT * size * size * size;
        const Vec3 b = turns ? Vec3(inertia.inverse() * moment) : Vec3(Vec3::Zero());
        parallel::for_each(size_.size(), [&](std::size_t p) {
            if (!bears(p)) return;
            const Vec3 d = x[surface_->node(p)] - origin - centre;
            force_[p] += size_[p] / span * (a + b.cross(d));
        });
        Wrench corrected;
        corrected.linear = sums.area * a;
        corrected.angular = (origin + centre).cross(corrected.linear) + inertia * b;
        owed -= corrected;
    }
}

double WallLoad::book(std::span<const Vec3> v_mid, double span) {
    double work = span * parallel::sum(size_.size(), 0.0, [&](std::size_t p) {
                      const double own = force_[p].dot(v_mid[surface_->node(p)]);
                      account_[p] += fresh_[p] - span * own;
                      fresh_[p] = 0.0;
                      return own;
                  });
    for (std::size_t j = 0; j < jet_nodes_.size(); ++j) {
        const double own = span * jet_force_[j].dot(v_mid[jet_nodes_[j]]);
        jet_account_ -= own;
        work += own;
    }
    pass_on_accounts();
    return work;
}

/// Accounts of points that gas has left go to those of their room where it is, by area: a few
/// particles would leave gains at one place, pay losses at another, and owe more than they hold.
void WallLoad::pass_on_accounts() {
    std::vector<double> left(owed_.size(), 0.0), wet(owed_.size(), 0.0);
    for (std::size_t p = 0; p < account_.size(); ++p)
        (is_wet(p) ? wet : left)[surface_->room_of_point(p)] += is_wet(p) ? size_[p] : account_[p];
    for (std::size_t p = 0; p < account_.size(); ++p) {
        const Index room = surface_->room_of_point(p);
        if (wet[room] > 0.0)
            account_[p] = is_wet(p) ? account_[p] + left[room] * size_[p] / wet[room] : 0.0;
    }
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

double WallLoad::pressure_at_node(Index node) const {
    const Index i = place_[node];
    if (i < 0 || node_start_[i] == node_start_[i + 1]) return 0.0;
    double sum = 0.0, size = 0.0;
    for (Index k = node_start_[i]; k < node_start_[i + 1]; ++k) {
        sum += size_[of_node_[k]] * pressure_[of_node_[k]];
        size += size_[of_node_[k]];
    }
    return size > 0.0 ? sum / size : 0.0;
}

Wrench WallLoad::owed(double done) const {
    Wrench sum = last_given_;
    sum *= 1.0 - done;
    sum += jet_wrench_;
    sum += held_owed_;
    for (const Wrench& room : owed_) sum += room;
    return sum;
}

}  // namespace corpuscle::gas
