// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"

/// @file
/// State as bytes, for checkpoints. A class lists its state once, for writing and reading:
///
///     template <class Archive>
///     void visit_state(Archive& archive) { archive(x_, v_, store_); }
///
/// Listed is what changes during a run and is not worked out anew from the rest in every step; what
/// a scene is built with (meshes, cards, tables) is not. Values come back bit by bit.

namespace corpuscle {

namespace archive_detail {
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// Of a type whose own bytes say where values lie, not what they are.
template <class T>
struct IsView : std::bool_constant<std::is_pointer_v<T> || std::is_member_pointer_v<T>> {};
template <class T, std::size_t N>
struct IsView<std::span<T, N>> : std::true_type {};
template <class T>
struct IsView<std::basic_string_view<T>> : std::true_type {};
template <class T>
struct IsView<std::reference_wrapper<T>> : std::true_type {};
template <class T, std::size_t N>
struct IsView<std::array<T, N>> : IsView<T> {};
template <class T, std::size_t N>
struct IsView<T[N]> : IsView<T> {};

/// Whose bytes are its value: neither a view nor the owner of memory.
template <class T>
concept Plain = std::is_trivially_destructible_v<T> && !IsView<T>::value;
}  // namespace archive_detail

/// Common to both ways. Way has raw(void*, bytes), which moves bytes, and count(std::size_t&), the
/// length of what follows. A value is visited by its own visit_state(); vectors and strings by
/// length and elements; optionals by a byte and the value; spans of bytes by length, which is the
/// reader's too, and the bytes that they show; all else as its bytes. Pointers and other views are
/// refused, except within structs, whose members nothing here sees.
template <class Way>
class ArchiveOf {
public:
    /// Writes or reads the values in turn, by reference either way.
    /// @throws SystemError  reading: bytes that end too early, a length that does not fit the scene
    template <class... T>
    void operator()(T&... values) {
        (visit(values), ...);
    }

private:
    Way& way() { return static_cast<Way&>(*this); }

    template <class T>
    void visit(T& value) {
        if constexpr (requires { value.visit_state(way()); }) {
            value.visit_state(way());
        } else if constexpr (archive_detail::IsVector<T>::value) {
            list(value);
        } else if constexpr (archive_detail::IsOptional<T>::value) {
            std::uint8_t is_there = value.has_value();
            way().raw(&is_there, 1);
            if constexpr (std::is_default_constructible_v<typename T::value_type>)
                if (is_there && !value) value.emplace();
            if (is_there && !value) throw SystemError("the checkpoint does not fit the scene");
            if (!is_there) value.reset();
            if (value) visit(*value);
        } else if constexpr (std::is_same_v<T, std::string>) {
            std::size_t size = value.size();
            way().count(size);
            value.resize(size);
            way().raw(value.data(), size);
        } else if constexpr (std::is_same_v<T, std::span<std::byte>>) {
            std::size_t size = value.size();
            way().count(size);
            if (size != value.size()) throw SystemError("the checkpoint does not fit the scene");
            way().raw(value.data(), size);
        } else {
            static_assert(archive_detail::Plain<T>, "this type needs a visit_state()");
            way().raw(&value, sizeof(T));
        }
    }
    template <class T>
    void list(std::vector<T>& values) {
        std::size_t size = values.size();
        way().count(size);
        if constexpr (std::is_default_constructible_v<T>)
            values.resize(size);
        else if (values.size() != size)
            throw SystemError("the checkpoint does not fit the scene");
        if constexpr (archive_detail::Plain<T> && !requires(T & v, Way & w) { v.visit_state(w); }) {
            way().raw(values.data(), size * sizeof(T));
        } else {
            for (T& value : values) visit(value);
        }
    }
};

/// Appends state to bytes.
class StateWriter : public ArchiveOf<StateWriter> {
public:
    /// @param expected  bytes that there is room for at once; more are taken all the same
    explicit StateWriter(std::size_t expected = 0) { bytes_.reserve(expected); }

    /// Written so far; valid until the next call.
    [[nodiscard]] const std::vector<char>& bytes() const { return bytes_; }
    /// The same by move; the writer is empty then.
    [[nodiscard]] std::vector<char> take() { return std::move(bytes_); }

    /// Appends `size` bytes as they lie in memory: of this machine's byte order.
    void raw(const void* from, std::size_t size) {
        const auto* begin = static_cast<const char*>(from);
        bytes_.insert(bytes_.end(), begin, begin + size);
    }
    /// Appends a length, 8 bytes.
    void count(std::size_t& size) { raw(&size, sizeof(size)); }

private:
    std::vector<char> bytes_;
};

/// Takes state from bytes, in the order in which it was written.
class StateReader : public ArchiveOf<StateReader> {
public:
    /// @param bytes  of a StateWriter, not copied: they outlive the reader
    explicit StateReader(std::span<const char> bytes) : rest_(bytes) {}

    /// Whether all was read: a checkpoint that fits the scene ends here.
    [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

    /// Copies the next `size` bytes.
    /// @throws SystemError where the bytes end too early
    void raw(void* to, std::size_t size) {
        if (size > rest_.size()) throw SystemError("the checkpoint ends too early");
        if (size > 0) std::memcpy(to, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }
    /// Takes a length.
    /// @throws SystemError  for one above 2^30 that the bytes left cannot hold
    void count(std::size_t& size) {
        raw(&size, sizeof(size));
        if (size > rest_.size() && size > (1U << 30))
            throw SystemError("the checkpoint does not fit the scene");
    }

private:
    std::span<const char> rest_;
};

}  // namespace corpuscle
