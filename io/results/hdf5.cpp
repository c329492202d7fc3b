// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/hdf5.hpp"

#include <cassert>
#include <utility>

#include "io/results/hdf5_id.hpp"

namespace corpuscle::io {

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

#define CORPUSCLE_ELEMENT(T)                                                                \
    template void Hdf5Writer::dataset(const std::string&, std::span<const T>, const Shape&, \
                                      const Caption&, Packing);                             \
    template void Hdf5Writer::attribute(const std::string&, const std::string&, T);
CORPUSCLE_ELEMENT(float)
CORPUSCLE_ELEMENT(double)
CORPUSCLE_ELEMENT(std::uint8_t)
CORPUSCLE_ELEMENT(std::int32_t)
CORPUSCLE_ELEMENT(std::int64_t)
CORPUSCLE_ELEMENT(std::uint64_t)
#undef CORPUSCLE_ELEMENT

}  // namespace corpuscle::io
