// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/flight/flight.hpp"
#include "gas/flight/transmission.hpp"
#include "gas/outflow/gas_state.hpp"
#include "gas/outflow/wall_samples.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// One way out of a room, or between two. A vent is one opening for each room that it leads out
/// of; fabric that leaks is one for each patch of it (WallSamples).
struct Opening {
    /// Of what arrives at fabric that leaks, of each gas.
    struct Seepage {
        std::vector<double> share;  ///< that is to pass in this step                     [-]
        std::vector<double> flow;   ///< that the law wants in this step; 0: all pass    [kg/s]
        std::vector<double> most;   ///< that of it may be due                            [kg]
        std::vector<double> due;    ///< wanted and not passed yet                        [kg]

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(share, due);
        }
    };
    /// The other side.
    struct Ahead {
        Index room = 0;
        std::vector<Index> points;  ///< of its wall
    };
    /// Closed facets round a vent.
    struct Collar {
        std::vector<Index> facets;  ///< rows
        double arriving = 0.0;      ///< as `arriving`, there                             [kg/s]
    };
    enum class Law {
        PLAIN,       ///< a share of those that arrive passes
        ISENTROPIC,  ///< Wang-Nefske flow through an area
        SEEPAGE      ///< density · area · velocity
    };
    Law law = Law::PLAIN;
    bool is_internal = false;
    bool is_strong = false;      ///< C23 above 1: draws on its room as a whole
    Index vent = -1, leak = -1;  ///< row of its card, of one kind or the other
    std::vector<Index> facets;
    Collar collar;
    Index room = 0;     ///< that it leads out of; of an internal one the one behind it
    Ahead ahead;        ///< of internal fabric that leaks
    Index sample = -1;  ///< row in WallSamples that tells the state; internal vents: none
    /// A part's share of the free area.
    struct OfPart {
        Index part;         ///< row
        double area = 0.0;  ///< [m^2]
    };
    std::vector<OfPart> parts;  ///< one or more
    double first_area = 0.0;    ///< A0 of a leak: at the start, or of the reference shape [m^2]
    bool has_opened = false;    ///< PPOP has been passed, beyond chance

    // This step's
    double area = 0.0;      ///< of all facets                                        [m^2]
    double free = 1.0;      ///< share of it that contact leaves                      [-]
    double flow = 0.0;      ///< wanted of the particles, ISENTROPIC                  [kg/s]
    double air_flow = 0.0;  ///< of the air that is no particles                      [kg/s]
    double intake = 0.0;    ///< of ambient air, IAIR = -1                            [kg/s]
    double air_heat = 1.0;  ///< share of R T by which each mole of it carries more than u [-]

    // Carried from step to step
    double due = 0.0;              ///< wanted and not passed yet                     [kg]
    std::vector<Seepage> seepage;  ///< SEEPAGE: of what comes from `room`, from ahead
    double arriving = 0.0;         ///< flow that arrives, smoothed, by weight        [kg/s]
    double memory = 0.0;           ///< time over which it is smoothed                [s]
    double short_of = 0.0;         ///< beyond what all arrivals could give           [kg]
    double mass_out = 0.0;         ///< so far                                        [kg]

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(has_opened, area, free, flow, air_flow, intake, air_heat, due, seepage, arriving,
                collar.arriving, memory, short_of, mass_out);
    }
};

/// Vents and porous fabric of one bag: sets the transmission for flight and balances the outflow.
///
/// An isentropic opening follows the Wang-Nefske flow of the state of the gas at it (WallSamples):
/// the chance to pass is the wanted flow over the flow that arrives, as measured at the opening,
/// and what has passed too little or too much is made good in the next steps, as far as `memory`
/// reaches. Chances go with sqrt(M), as molecules effuse with 1 / sqrt(M), so gas leaves as it is
/// mixed at the opening. Where all that arrive are too few (gas at rest effuses 0.58 of the choked
/// flow), the collar, closed fabric round the vent, lets out what is missing; its fabric is pushed
/// as if nobody left there. A pressure difference d that is known to within e makes the flow of
/// d (1 - (3 e / d)²), none below 3 e: chance alone drives nothing out.
class Openings {
public:
    /// Errors: InputError for an opening that has no facets in the bag.
    /// @param surface  its triangles are those of the walls, the closing ones turned outward
    Openings(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves,
             std::span<const Species> species, std::span<const double> particle_mass,
             const WettedSurface& surface, WallSamples& samples, std::span<const Vec3> x,
             std::uint64_t seed);

    [[nodiscard]] bool empty() const { return openings_.empty(); }
    [[nodiscard]] const Transmission* transmission() const {
        return empty() ? nullptr : &transmission_;
    }
    [[nodiscard]] const std::vector<Opening>& all() const { return openings_; }

    /// Takes what touches out of the open area, and of external vents where BLOCK says so only
    /// what contact presses harder than the gas.                                      N × 1
    void block(std::span<const std::uint8_t> touching, std::span<const std::uint8_t> pressed);

    /// Chances for a flight over dt from t.
    /// @param inside  the gas at each opening  @param rooms  that in each room
    void set_transmission(double t, double dt, std::span<const Vec3> x,
                          std::span<const Inside> inside, std::span<const Inside> rooms);
    /// The same for one opening.
    void set_chances(std::size_t row, double t, double dt, std::span<const Vec3> x,
                     const Inside& inside);
    /// Cuts flows of air and of ambient air down to what brings a room to the pressure outside in
    /// dt; after set_chances() of its openings.
    /// @param volume  of rooms                                                      [m^3]
    void keep_to_balance(double dt, std::span<const double> volume);
    /// Whether an internal opening lets the gas of each side through, whatever is on the other:
    /// fabric whose flow does not go with a pressure difference.
    [[nodiscard]] bool seeps(std::size_t row) const;
    /// Internal openings that do not, through which gas goes to the lower pressure.
    [[nodiscard]] double holes() const;
    /// Flow through an internal opening from gas of one state to where there is p_out, no particles
    /// on either side.                                                                  [kg/s]
    [[nodiscard]] double flow_between(std::size_t row, double t, const Inside& from, double p_out);
    /// Flow of the air that is no particles from a room through an internal opening, its share of
    /// the flow; through a hole 0 where the other's pressure is not lower beyond chance.    [kg/s]
    [[nodiscard]] double air_between(std::size_t row, double t, const Inside& from,
                                     const Inside& to);
    void book(std::size_t row, double mass);  ///< that has left without particles         [kg]

    /// What the last flight let out.
    struct Passed {
        double energy = 0.0;  ///< that the particles carried with them            [J]
        /// By opening: enthalpy that they should have, less that; of internal ones what goes on
        /// to the room ahead.                                                            [J]
        std::vector<double> still_owed;
        std::vector<std::size_t> rows;  ///< of the particles, ascending
    };
    /// @param inside, rooms  as in set_transmission()  @param species  of the particles
    const Passed& count(const FlightResult& flight, double dt, std::span<const Inside> inside,
                        std::span<const Inside> rooms, std::span<const std::int32_t> species);

    /// Mass of a room's air that wants to leave in dt, and the factor k in its energy
    /// u + k R T / M.
    struct Air {
        double mass = 0.0, heat = 1.0;
    };
    [[nodiscard]] Air air_leaving(std::size_t room, double dt) const;
    [[nodiscard]] double intake(std::size_t room) const;  ///< of ambient air          [kg/s]
    void book_air(std::size_t room, double mass);  ///< that has left                         [kg]

    [[nodiscard]] double mass_out(bool through_vents) const;  ///< else through fabric        [kg]
    [[nodiscard]] std::span<const double> part_mass_out() const { return part_mass_out_; }
    [[nodiscard]] std::size_t particles_out() const { return particles_out_; }
    [[nodiscard]] std::vector<std::string> shortages() const;  ///< in the user's words

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(openings_, transmission_, part_mass_out_, particles_out_);
    }

private:
    void book_by_part(const Opening& opening, double mass);
    static void fall_due(Opening& opening, double dt);
    void add_vent(const BagWalls& walls, const VentCard& vent, Index row,
                  const WettedSurface& surface);
    void add_leak(const BagWalls& walls, const LeakCard& leak, Index row,
                  const WettedSurface& surface, const WallSamples& samples,
                  std::span<const Vec3> x);
    static void add_ahead(Opening& opening, const WettedSurface& surface);
    void add_opening(Opening opening, bool counts_all, double push);
    void add_collar(Opening& opening, Index row, double wanted, std::span<const Index> sides,
                    const WettedSurface& surface, std::span<const Vec3> x);
    [[nodiscard]] std::vector<Index> surroundings(const Opening& opening, double wanted,
                                                  const WettedSurface& surface,
                                                  std::span<const Vec3> x) const;
    template <class Take>
    void grow_rings(const Opening& opening, const WettedSurface& surface, std::span<const Vec3> x,
                    double wanted, Take&& take) const;
    [[nodiscard]] double most(const VentCard& vent) const;

    [[nodiscard]] double area_of(std::span<const Index> facets, std::span<const Vec3> x) const;
    [[nodiscard]] double curve_or(Index curve, double at, double otherwise) const;
    [[nodiscard]] double vent_factor(Opening& opening, double t, const Inside& inside) const;
    [[nodiscard]] double steered(const Opening& opening, Opening::Seepage& seepage,
                                 std::size_t species, double dt, const Inside& inside) const;
    [[nodiscard]] double leak_share(const Opening& opening, double t) const;
    [[nodiscard]] double leak_area(const Opening& opening, const Inside& inside) const;
    void measure(Opening& opening, std::span<const Vec3> x) const;
    void compare(const Opening& opening, const Inside& inside);
    void close(Index row);
    void set_plain(Index row, double share, std::span<const Vec3> x, const Inside& inside);
    void set_isentropic(Index row, double area, double dt, const Inside& inside);
    void set_intake(Index row, double t, double area, const Inside& inside);
    void set_seepage(Index row, double t, double dt, const Inside& inside);
    void set_between(Index row, double t, double dt, std::span<const Inside> rooms);
    [[nodiscard]] double seepage_velocity(const Opening& opening, double t, const Inside& from,
                                          double p_out, double own, double molar_mass) const;
    void count_through(const Arrival& arrival, std::span<const Inside> rooms, std::int32_t species);
    void expect_arrivals(Opening& opening, double dt, const Inside& inside) const;

    std::string name_;  ///< of the bag
    std::vector<VentCard> vents_;
    std::vector<LeakCard> leaks_;
    std::vector<Curve> curves_;
    std::vector<Species> species_;
    std::vector<double> mass_;    ///< of one particle, by species                       [kg]
    double heaviest_ = 0.0;       ///< of them                                            [kg]
    std::vector<double> weight_;  ///< sqrt(M / heaviest M), by species                   [-]
    std::vector<Triangle> triangles_;
    std::vector<Index> part_, shell_;  ///< by facet
    BlockCard block_;
    std::vector<int> part_ids_;
    double p_atm_, T_atm_, gas_constant_;
    std::optional<Species> ambient_;  ///< comes in where the bag's pressure is lower

    /// By which a room's gas is denser, or thinner, than at the pressure outside, as far as its
    /// openings see.                                                              [kg/m^3]
    struct Imbalance {
        double excess = 0.0, lack = 0.0;
    };
    std::vector<Imbalance> imbalance_;  ///< by room

    std::vector<Opening> openings_;
    Transmission transmission_;
    Passed passed_;
    std::vector<double> came_, came_to_collar_;  ///< by opening, in one flight          [kg]
    std::vector<double> part_mass_out_;          ///< [kg]
    std::size_t particles_out_ = 0;
};

}  // namespace corpuscle::gas
