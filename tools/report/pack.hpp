// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers made small enough for a page.
namespace corpuscle::report {

/// Maps [low, high] to 0 .. 65535 or 0 .. 255; a range of one value maps to 0.
struct Range {
    double low = 0.0, high = 0.0;
    bool is_empty = true;

    void take(double value);
    [[nodiscard]] std::uint16_t in_16_bits(double value) const;
    [[nodiscard]] std::uint8_t in_8_bits(double value) const;
};

/// Sections of bytes, one after the other, each from a multiple of 4 on.
class Blob {
public:
    /// Appends a section; returns where it begins.
    template <class T>
    std::size_t add(const std::vector<T>& values) {
        return add_bytes({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::size_t add_bytes(std::string_view bytes);
    std::string bytes_;
};

/// zlib's format (RFC 1950), as browsers' DecompressionStream("deflate") reads it.
[[nodiscard]] std::string deflated(std::string_view bytes);
[[nodiscard]] std::string base64(std::string_view bytes);
/// The bytes behind base64 text without line breaks.
[[nodiscard]] std::string from_base64(std::string_view text);

/// values - before, modulo 65536: what changes little packs well.
[[nodiscard]] std::vector<std::uint16_t> change(const std::vector<std::uint16_t>& values,
                                                const std::vector<std::uint16_t>& before);

}  // namespace corpuscle::report
