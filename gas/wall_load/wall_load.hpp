// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gas/enclosure/node_points.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/flight/flight.hpp"
#include "gas/particles.hpp"
#include "gas/wall_load/body_couples.hpp"
#include "gas/wall_load/point_smoother.hpp"
#include "gas/wall_load/recoil.hpp"
#include "gas/wall_load/wall_hits.hpp"
#include "gas/wall_load/wrench.hpp"
#include "solver/base/tasks.hpp"

namespace corpuscle::gas {

/// Times of a bag's load.                                                           [s]
struct LoadTimes {
    double release;  ///< of the exponential release: the load's delay
    double memory;   ///< of what hits a point: D, and whether gas is there

    static constexpr double LONGEST = 50e-6;  ///< at SFFDC = 1

    /// Delay of a bag of so many particles and wall points: noise brings each point a share of a
    /// particle's energy that falls with the delay, so the more particles, the shorter it may be.
    ///
    ///     release = longest · min(1, max(0.1, 3 points / particles))
    ///
    /// @param longest  LONGEST · SFFDC                                                        [s]
    static LoadTimes of(double longest, std::size_t points, std::size_t particles) {
        constexpr double NOISY = 3.0;  // particles a wall point: of as many the longest
        constexpr double LEAST = 0.1;
        const double noise = NOISY * static_cast<double>(points) / static_cast<double>(particles);
        return {longest * std::clamp(noise, LEAST, 1.0), longest};
    }
};

/// Impulse that wall points are owed.                                           by point
struct DeferredImpulse {
    std::vector<double> normal;    ///< Q                                           [N s]
    Points along;                  ///< V                                           [N s]
    std::vector<double> answered;  ///< D w A of the last release: to be smoothed   [N s]
    std::vector<double> mass;      ///< of hits, kept as Q                          [kg]
    std::vector<double> age;       ///< since the last hit                          [s]

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(normal, answered, along, mass, age);
    }
};

/// What jets have pushed nodes with.                                               by node
struct WallJets {
    std::vector<Index> nodes;
    std::vector<std::uint8_t> held;
    Points owed, force;           ///< [N s], [N]
    Wrench wrench;                ///< that all of them are owed
    std::vector<Index> room;      ///< by node: into which the last jet that pushed it blew
    std::vector<double> account;  ///< by room: what jets took beyond the work of their push [J]

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(owed, wrench, room, account);
    }
};

/// What the last release gave.
struct WallRelease {
    Points force;                  ///< points × 3                                  [N]
    Points on_node;                ///< N × 3                                       [N]
    std::vector<double> pressure;  ///< by point                                    [Pa]
    std::vector<double> uneven;    ///< by point: of what is kept (PointSmoother::unevenness)
    std::vector<double> swept;     ///< by its room's wall, as it was booked        [m^3/s]
    Wrench wrench;
    double share =
        0.0;  ///< of what was kept; BEGINS: none has been, and the next spans half a step

    static constexpr double BEGINS = -1.0;

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(force, on_node, pressure, wrench, share);
    }
};

/// What particles do to the walls: deferred impulse and an account of energy, at wall points.
///
/// One hit on a light facet is a kick of tens of m/s, so what hits bring is smoothed, in space
/// along the wetted surface (point_smoother.hpp) and in time, and nothing of it is lost:
///
///     dQ_p/dt = S(J·n + D w A)_p - Q_p / t,   F_p = (Q_p / t - D w A) n_p + V_p / t
///     dV_p/dt = S(J - (J·n) n)_p - V_p / t
///
/// t: LoadTimes::release. Q: deferred normal impulse, kept along the normal n, so that it turns with the cloth; V: what of
/// an impulse J is not along n. A point that moves at w along n is hit with D w A less (D = 4 times
/// the mass that hits it per area and time, whatever the gas's distribution of velocities).
/// Smoothing would bring this answer of the gas late, so it is given at once, and what is smoothed
/// are the hits on a wall at rest, J·n + D w A.
///
/// - *Momentum.* What each room's wall is owed, linear and angular, is what hits brought less what
///   was given: exact. Where turning and spreading have moved what is kept away from that, a rigid
///   field of force, weighted by how uneven the load is, makes it good within t.
/// - *Energy.* The work of F differs from what hits took. Each point keeps the difference in an
///   account; hits at the point pay it with the particle's internal energy. Other debts of the gas
///   to the wall or past it (heat, enthalpy of what left) go through the same account. A point
///   that gas has left passes its account on to the points of its room where gas is.
/// - *Recoil.* A free wall takes from a hit what a body of the mass that bears it does.
/// - A point on a node that supports, motions or bodies carry passes impulse on at once: there
///   it does no harm, and work is done where it arises. Bodies that can turn get the moment that
///   hits had (body_couples.hpp).
class WallLoad {
public:
    /// @param held  N: 1 for nodes that supports, motions or rigid bodies carry
    /// @param extra_damping  VNDAMP: adds so many rho sqrt(R T / M) to D                  [-]
    /// @param body  N: row of the rigid body that carries a node and can turn, or -1; empty: none
    WallLoad(std::shared_ptr<const WettedSurface> surface, std::span<const std::uint8_t> held,
             std::span<const Index> jet_nodes, LoadTimes times, double extra_damping,
             std::span<const Index> body = {});

    /// Tells on which sides of the wall a flight's hits were. All three are to last until receive().
    void find_sides(FlightResult& flight, std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
        hits_.list(flight, x_0, x_1);
    }
    /// The hits by side and patch.
    [[nodiscard]] const WallHits& hits() const { return hits_; }
    /// Takes in a flight's hits, patch by patch in their order, pays accounts to the particles that
    /// hit, each at its last hit of the flight. After find_sides(). Where cloth recoils, hits and particles are set right for it
    /// (recoil.hpp).
    void receive(FlightResult& flight, std::span<const double> mass, Particles& particles);
    /// Takes in the push on a node of a jet into a room, and the energy that goes with it.
    void owe_jet(Index node, Index room, const Vec3& at, const Vec3& impulse, double energy);
    /// Energy that jets into a room took beyond the work of their push: what a particle that enters
    /// there gets of it, or pays, as one that hits does.                                   [J]
    [[nodiscard]] double pay_jets(Index room, double internal, double motion);
    /// All of a room's.                                                                    [J]
    [[nodiscard]] double pay_jets(Index room);

    /// As if a gas had long been there: its pressure, and the mass that hits per area and time. At
    /// the start of a leapfrog: the next release spans half of the step whose hits follow it.
    void begin_with(double pressure, double mass_flux, std::span<const Vec3> x);
    /// No more hits will come: uniform pressures (a row a room) take the place of what hits gave on
    /// average; what they brought beyond is still released, until that is next to nothing.
    void end_of_hits(std::span<const double> pressure, std::span<const Vec3> x);

    /// f += force over `span` at t.  v: N × 3 at the last half step [m/s], mass: N [kg]
    void release(double span, std::span<const Vec3> x, std::span<const Vec3> v,
                 std::span<const double> mass, std::span<Vec3> f);
    /// Books the work of the last release on accounts; returns it.                       [J]
    double book(std::span<const Vec3> v_mid, double span);
    /// What a room's wall sweeps, sum of A·v_mid at the last book() before the end of hits. [m^3/s]
    [[nodiscard]] double swept(std::size_t room) const { return released_.swept[room]; }
    /// Force of the last release on a node.                                              [N]
    [[nodiscard]] const Vec3& force(Index node) const { return released_.on_node[node]; }

    /// The gas at these points owes so much, by area: it is to pay, or is owed it (negative). [J]
    void charge(std::span<const Index> points, double energy);
    /// Takes a share of a room's accounts out: energy that its gas is to get.             [J]
    double drain(std::size_t room, double share);
    /// All that accounts got but work: what hits and jets took, less what was paid and charged. [J]
    [[nodiscard]] double taken() const { return taken_; }

    /// Pressure that particles exert at a point, smoothed.                                  [Pa]
    [[nodiscard]] double pressure(std::size_t point) const { return released_.pressure[point]; }
    /// Mean over the points of a node's rooms: the pressure on its inside.                  [Pa]
    [[nodiscard]] double pressure_at_node(Index node) const;
    /// Mean over the points of a node's rooms of what has a value in each room.
    [[nodiscard]] double mean_at_node(Index node, std::span<const double> by_room) const;
    /// Has gas been at the point within a few times of memory?
    [[nodiscard]] bool is_wet(std::size_t point) const {
        return deferred_.age[point] < DRY_AFTER * times_.memory;
    }

    /// What the wall was owed when `done` of the last release had been given.
    [[nodiscard]] Wrench owed(double done = 1.0) const;
    [[nodiscard]] double time() const { return times_.release; }
    [[nodiscard]] const WettedSurface& surface() const { return *surface_; }
    [[nodiscard]] std::span<const Vec3> area() const { return area_; }  ///< points × 3 [m^2]
    /// What a pressure in each room pushes the wall's nodes with: f is that, and sum += f.
    /// @param pressure  by room                                                            [Pa]
    /// @param f, sum    N × 3                                                               [N]
    void press(std::span<const double> pressure, Points& f, Points& sum) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(deferred_, released_, jets_, account_, fresh_, arrived_, arrived_mass_, owed_,
                at_held_.owed, at_held_.couples, taken_, since_hits_);
    }

private:
    /// Times of memory after the last hit from which a point counts as one that gas has not reached.
    static constexpr double DRY_AFTER = 4.0;
    /// Times of release after the last hit from which nothing is released: exp(-40) is less than the
    /// rounding of what it was.
    static constexpr double AT_REST_AFTER = 40.0;
    [[nodiscard]] bool hits_are_over() const { return since_hits_ >= 0.0; }
    [[nodiscard]] bool is_at_rest() const { return since_hits_ > AT_REST_AFTER * times_.release; }

    /// What hits of one patch bring to its room.
    struct alignas(64) Tally {
        Wrench owed, held;
        double taken = 0.0;  ///< [J]
    };
    void set_right(FlightResult& flight, std::span<const double> mass, Particles& particles) const;
    void take_in(const WallHits::Met& met, std::span<const double> mass, Particles& particles,
                 Tally& tally);
    void take_in_of_body(const Hit& hit, const std::array<Index, 3>& points, Tally& tally);
    void settle(const WallHits::Met& met, double m, double due, Particles& particles, Tally& tally);
    void add(const Tally& tally, Index room);
    void measure(std::span<const Vec3> x);
    void find_brought(double span, std::span<const Vec3> x, std::span<const double> mass);
    void release_points(double share, double span, std::span<const Vec3> v,
                        std::span<const double> mass);
    void release_jets(double share, double span, std::span<const Vec3> x);
    void owe(std::size_t p, double impulse, std::span<const Vec3> x);
    void fill_first_span(double span, std::span<const Vec3> x);
    void take_half_step(double share, std::span<const Vec3> x);
    void release_hits(double share, double span, std::span<const Vec3> x, std::span<const Vec3> v,
                      std::span<const double> mass, std::span<Vec3> f);
    void come_to_rest();
    template <class Value>
    [[nodiscard]] double mean_over_points(Index node, Value&& value) const;
    double book_hits(std::size_t room, std::span<const Vec3> v_mid, double span);
    void balance_momentum(double share, double span, std::span<const Vec3> x);
    [[nodiscard]] Vec3 normal(std::size_t p) const {
        return size_[p] > 0.0 ? Vec3(area_[p] / size_[p]) : Vec3(Vec3::Zero());
    }

    std::shared_ptr<const WettedSurface> surface_;
    PointSmoother smoother_;
    Recoil recoil_;
    std::vector<std::uint8_t> held_;        ///< by point
    std::vector<std::uint8_t> takes_part_;  ///< in smoothing, this step
    LoadTimes times_;
    double extra_damping_;

    Points area_;               ///< points × 3, at t                                     [m^2]
    std::vector<double> size_;  ///< its norm                                             [m^2]
    std::vector<Brought> brought_;
    DeferredImpulse deferred_;
    WallRelease released_;
    NodePoints by_node_;
    WallJets jets_;
    std::vector<double> account_;  ///< that hits are to get                             [J]
    std::vector<double> fresh_;    ///< taken by hits since the last release             [J]
    Points arrived_;               ///< since the last release                           [N s]
    std::vector<double> arrived_mass_;
    std::vector<Wrench> owed_;  ///< by room; without held points
    struct {
        Wrench owed;          ///< given at the next release
        BodyCouples couples;  ///< of those that bodies carry
    } at_held_;               ///< points that are held
    WallHits hits_;
    struct {
        std::vector<Tally> tally;     ///< by patch
        parallel::TaskShares shares;  ///< dealt now and then: hits are soon where they were
        int since = 0;                ///< calls for which they serve
        parallel::Tasks tasks;
    } receiving_;
    double taken_ = 0.0;        ///< [J]
    double since_hits_ = -1.0;  ///< that were the last; below 0: more may come [s]
};

}  // namespace corpuscle::gas
