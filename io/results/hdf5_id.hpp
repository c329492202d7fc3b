// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "solver/base/error.hpp"

/// What reading and writing of HDF5 have in common.
namespace corpuscle::io {

/// The sentence of HDF5's innermost complaint; the system's own words where it has them.
inline std::string complaint() {
    std::string innermost = "unknown HDF5 error";
    const auto keep = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
        if (error->desc != nullptr) *static_cast<std::string*>(to) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep, &innermost);
    constexpr std::string_view MARK = "error message = '";
    const std::size_t begin = innermost.find(MARK);
    if (begin == std::string::npos) return innermost;
    const std::size_t end = innermost.find('\'', begin + MARK.size());
    return innermost.substr(begin + MARK.size(), end - begin - MARK.size());
}

/// Passes a result of HDF5 on, unless it is negative.
template <class Result>
Result checked(Result result, std::string_view verb, const std::filesystem::path& file,
               const std::string& path = {}) {
    if (result < 0)
        throw SystemError(fmt::format("cannot {} {}{}{}: {}", verb, file.string(),
                                      path.empty() ? "" : ", ", path, complaint()));
    return result;
}

/// An HDF5 identifier that is given back at the end of its scope.
class Id {
public:
    Id(hid_t id, herr_t (*give_back)(hid_t)) : id_(id), give_back_(give_back) {}
    ~Id() { give_back_(id_); }
    Id(const Id&) = delete;
    Id& operator=(const Id&) = delete;
    operator hid_t() const { return id_; }  // NOLINT: stands for the identifier everywhere

private:
    hid_t id_;
    herr_t (*give_back_)(hid_t);
};

template <class T>
inline hid_t type_of() {
    if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
}

/// Variable length UTF-8: what Python reads as str.
inline Id text_type() {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return {type, H5Tclose};
}

inline Id make_groups_on_the_way() {
    const hid_t list = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(list, 1);
    return {list, H5Pclose};
}

/// No clean-up at exit: see ~Hdf5Writer. Before main(), for it counts only before the library's first
/// call, and H5F_ACC_TRUNC is one.
inline const herr_t NO_CLEAN_UP = H5dont_atexit();

/// How files are opened.
///
/// Without file locks: a file being written has a name that nobody else knows, a file being read is
/// finished, and network file systems often have no locks to give. Without sieve and cached chunks:
/// a write that fails fails at once. In the layout of HDF5 1.10, whose metadata have checksums.
inline Id access() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // complaints are thrown, not printed
    const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_file_locking(list, /*use=*/0, /*ignore_when_disabled=*/1);
    H5Pset_sieve_buf_size(list, 0);
    H5Pset_cache(list, 0, /*chunks=*/0, /*bytes=*/0, 0.75);
    H5Pset_libver_bounds(list, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    return {list, H5Pclose};
}

inline std::uint64_t count(const Shape& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

inline Shape shape_of(hid_t set) {
    const Id space(H5Dget_space(set), H5Sclose);
    std::vector<hsize_t> size(std::max(0, H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    return {size.begin(), size.end()};
}

inline Id space_of(const Shape& shape) {
    const std::vector<hsize_t> size(shape.begin(), shape.end());
    const int rank = static_cast<int>(size.size());
    return {rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, size.data(), nullptr),
            H5Sclose};
}

/// Every dataset carries checksums: as a chunk (several, beyond the largest that HDF5 allows), or
/// being one number among the metadata, which have theirs.
inline Id creation_of(const Shape& shape, std::size_t element, Packing packing) {
    constexpr std::uint64_t LARGEST = std::uint64_t{1} << 30;  // HDF5 allows four times that [byte]
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
    const std::uint64_t all = count(shape);
    if (shape.empty()) H5Pset_layout(list, H5D_COMPACT);
    if (all > 0 && !shape.empty()) {
        std::vector<hsize_t> chunk(shape.begin(), shape.end());
        chunk[0] = std::clamp<std::uint64_t>(LARGEST / (all / shape[0] * element), 1, shape[0]);
        H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data());
        if (packing == Packing::DEFLATE) {
            H5Pset_shuffle(list);
            H5Pset_deflate(list, 1);
        }
        H5Pset_fletcher32(list);
    }
    return {list, H5Pclose};
}

}  // namespace corpuscle::io
