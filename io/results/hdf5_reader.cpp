// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "io/results/hdf5.hpp"
#include "io/results/hdf5_id.hpp"
#include "io/results/hdf5_walk.hpp"

namespace corpuscle::io {
namespace {

/// Nobody asks for memory in vain: what a dataset says it holds must fit what the file has of it.
/// @throws SystemError if it does not
void expect_true(hid_t set, const Shape& shape, const std::filesystem::path& file,
                 const std::string& path) {
    constexpr std::uint64_t MOST_PACKED = 1100;  // deflate makes 1 byte of 1032 at best
    const Id type(H5Dget_type(set), H5Tclose);
    const Id creation(H5Dget_create_plist(set), H5Pclose);
    const Id of(H5Iget_file_id(set), H5Fclose);
    hsize_t in_file = 0;
    const hsize_t stored = H5Dget_storage_size(set);
    H5Fget_filesize(of, &in_file);
    bool is_true = stored <= in_file;
    const std::uint64_t most = (H5Pget_nfilters(creation) > 0 ? MOST_PACKED : 1) * stored;
    const auto expect_to_hold = [&](const Shape& lengths) {
        std::uint64_t size = H5Tget_size(type);
        for (const std::uint64_t length : lengths)
            is_true = is_true && !__builtin_mul_overflow(size, length, &size);
        is_true = is_true && size <= most;
    };
    if (H5Pget_layout(creation) == H5D_CHUNKED) {
        std::vector<hsize_t> lengths(shape.size());
        H5Pget_chunk(creation, static_cast<int>(lengths.size()), lengths.data());
        expect_to_hold({lengths.begin(), lengths.end()});
    }
    expect_to_hold(shape);
    if (!is_true)
        throw SystemError(
            fmt::format("cannot read {}, {}: it is damaged: it says that it holds {} numbers, of "
                        "which {} bytes are there",
                        file.string(), path, fmt::join(shape, " x "), stored));
}

}  // namespace

Hdf5Reader::Hdf5Reader(std::filesystem::path file, Origin origin)
    : file_(std::move(file)), id_(-1) {
    if (origin == Origin::UNKNOWN) expect_survivable(file_);
    id_ = checked(H5Fopen(file_.c_str(), H5F_ACC_RDONLY, access()), "read", file_);
}

Hdf5Reader::~Hdf5Reader() {
    H5Fclose(id_);
}

bool Hdf5Reader::has(const std::string& path) const {
    return H5Oexists_by_name(id_, path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::names(const std::string& path) const {
    std::vector<std::string> found;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
        static_cast<std::vector<std::string>*>(to)->emplace_back(name);
        return 0;
    };
    // In the order of the file: for another one HDF5 1.10 makes a table, half filled where the file
    // is damaged, and gives all of it back
    checked(H5Literate_by_name(id_, path.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep,
                               &found, H5P_DEFAULT),
            "read", file_, path);
    std::sort(found.begin(), found.end());
    return found;
}

bool Hdf5Reader::is_group(const std::string& path) const {
    const Id object(checked(H5Oopen(id_, path.c_str(), H5P_DEFAULT), "read", file_, path),
                    H5Oclose);
    return H5Iget_type(object) == H5I_GROUP;
}

bool Hdf5Reader::is_link(const std::string& path) const {
    H5L_info_t link{};
    checked(H5Lget_info(id_, path.c_str(), &link, H5P_DEFAULT), "read", file_, path);
    return link.type == H5L_TYPE_EXTERNAL;
}

Shape Hdf5Reader::shape(const std::string& path) const {
    const Id set(checked(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), "read", file_, path), H5Dclose);
    return shape_of(set);
}

std::size_t Hdf5Reader::element_size(const std::string& path) const {
    const Id set(checked(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), "read", file_, path), H5Dclose);
    const Id type(H5Dget_type(set), H5Tclose);
    return H5Tget_size(type);
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& path) const {
    const Id set(checked(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), "read", file_, path), H5Dclose);
    const Shape shape = shape_of(set);
    expect_true(set, shape, file_, path);
    std::vector<T> values(count(shape));
    checked(H5Dread(set, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", file_,
            path);
    return values;
}

std::vector<std::string> Hdf5Reader::attributes(const std::string& path) const {
    std::vector<std::string> found;
    const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
        static_cast<std::vector<std::string>*>(to)->emplace_back(name);
        return 0;
    };
    checked(H5Aiterate_by_name(id_, path.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep,
                               &found, H5P_DEFAULT),
            "read", file_, path);
    std::sort(found.begin(), found.end());
    return found;
}

bool Hdf5Reader::has_attribute(const std::string& path, const std::string& attribute) const {
    return H5Aexists_by_name(id_, path.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

std::string Hdf5Reader::text(const std::string& path, const std::string& attribute) const {
    const Id found(
        checked(H5Aopen_by_name(id_, path.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                "read", file_, path + " attribute " + attribute),
        H5Aclose);
    const Id type = text_type();
    char* value = nullptr;
    checked(H5Aread(found, type, &value), "read", file_, path);
    std::string result(value == nullptr ? "" : value);
    H5free_memory(value);
    return result;
}

template <class T>
T Hdf5Reader::number(const std::string& path, const std::string& attribute) const {
    const Id found(
        checked(H5Aopen_by_name(id_, path.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                "read", file_, path + " attribute " + attribute),
        H5Aclose);
    T value{};
    checked(H5Aread(found, type_of<T>(), &value), "read", file_, path);
    return value;
}

#define CORPUSCLE_ELEMENT(T)                                            \
    template std::vector<T> Hdf5Reader::read(const std::string&) const; \
    template T Hdf5Reader::number(const std::string&, const std::string&) const;
CORPUSCLE_ELEMENT(float)
CORPUSCLE_ELEMENT(double)
CORPUSCLE_ELEMENT(std::uint8_t)
CORPUSCLE_ELEMENT(std::int32_t)
CORPUSCLE_ELEMENT(std::int64_t)
CORPUSCLE_ELEMENT(std::uint64_t)
#undef CORPUSCLE_ELEMENT

}  // namespace corpuscle::io
