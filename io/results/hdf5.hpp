// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// @file
/// The little of HDF5 that results need, its failures thrown as SystemError. <hdf5.h> stays out of
/// sight. Every dataset carries Fletcher's checksum (32 bits), and so do the metadata: what has
/// changed on the disk since is an error, not another number.
///
/// Elements T are float, double, std::uint8_t, std::int32_t, std::int64_t or std::uint64_t.

namespace corpuscle::io {

using Shape = std::vector<std::uint64_t>;  ///< rows, columns, ...; empty: one number

/// What a dataset says of itself, in the attributes `unit` and `description`.
struct Caption {
    std::string unit;         ///< "m/s"; "-" of numbers without one
    std::string description;  ///< one sentence
};

/// How a dataset lies in the file.
enum class Packing {
    PLAIN,   ///< as it is
    DEFLATE  ///< level 1 after byte shuffle
};

/// A file that is being written, from start to end, once.
class Hdf5Writer {
public:
    /// Creates or empties `file`.
    explicit Hdf5Writer(std::filesystem::path file);
    ~Hdf5Writer();
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    /// Groups on the way to `path` are made as needed.
    void group(const std::string& path);

    /// A new dataset at `path`; groups on the way are made as needed.
    /// @param values  row by row, as many as `shape` says
    /// @throws SystemError  where it cannot be written, or is there already
    template <class T>
    void dataset(const std::string& path, std::span<const T> values, const Shape& shape,
                 const Caption& caption, Packing packing = Packing::PLAIN);

    /// Gives a group or dataset that is there an attribute that it does not have: UTF-8 text.
    /// @throws SystemError  where it cannot be written
    void attribute(const std::string& path, const std::string& name, std::string_view text);
    /// The same, one number.
    template <class T>
    requires std::is_arithmetic_v<T>
    void attribute(const std::string& path, const std::string& name, T number);

    /// `path` here stands for all of another file, named relative to this one.
    void link(const std::string& path, const std::string& other_file);
    /// `path` here becomes a copy of all of another file.
    void copy(const std::string& path, const std::filesystem::path& other_file);
    /// All that lies in a group of another file becomes this one's.
    void take_over(const std::filesystem::path& other_file, const std::string& path);

    /// Everything is in the file, or this throws. A file that was not closed is removed.
    void close();

private:
    std::filesystem::path file_;
    std::int64_t id_;
};

/// A file that is read, at any place, in any order. What is asked for must be there, or it throws
/// SystemError.
class Hdf5Reader {
public:
    /// Whose file it is: libhdf5 does not survive all that can happen to one on a disk, so what this
    /// run has not written is first walked over by a process of its own.
    enum class Origin {
        UNKNOWN,  ///< somebody's: walked over first
        OWN       ///< this run's: opened at once
    };
    /// @throws SystemError also where libhdf5 would crash
    explicit Hdf5Reader(std::filesystem::path file, Origin origin = Origin::UNKNOWN);
    ~Hdf5Reader();
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;

    /// Whether there is a group or dataset; false also where a group on the way is missing.
    [[nodiscard]] bool has(const std::string& path) const;
    /// Names in a group, in alphabetical order.
    [[nodiscard]] std::vector<std::string> names(const std::string& path) const;
    /// Whether it is a group; else it is a dataset.
    [[nodiscard]] bool is_group(const std::string& path) const;
    /// Whether it stands for another file's, as Hdf5Writer::link() makes it.
    [[nodiscard]] bool is_link(const std::string& path) const;
    /// Of a dataset.
    [[nodiscard]] Shape shape(const std::string& path) const;
    /// Bytes an element takes in the file.
    [[nodiscard]] std::size_t element_size(const std::string& path) const;

    /// All of a dataset, row by row, as T.
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& path) const;

    /// Names of the attributes of a group or dataset, in alphabetical order.
    [[nodiscard]] std::vector<std::string> attributes(const std::string& path) const;
    /// Whether a group or dataset has an attribute of that name.
    [[nodiscard]] bool has_attribute(const std::string& path, const std::string& attribute) const;
    /// An attribute that is text.
    [[nodiscard]] std::string text(const std::string& path, const std::string& attribute) const;
    /// An attribute that is one number, as T.
    template <class T>
    [[nodiscard]] T number(const std::string& path, const std::string& attribute) const;

private:
    std::filesystem::path file_;
    std::int64_t id_;
};

}  // namespace corpuscle::io
