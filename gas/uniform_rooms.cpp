// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/uniform_rooms.hpp"

#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

UniformRooms::UniformRooms(std::shared_ptr<const WettedSurface> surface,
                           std::vector<ControlVolume> rooms, std::size_t node_count)
    : surface_(std::move(surface)),
      rooms_(std::move(rooms)),
      by_node_(*surface_, {}, node_count),
      area_(surface_->points(), Vec3::Zero()),
      force_(node_count, Vec3::Zero()) {}

bool UniformRooms::settle(std::span<const Vec3> x, std::span<const double> volume) {
    surface_->point_areas(x, area_);
    bool is_good = true;
    for (std::size_t r = 0; r < size(); ++r) is_good = rooms_[r].settle(volume[r]) && is_good;
    parallel::for_each(by_node_.nodes.size(),
                       [&](std::size_t i) { force_[by_node_.nodes[i]] = force_on(i); });
    return is_good;
}

void UniformRooms::add_force(std::span<Vec3> f) const {
    parallel::for_each(by_node_.nodes.size(),
                       [&](std::size_t i) { f[by_node_.nodes[i]] += force_[by_node_.nodes[i]]; });
}

/// Of a row of by_node_.                                                                      [N]
Vec3 UniformRooms::force_on(std::size_t row) const {
    Vec3 force = Vec3::Zero();
    for (Index k = by_node_.start[row]; k < by_node_.start[row + 1]; ++k) {
        const Index p = by_node_.points[k];
        force += rooms_[surface_->room_of_point(p)].pressure() * area_[p];
    }
    return force;
}

void UniformRooms::work(std::span<const Vec3> v_mid, double span) {
    for (std::size_t r = 0; r < size(); ++r)
        rooms_[r].work(span * parallel::sum(area_.size(), 0.0, [&](std::size_t p) {
                           return surface_->room_of_point(p) == static_cast<Index>(r)
                                      ? area_[p].dot(v_mid[surface_->node(p)])
                                      : 0.0;
                       }));
}

double UniformRooms::energy() const {
    double sum = 0.0;
    for (const ControlVolume& room : rooms_) sum += room.energy();
    return sum;
}

double UniformRooms::mass() const {
    double sum = 0.0;
    for (const ControlVolume& room : rooms_) sum += room.mass();
    return sum;
}

double UniformRooms::moles(std::size_t species) const {
    double sum = 0.0;
    for (const ControlVolume& room : rooms_) sum += room.moles(species);
    return sum;
}

double UniformRooms::energy(std::size_t species) const {
    double sum = 0.0;
    for (const ControlVolume& room : rooms_)
        sum += room.moles(species) * room.species()[species].molar_energy()(room.temperature());
    return sum;
}

double UniformRooms::pressure() const {
    double pV = 0.0, V = 0.0;
    for (const ControlVolume& room : rooms_) {
        pV += room.pressure() * room.volume();
        V += room.volume();
    }
    return pV / V;
}

double UniformRooms::temperature() const {
    if (rooms_.size() == 1) return rooms_[0].temperature();
    EnergyPolynomial content;
    for (const ControlVolume& room : rooms_)
        for (std::size_t s = 0; s < room.species().size(); ++s)
            content += room.moles(s) * room.species()[s].molar_energy();
    return content.temperature(energy());
}

void UniformRooms::pass(std::size_t from, std::size_t to, double mass) {
    if (!(mass > 0.0)) return;
    ControlVolume& giver = rooms_[from];
    ControlVolume& taker = rooms_[to];
    const double share = mass / giver.mass();
    for (std::size_t s = 0; s < giver.species().size(); ++s)
        taker.add(s, share * giver.moles(s), 0.0);
    taker.add_heat(giver.remove(mass));
}

double evening_mass(const ControlVolume& from, const ControlVolume& to) {
    return (from.pressure() - to.pressure()) /
           (from.gamma() * from.gas_constant() * from.temperature() *
            (1.0 / from.volume() + 1.0 / to.volume()));
}

}  // namespace corpuscle::gas
