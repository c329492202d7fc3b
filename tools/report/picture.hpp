// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "tools/report/pack.hpp"
#include "tools/report/run_data.hpp"

namespace corpuscle::report {

using Lines = std::vector<double>;

/// A frame as it is drawn.
struct Picture {
    Lines x;                          ///< N × 3
    Lines pressure, stress, contact;  ///< contact pressure; empty: the run has no contact
    Lines particles;                  ///< P × 3
    std::vector<std::int32_t> species;
    Lines speed, temperature;  // the latter empty: results of before 0.2
};

/// Every n-th, so that no more than `most` are left.
inline std::size_t stride(std::size_t count, std::size_t most) {
    return count <= most ? 1 : (count + most - 1) / most;
}

/// Larger principal membrane stress of warp, weft, shear.
inline double principal(const double* s) {
    return 0.5 * (s[0] + s[1]) + std::hypot(0.5 * (s[0] - s[1]), s[2]);
}

inline Picture read_picture(const io::Hdf5Reader& file, const std::string& at) {
    Picture picture;
    picture.x = file.read<double>(at + "coordinates");
    picture.pressure = file.read<double>(at + "shell_pressure");
    if (file.has(at + "shell_contact_pressure"))
        picture.contact = file.read<double>(at + "shell_contact_pressure");
    const Lines stress = file.read<double>(at + "shell_stress");
    for (std::size_t k = 0; k + 2 < stress.size(); k += 3)
        picture.stress.push_back(principal(&stress[k]));
    if (!file.has(at + "particles")) return picture;
    // by id, so that a particle that is shown once is always shown
    const auto id = file.read<std::int64_t>(at + "particles/id");
    const auto species = file.read<std::int32_t>(at + "particles/species");
    const Lines x = file.read<double>(at + "particles/position");
    const Lines v = file.read<double>(at + "particles/velocity");
    const Lines T = file.has(at + "particles/temperature")
                        ? file.read<double>(at + "particles/temperature")
                        : Lines();
    const auto every = static_cast<std::int64_t>(stride(id.size(), MOST_PARTICLES));
    for (std::size_t p = 0; p < id.size(); ++p) {
        if (id[p] % every != 0) continue;
        picture.species.push_back(species[p]);
        picture.speed.push_back(std::hypot(v[3 * p], v[3 * p + 1], v[3 * p + 2]));
        if (!T.empty()) picture.temperature.push_back(T[p]);
        picture.particles.insert(picture.particles.end(), &x[3 * p], &x[3 * p] + 3);
    }
    return picture;
}

/// What the numbers of all frames lie between.
struct PictureRanges {
    std::array<Range, 3> box;
    Range pressure, stress, contact, speed, temperature;

    void take(const Picture& picture) {
        measure(picture.x);
        measure(picture.particles);
        for (const double value : picture.pressure) pressure.take(value);
        for (const double value : picture.stress) stress.take(value);
        for (const double value : picture.contact) contact.take(value);
        for (const double value : picture.speed) speed.take(value);
        for (const double value : picture.temperature) temperature.take(value);
    }
    void measure(const Lines& x) {
        for (std::size_t k = 0; k < x.size(); ++k) box[k % 3].take(x[k]);
    }
    /// Places in 16 bits of the box.
    [[nodiscard]] std::vector<std::uint16_t> quantised(const Lines& x) const {
        std::vector<std::uint16_t> out(x.size());
        for (std::size_t k = 0; k < x.size(); ++k) out[k] = box[k % 3].in_16_bits(x[k]);
        return out;
    }
};

/// In 8 bits of their range.
inline std::vector<std::uint8_t> in_bytes(const Lines& values, const Range& range) {
    std::vector<std::uint8_t> out;
    for (const double value : values) out.push_back(range.in_8_bits(value));
    return out;
}

}  // namespace corpuscle::report
