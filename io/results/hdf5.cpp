// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/hdf5.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <utility>

#include "io/results/hdf5_walk.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// The sentence of HDF5's innermost complaint; the system's own words where it has them.
std::string complaint() {
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
hid_t type_of() {
    if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
}

/// Variable length UTF-8: what Python reads as str.
Id text_type() {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return {type, H5Tclose};
}

Id make_groups_on_the_way() {
    const hid_t list = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(list, 1);
    return {list, H5Pclose};
}

/// How files are opened.
///
/// Without file locks: a file being written has a name that nobody else knows, a file being read is
/// finished, and network file systems often have no locks to give. Without sieve and cached chunks:
/// a write that fails fails at once. In the layout of HDF5 1.10, whose metadata have checksums.
/// Without clean-up at exit: see ~Hdf5Writer.
Id access() {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // complaints are thrown, not printed
    const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_file_locking(list, /*use=*/0, /*ignore_when_disabled=*/1);
    H5Pset_sieve_buf_size(list, 0);
    H5Pset_cache(list, 0, /*chunks=*/0, /*bytes=*/0, 0.75);
    H5Pset_libver_bounds(list, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    return {list, H5Pclose};
}

std::uint64_t count(const Shape& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

Shape shape_of(hid_t set) {
    const Id space(H5Dget_space(set), H5Sclose);
    std::vector<hsize_t> size(std::max(0, H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    return {size.begin(), size.end()};
}

Id space_of(const Shape& shape) {
    const std::vector<hsize_t> size(shape.begin(), shape.end());
    const int rank = static_cast<int>(size.size());
    return {rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, size.data(), nullptr),
            H5Sclose};
}

/// Every dataset carries checksums: as a chunk (several, beyond the largest that HDF5 allows), or
/// being one number among the metadata, which have theirs.
Id creation_of(const Shape& shape, std::size_t element, Packing packing) {
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

Hdf5Writer::Hdf5Writer(std::filesystem::path file) : file_(std::move(file)), id_(-1) {
    id_ = checked(H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access()), "create", file_);
}

/// A file that could not be written to its end is abandoned: HDF5 1.10 does not survive closing a
/// file on a full disk. It stays open, empty and nameless, until the program ends.
Hdf5Writer::~Hdf5Writer() {
    if (id_ < 0) return;
    std::error_code ignored;
    std::filesystem::resize_file(file_, 0, ignored);
    std::filesystem::remove(file_, ignored);
}

void Hdf5Writer::close() {
    checked(H5Fflush(id_, H5F_SCOPE_LOCAL), "write", file_);
    checked(H5Fclose(std::exchange(id_, -1)), "write", file_);
}

void Hdf5Writer::group(const std::string& path) {
    const Id on_the_way = make_groups_on_the_way();
    const hid_t group = H5Gcreate2(id_, path.c_str(), on_the_way, H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(checked(group, "write", file_, path));
}

template <class T>
void Hdf5Writer::dataset(const std::string& path, std::span<const T> values, const Shape& shape,
                         const Caption& caption, Packing packing) {
    assert(values.size() == count(shape) && "a dataset's shape holds its values");
    const Id space = space_of(shape);
    const Id creation = creation_of(shape, sizeof(T), packing);
    const Id on_the_way = make_groups_on_the_way();
    const Id set(checked(H5Dcreate2(id_, path.c_str(), type_of<T>(), space, on_the_way, creation,
                                    H5P_DEFAULT),
                         "write", file_, path),
                 H5Dclose);
    checked(H5Dwrite(set, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write",
            file_, path);
    attribute(path, "unit", caption.unit);
    attribute(path, "description", caption.description);
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name,
                           std::string_view text) {
    const Id type = text_type();
    const Id space = space_of({});
    const Id made(checked(H5Acreate_by_name(id_, path.c_str(), name.c_str(), type, space,
                                            H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                          "write", file_, path),
                  H5Aclose);
    const std::string ended(text);
    const char* value = ended.c_str();
    checked(H5Awrite(made, type, &value), "write", file_, path);
}

template <class T>
requires std::is_arithmetic_v<T>
void Hdf5Writer::attribute(const std::string& path, const std::string& name, T number) {
    const Id space = space_of({});
    const Id made(checked(H5Acreate_by_name(id_, path.c_str(), name.c_str(), type_of<T>(), space,
                                            H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                          "write", file_, path),
                  H5Aclose);
    checked(H5Awrite(made, type_of<T>(), &number), "write", file_, path);
}

void Hdf5Writer::link(const std::string& path, const std::string& other_file) {
    const Id on_the_way = make_groups_on_the_way();
    checked(H5Lcreate_external(other_file.c_str(), "/", id_, path.c_str(), on_the_way, H5P_DEFAULT),
            "write", file_, path);
}

void Hdf5Writer::copy(const std::string& path, const std::filesystem::path& other_file) {
    const Id other(
        checked(H5Fopen(other_file.c_str(), H5F_ACC_RDONLY, access()), "read", other_file),
        H5Fclose);
    const Id on_the_way = make_groups_on_the_way();
    checked(H5Ocopy(other, "/", id_, path.c_str(), H5P_DEFAULT, on_the_way), "write", file_, path);
}

void Hdf5Writer::take_over(const std::filesystem::path& other_file, const std::string& path) {
    const Hdf5Reader from(other_file, Hdf5Reader::Origin::OWN);
    const Id other(
        checked(H5Fopen(other_file.c_str(), H5F_ACC_RDONLY, access()), "read", other_file),
        H5Fclose);
    const Id on_the_way = make_groups_on_the_way();
    for (const std::string& name : from.names(path))
        checked(H5Ocopy(other, (path + "/" + name).c_str(), id_, ("/" + name).c_str(), H5P_DEFAULT,
                        on_the_way),
                "write", file_, name);
}

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

#define CORPUSCLE_ELEMENT(T)                                                                \
    template void Hdf5Writer::dataset(const std::string&, std::span<const T>, const Shape&, \
                                      const Caption&, Packing);                             \
    template void Hdf5Writer::attribute(const std::string&, const std::string&, T);         \
    template std::vector<T> Hdf5Reader::read(const std::string&) const;                     \
    template T Hdf5Reader::number(const std::string&, const std::string&) const;
CORPUSCLE_ELEMENT(float)
CORPUSCLE_ELEMENT(double)
CORPUSCLE_ELEMENT(std::uint8_t)
CORPUSCLE_ELEMENT(std::int32_t)
CORPUSCLE_ELEMENT(std::int64_t)
CORPUSCLE_ELEMENT(std::uint64_t)
#undef CORPUSCLE_ELEMENT

}  // namespace corpuscle::io
