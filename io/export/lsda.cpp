// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/lsda.hpp"

#include <bit>
#include <cassert>
#include <cstring>

namespace corpuscle::io {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

enum Command : std::uint8_t {
    CD = 2,
    DATA = 3,
    VARIABLE = 4,
    BEGIN_SYMBOL_TABLE = 5,
    END_SYMBOL_TABLE = 6,
    SYMBOL_TABLE_OFFSET = 7
};

constexpr std::size_t HEADER = 8, LENGTH = 8, COMMAND = 1, OFFSET = 8, TYPE = 1;

template <class T>
void put(std::string& to, const T& value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    to.append(bytes, sizeof(T));
}

/// A record's head; `rest` bytes follow.
void head(std::string& to, Command command, std::uint64_t rest) {
    put(to, std::uint64_t{LENGTH + COMMAND + rest});
    put(to, command);
}

template <class T>
std::string_view bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

LsdaWriter::LsdaWriter() : file_({8, 8, 8, 1, 1, 1, 0, 0}) {
    head(file_, SYMBOL_TABLE_OFFSET, OFFSET);
    put(file_, std::uint64_t{0});  // finish() knows
}

void LsdaWriter::folder(const std::string& path) {
    folder_ = path;
    head(file_, CD, path.size());
    file_ += path;
}

void LsdaWriter::data(std::string_view name, Type type, std::uint64_t count,
                      std::string_view bytes) {
    assert(name.size() < 256 && "a name's length is one byte");
    variables_.push_back({folder_, std::string(name), type, file_.size(), count});
    head(file_, DATA, TYPE + 1 + name.size() + bytes.size());
    put(file_, type);
    put(file_, static_cast<std::uint8_t>(name.size()));
    file_ += name;
    file_ += bytes;
}

void LsdaWriter::write(std::string_view name, std::span<const double> values) {
    data(name, Type::FLOAT64, values.size(), bytes_of(values));
}

void LsdaWriter::write(std::string_view name, std::span<const std::int32_t> values) {
    data(name, Type::INT32, values.size(), bytes_of(values));
}

void LsdaWriter::write(std::string_view name, std::string_view text) {
    data(name, Type::TEXT, text.size(), text);
}

std::string LsdaWriter::finish() {
    std::string table;
    const std::string* at = nullptr;
    for (const Variable& v : variables_) {
        if (at == nullptr || *at != v.folder) {
            head(table, CD, v.folder.size());
            table += v.folder;
            at = &v.folder;
        }
        head(table, VARIABLE, v.name.size() + TYPE + OFFSET + LENGTH);
        table += v.name;
        put(table, v.type);
        put(table, v.offset);
        put(table, v.count);
    }
    head(table, END_SYMBOL_TABLE, OFFSET);
    put(table, std::uint64_t{0});
    const std::uint64_t begins = file_.size();
    std::memcpy(file_.data() + HEADER + LENGTH + COMMAND, &begins, sizeof(begins));
    head(file_, BEGIN_SYMBOL_TABLE, table.size());
    return std::move(file_) + table;
}

}  // namespace corpuscle::io
