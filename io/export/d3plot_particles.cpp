// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/d3plot_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/results/results_content.hpp"

namespace corpuscle::io {
namespace {

constexpr std::int64_t LAYOUT_VERSION = 3000;  ///< bags without a count of chambers
constexpr std::int64_t INTEGER = 1, REAL = 2;
constexpr double FAR_AWAY = 1e10;  ///< from the nearest segment: not known
constexpr std::int64_t INSIDE = 0, GONE = 2;

struct Variable {
    std::string_view name;  ///< at most 8 letters
    std::int64_t type;
};
constexpr std::array OF_BAG{Variable{"first id", INTEGER}, Variable{"n parts", INTEGER},
                            Variable{"bag id", INTEGER}, Variable{"n gases", INTEGER}};
constexpr std::array OF_PARTICLE{
    Variable{"gas id", INTEGER}, Variable{"chamber", INTEGER}, Variable{"leakage", INTEGER},
    Variable{"mass", REAL},      Variable{"radius", REAL},     Variable{"spin_en", REAL},
    Variable{"trans_en", REAL},  Variable{"segment", REAL},    Variable{"x", REAL},
    Variable{"y", REAL},         Variable{"z", REAL},          Variable{"vx", REAL},
    Variable{"vy", REAL},        Variable{"vz", REAL}};
constexpr std::array OF_BAG_STATE{Variable{"n active", INTEGER}, Variable{"volume", REAL}};

Vec3 triple(const std::vector<double>& values, std::size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

}  // namespace

D3plotParticles::D3plotParticles(const Hdf5Reader& results) : results_(results) {
    std::vector<std::string> places;
    for (const std::string& frame : frame_groups(results))
        if (results.has(frame + "particles")) places.push_back(frame);
    for (const std::string& at : places) {
        const auto bag = results.read<std::int32_t>(at + "particles/bag");
        const auto id = results.read<std::int64_t>(at + "particles/id");
        for (std::size_t i = 0; i < id.size(); ++i) all_.emplace_back().name = {bag[i], id[i]};
        const auto less = [](const Particle& a, const Particle& b) { return a.name < b.name; };
        std::sort(all_.begin(), all_.end(), less);
        all_.erase(
            std::unique(all_.begin(), all_.end(),
                        [](const Particle& a, const Particle& b) { return a.name == b.name; }),
            all_.end());
    }
    for (auto at = places.rbegin(); at != places.rend(); ++at) take(*at, /*as_first_place=*/true);
    for (std::size_t p = 0; p < all_.size(); ++p) {
        if (bags_.empty() || bags_.back().id != all_[p].name.first) {
            const std::string of = fmt::format("/history/airbag/{}/", all_[p].name.first);
            bags_.push_back({all_[p].name.first, p, 0,
                             static_cast<std::int64_t>(results.names(of + "species").size()),
                             results.read<double>(of + "volume")});
        }
        ++bags_.back().count;
    }
}

/// What a frame says of its particles.
void D3plotParticles::take(const std::string& at, bool as_first_place) {
    for (Particle& particle : all_) particle.is_there = false;
    if (!results_.has(at + "particles")) return;
    const auto bag = results_.read<std::int32_t>(at + "particles/bag");
    const auto id = results_.read<std::int64_t>(at + "particles/id");
    const auto gas = results_.read<std::int32_t>(at + "particles/species");
    const auto x = results_.read<double>(at + "particles/position");
    const auto v = results_.read<double>(at + "particles/velocity");
    const auto spin = results_.read<double>(at + "particles/internal_energy");
    const auto mass = results_.read<double>(at + "particles/mass");
    for (std::size_t i = 0; i < id.size(); ++i) {
        const std::pair name{bag[i], id[i]};
        Particle& of = *std::lower_bound(
            all_.begin(), all_.end(), name,
            [](const Particle& particle, const auto& key) { return particle.name < key; });
        of.position = triple(x, i);
        of.gas = gas[i];
        if (as_first_place) continue;
        of.velocity = triple(v, i);
        of.mass = mass[i];
        of.spin = spin[i];
        of.was_there = of.is_there = true;
    }
}

std::int64_t D3plotParticles::flag() const {
    return all_.empty() ? 0 : LAYOUT_VERSION + static_cast<std::int64_t>(bags_.size());
}

void D3plotParticles::variables(D3plotWords& file) const {
    if (all_.empty()) return;
    for (const std::size_t count :
         {OF_BAG.size(), OF_PARTICLE.size(), all_.size(), OF_BAG_STATE.size()})
        file.integer(static_cast<std::int64_t>(count));
    std::vector<Variable> list(OF_BAG.begin(), OF_BAG.end());
    list.insert(list.end(), OF_PARTICLE.begin(), OF_PARTICLE.end());
    list.insert(list.end(), OF_BAG_STATE.begin(), OF_BAG_STATE.end());
    for (const Variable& variable : list) file.integer(variable.type);
    for (const Variable& variable : list) {  // a letter a word
        std::string name(variable.name);
        name.resize(8, ' ');
        for (const char letter : name) file.integer(letter);
    }
}

void D3plotParticles::bags(D3plotWords& file) const {
    for (const Bag& bag : bags_) {
        file.integer(static_cast<std::int64_t>(bag.first) + 1);
        file.integer(static_cast<std::int64_t>(bag.count));
        file.integer(bag.id);
        file.integer(bag.gases);
    }
}

void D3plotParticles::state(D3plotWords& file, const std::string& at, std::size_t row) {
    if (all_.empty()) return;
    take(at, /*as_first_place=*/false);
    std::vector<double> radius;
    for (const Bag& bag : bags_) {
        const auto first = all_.begin() + static_cast<std::ptrdiff_t>(bag.first);
        const auto inside =
            std::count_if(first, first + static_cast<std::ptrdiff_t>(bag.count),
                          [](const Particle& particle) { return particle.is_there; });
        const double volume = row < bag.volume.size() ? bag.volume[row] : 0.0;
        file.integer(inside);
        file.real(volume);
        radius.push_back(0.5 * std::cbrt(volume / static_cast<double>(bag.count)));
    }
    for (std::size_t b = 0; b < bags_.size(); ++b)
        for (std::size_t p = bags_[b].first; p < bags_[b].first + bags_[b].count; ++p) {
            const Particle& particle = all_[p];
            const bool is_there = particle.is_there;
            const double share = is_there ? 1.0 : 0.0;
            file.integer(particle.gas);
            file.integer(0);
            file.integer(!is_there && particle.was_there ? GONE : INSIDE);
            file.real(share * particle.mass);
            file.real(share * radius[b]);
            file.real(share * particle.spin);
            file.real(share * 0.5 * particle.mass * particle.velocity.squaredNorm());
            file.real(FAR_AWAY);
            for (const double x : particle.position) file.real(x);
            for (const double v : particle.velocity) file.real(share * v);
        }
}

}  // namespace corpuscle::io
