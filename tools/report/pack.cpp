// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/report/pack.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle::report {
namespace {

double share(const Range& range, double value) {
    const double width = range.high - range.low;
    return width > 0.0 ? std::clamp((value - range.low) / width, 0.0, 1.0) : 0.0;
}

}  // namespace

void Range::take(double value) {
    if (!std::isfinite(value)) return;
    low = is_empty ? value : std::min(low, value);
    high = is_empty ? value : std::max(high, value);
    is_empty = false;
}

std::uint16_t Range::in_16_bits(double value) const {
    return static_cast<std::uint16_t>(std::lround(65535.0 * share(*this, value)));
}

std::uint8_t Range::in_8_bits(double value) const {
    return static_cast<std::uint8_t>(std::lround(255.0 * share(*this, value)));
}

std::size_t Blob::add_bytes(std::string_view bytes) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    const std::size_t begin = bytes_.size();
    bytes_ += bytes;
    return begin;
}

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6) != Z_OK)
        throw SystemError("cannot compress the page's data");
    out.resize(size);
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view LETTERS =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8U |
                    (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            out += k + i <= bytes.size() ? LETTERS[three >> (18U - 6U * i) & 63U] : '=';
    }
    return out;
}

std::string from_base64(std::string_view text) {
    const auto digit = [](char c) -> std::uint32_t {
        if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
        if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 26);
        if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0' + 52);
        return c == '+' ? 62U : 63U;
    };
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string out;
    std::uint32_t bits = 0, count = 0;
    for (const char c : text) {
        bits = bits << 6U | digit(c);
        if ((count += 6) < 8) continue;
        count -= 8;
        out += static_cast<char>(bits >> count & 255U);
    }
    return out;
}

std::vector<std::uint16_t> change(const std::vector<std::uint16_t>& values,
                                  const std::vector<std::uint16_t>& before) {
    std::vector<std::uint16_t> out(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        out[k] = static_cast<std::uint16_t>(values[k] - (before.empty() ? 0 : before[k]));
    return out;
}

}  // namespace corpuscle::report
