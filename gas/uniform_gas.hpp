// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gas/envelope.hpp"
#include "gas/gas_phase.hpp"
#include "gas/particle_gas.hpp"
#include "gas/uniform_rooms.hpp"

namespace corpuscle::gas {

/// A bag's gas after TSW: uniform in each room; initial air is its last species.
class UniformGas final : public GasPhase {
public:
    /// Rooms that are empty as yet.
    /// @param bag  outlives this
    explicit UniformGas(Envelope& bag);

    /// Takes over what the rooms' particles and initial air hold: mass and energy stay as they are,
    /// motion about the walls becomes heat, motion with them leaves. Uniform pressure takes the
    /// place of what hits gave on average; what they have brought beyond it is still released.
    /// @param wall  velocity of each room's wall                                            [m/s]
    void take_over(std::span<const Holding> holds, std::span<const Vec3> wall, const Points& x);

    void add_load(const Points& x, Points& f) override;
    [[nodiscard]] Vec3 load_on(Index node) const override { return rooms_.force(node); }
    void book_load(const Points& v_mid, double span) override { rooms_.work(v_mid, span); }

    void prepare(double, const Points&, const Points&) override {}
    void collide(double, const Points&) override {}
    /// All that flows, in and out.
    void inject(double t, double dt, const Points& x_0, const Points& x_1) override;
    void fly(double, double, const Points&, const Points&) override {}

    [[nodiscard]] double stable_step() const override { return INF; }
    [[nodiscard]] double energy() const override { return rooms_.energy(); }
    [[nodiscard]] double pressure(std::size_t room) const override {
        return rooms_[room].pressure();
    }
    void describe(GasState& now) const override;
    void add_rooms(std::span<const double> volume, std::span<const Index> sum_of,
                   std::span<ChamberSum> sums) const override;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(rooms_);
    }

private:
    void sum_up(std::span<const Holding> holds, std::span<const Vec3> wall);
    void settle(const Points& x);
    void thrust(std::size_t inflow, double mass, double t, double dt, const Points& x_0,
                const Points& x_1);
    [[nodiscard]] Inside inside_of(std::size_t room) const;
    void let_out(double t, double dt, const Points& x);
    void let_out_of_room(std::size_t room, double dt);
    void pass_between_rooms(double t, double dt);

    Envelope& bag_;
    UniformRooms rooms_;
};

}  // namespace corpuscle::gas
