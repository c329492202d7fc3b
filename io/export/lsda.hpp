// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corpuscle::io {

/// Livermore Software's data archive, the file that binout is: records of length and command.
///
///     header: 8 8 8 1 1 1 0 0   sizes of header, length, offset, command, type; little endian
///     SYMBOLTABLEOFFSET (7)     where the table begins
///     CD (2)                    a folder
///     DATA (3)                  type, length of the name, name, values
///     BEGINSYMBOLTABLE (5)      then CD, and for each DATA a VARIABLE
///     VARIABLE (4)              name, type, offset of its DATA, count
///     ENDSYMBOLTABLE (6)        offset of the next table, 0
///
/// A record's length counts itself and the command; that of BEGINSYMBOLTABLE all of the table.
class LsdaWriter {
public:
    LsdaWriter();

    /// What follows is in this folder: "/glstat/d000001".
    void folder(const std::string& path);
    void write(std::string_view name, std::span<const double> values);
    void write(std::string_view name, std::span<const std::int32_t> values);
    void write(std::string_view name, std::string_view text);
    void write(std::string_view name, double value) { write(name, std::span(&value, 1)); }
    void write(std::string_view name, std::int32_t value) { write(name, std::span(&value, 1)); }

    /// The whole file. Nothing may be written after it.
    [[nodiscard]] std::string finish();

private:
    enum class Type : std::uint8_t { TEXT = 1, INT32 = 3, FLOAT64 = 10 };
    struct Variable {
        std::string folder, name;
        Type type;
        std::uint64_t offset, count;
    };
    void data(std::string_view name, Type type, std::uint64_t count, std::string_view bytes);

    std::string file_, folder_;
    std::vector<Variable> variables_;
};

}  // namespace corpuscle::io
