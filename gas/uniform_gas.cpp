// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/uniform_gas.hpp"

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

UniformGas::UniformGas(std::vector<Room> rooms, std::size_t node_count) : rooms_(std::move(rooms)) {
    for (Room& room : rooms_) room.area.assign(node_count, Vec3::Zero());
}

bool UniformGas::settle(std::span<const Vec3> x) {
    bool is_good = true;
    for (Room& room : rooms_) {
        room.surface.node_areas(x, room.area);
        is_good = room.gas.settle(room.surface.volume(x)) && is_good;
    }
    return is_good;
}

void UniformGas::add_force(std::span<Vec3> f) const {
    for (const Room& room : rooms_)
        for (const Index n : room.surface.nodes()) f[n] += room.gas.pressure() * room.area[n];
}

Vec3 UniformGas::force(Index node) const {
    Vec3 sum = Vec3::Zero();
    for (const Room& room : rooms_) sum += room.gas.pressure() * room.area[node];
    return sum;
}

void UniformGas::work(std::span<const Vec3> v_mid, double span) {
    for (Room& room : rooms_) {
        const auto nodes = room.surface.nodes();
        room.gas.work(span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
                          return room.area[nodes[i]].dot(v_mid[nodes[i]]);
                      }));
    }
}

void UniformGas::add_heat(double heat) {
    const double all = energy();
    for (Room& room : rooms_)
        room.gas.add_heat(rooms_.size() == 1 ? heat : heat * room.gas.energy() / all);
}

double UniformGas::energy() const {
    double sum = 0.0;
    for (const Room& room : rooms_) sum += room.gas.energy();
    return sum;
}

double UniformGas::mass() const {
    double sum = 0.0;
    for (const Room& room : rooms_) sum += room.gas.mass();
    return sum;
}

double UniformGas::moles(std::size_t species) const {
    double sum = 0.0;
    for (const Room& room : rooms_) sum += room.gas.moles(species);
    return sum;
}

double UniformGas::energy(std::size_t species) const {
    double sum = 0.0;
    for (const Room& room : rooms_)
        sum += room.gas.moles(species) *
               room.gas.species()[species].molar_energy()(room.gas.temperature());
    return sum;
}

double UniformGas::pressure() const {
    double pV = 0.0, V = 0.0;
    for (const Room& room : rooms_) {
        pV += room.gas.pressure() * room.gas.volume();
        V += room.gas.volume();
    }
    return pV / V;
}

double UniformGas::temperature() const {
    if (rooms_.size() == 1) return rooms_[0].gas.temperature();
    EnergyPolynomial content;
    for (const Room& room : rooms_)
        for (std::size_t s = 0; s < room.gas.species().size(); ++s)
            content += room.gas.moles(s) * room.gas.species()[s].molar_energy();
    return content.temperature(energy());
}

void UniformGas::pass(std::size_t from, std::size_t to, double mass) {
    ControlVolume& giver = rooms_[from].gas;
    ControlVolume& taker = rooms_[to].gas;
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
