// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/check_costs.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <numeric>
#include <string>

#include "gas/particles.hpp"
#include "io/results/hdf5.hpp"
#include "solver/base/simd.hpp"
#include "solver/stops.hpp"

namespace corpuscle::benchmark {
namespace {

constexpr std::size_t BLOCK = 32;  ///< particles, as of flight (gas/flight/safe_distances.hpp)
constexpr int TURNS = 5;           ///< with and without
constexpr int PASSES = 8;          ///< over a block while it is in the nearest cache

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The compiler knows nothing of memory from here on, and must have written all of it.
void forget() {
    asm volatile("" ::: "memory");
}

/// Least of some turns each: what other programs take from a turn counts for nothing.        [s]
double extra(const std::function<void()>& with, const std::function<void()>& without) {
    const auto time = [](const std::function<void()>& what) {
        const double begin = thread_seconds();
        what();
        return thread_seconds() - begin;
    };
    double least_with = INF, least_without = INF;
    for (int turn = 0; turn < TURNS; ++turn) {
        least_with = std::min(least_with, time(with));
        least_without = std::min(least_without, time(without));
    }
    return least_with - least_without;
}

/// As SafeDistances::displacement_bounds, of whole fours.
template <bool CHECKED>
[[gnu::noipa]] void find_bounds(const double* v, std::size_t count, double factor, float* out) {
    for (std::size_t i = 0; i + FOUR <= count; i += FOUR) {
        const auto size = [&](int k) {
            const Four a = load_four(v + 3 * i + FOUR * static_cast<std::size_t>(k));
            return a < 0.0 ? -a : a;
        };
        const auto [x, y, z] = columns(size(0), size(1), size(2));
        const Four xy = x > y ? x : y;
        Four most = factor * (xy > z ? xy : z);
        if constexpr (CHECKED) most = most + 0.0 * (x + y + z);
        for (int l = 0; l < static_cast<int>(FOUR); ++l)
            out[i + static_cast<std::size_t>(l)] = static_cast<float>(most[l]);
    }
}

/// As fly_one() begins: both ends of a path.
template <bool CHECKED>
[[gnu::noipa]] std::size_t find_paths(const Vec3* x, const Vec3* v, std::size_t count, double dt,
                                      std::array<Vec3, 2>* out) {
    std::size_t broken = 0;
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = {x[i], x[i] + dt * v[i]};
        if constexpr (CHECKED)
            if (!(out[i][1].squaredNorm() < INF)) ++broken;
    }
    return broken;
}

/// As Membranes::gather_forces().
template <bool CHECKED>
[[gnu::noipa]] double gather(std::span<const std::size_t> places,
                             std::span<const std::size_t> starts, const Points& from, Points& f) {
    Vec3 total = Vec3::Zero();
    for (std::size_t n = 0; n + 1 < starts.size(); ++n) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = starts[n]; k < starts[n + 1]; ++k) sum += from[places[k]];
        f[n] += sum;
        if constexpr (CHECKED) total += sum;
    }
    return total.sum();
}

template <bool CHECKED>
void all_bounds(const gas::Particles& gas) {
    std::array<float, BLOCK> out;
    for (std::size_t i = 0; i + BLOCK <= gas.size(); i += BLOCK)
        for (int pass = 0; pass < PASSES; ++pass) {
            find_bounds<CHECKED>(gas.v[i].data(), BLOCK, 1e-6, out.data());
            forget();
        }
}

template <bool CHECKED>
void all_starts(const gas::Particles& gas) {
    std::array<std::array<Vec3, 2>, BLOCK> out;
    for (std::size_t i = 0; i + BLOCK <= gas.size(); i += BLOCK)
        for (int pass = 0; pass < PASSES; ++pass) {
            find_paths<CHECKED>(&gas.x[i], &gas.v[i], BLOCK, 1e-6, out.data());
            forget();
        }
}

void add_sizes(const io::Hdf5Reader& file, const std::string& path,
               std::vector<std::size_t>& sizes) {
    if (file.is_group(path)) {
        for (const std::string& name : file.names(path)) add_sizes(file, path + "/" + name, sizes);
        return;
    }
    const io::Shape shape = file.shape(path);
    sizes.push_back(
        std::accumulate(shape.begin(), shape.end(), file.element_size(path), std::multiplies<>()));
}

/// All datasets into a file that is in memory alone.
void write_all(std::span<const std::size_t> sizes, std::span<const std::uint8_t> bytes,
               bool has_checksum) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access, std::size_t{1} << 26, 0);
    const hid_t file = H5Fcreate("none", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const hsize_t size = sizes[i];
        if (size == 0) continue;
        const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(list, 1, &size);
        if (has_checksum) H5Pset_fletcher32(list);
        const hid_t space = H5Screate_simple(1, &size, nullptr);
        const hid_t data = H5Dcreate2(file, std::to_string(i).c_str(), H5T_NATIVE_UINT8, space,
                                      H5P_DEFAULT, list, H5P_DEFAULT);
        H5Dwrite(data, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
        H5Dclose(data);
        H5Sclose(space);
        H5Pclose(list);
    }
    H5Fclose(file);
    H5Pclose(access);
}

}  // namespace

double thread_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double process_seconds() {
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

FiniteCosts::FiniteCosts(const SceneState& scene) {
    std::vector<std::vector<std::size_t>> corners(scene.nodes.size());
    std::size_t corner = 0;
    for (const Shell& shell : scene.model.shells)
        for (std::size_t k = 0; k < 4; ++k, ++corner)
            if (k < 3 || shell.nodes[3] != shell.nodes[2])
                corners[shell.nodes[k]].push_back(corner);
    starts_.push_back(0);
    for (const auto& of_node : corners) {
        places_.insert(places_.end(), of_node.begin(), of_node.end());
        starts_.push_back(places_.size());
    }
    corner_force_.assign(corner, Vec3(1.0, 2.0, 3.0));
    force_.assign(scene.nodes.size(), Vec3::Zero());
}

void FiniteCosts::measure(const SceneState& state) {
    for (const gas::BagGas& bag : state.airbags.particle) {
        if (bag.is_uniform()) continue;
        const gas::Particles& gas = bag.particles();
        bounds += extra([&] { all_bounds<true>(gas); }, [&] { all_bounds<false>(gas); }) / PASSES;
        starts += extra([&] { all_starts<true>(gas); }, [&] { all_starts<false>(gas); }) / PASSES;
    }
    volatile double kept = 0.0;
    if (state.cloth.membranes)
        nodes += extra([&] { kept = gather<true>(places_, starts_, corner_force_, force_); },
                       [&] { kept = gather<false>(places_, starts_, corner_force_, force_); });
    stops += extra(
        [&] {
            check_finite(state);
            check_accounts(state);
        },
        forget);
}

double cost_of_fletcher(std::span<const std::size_t> sizes) {
    const std::size_t most = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
    std::vector<std::uint8_t> bytes(most);
    for (std::size_t i = 0; i < most; ++i) bytes[i] = static_cast<std::uint8_t>(i * 37 + i / 251);
    write_all(sizes, bytes, true);  // libhdf5 and its memory are ready
    return extra([&] { write_all(sizes, bytes, true); }, [&] { write_all(sizes, bytes, false); });
}

std::vector<std::size_t> dataset_sizes(const std::filesystem::path& results,
                                       const std::string& group) {
    const io::Hdf5Reader file(results, io::Hdf5Reader::Origin::OWN);
    std::vector<std::size_t> sizes;
    if (file.has(group)) add_sizes(file, group, sizes);
    return sizes;
}

}  // namespace corpuscle::benchmark
