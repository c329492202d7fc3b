// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/checkpoint.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "io/system/atomic_file.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// First words of the file. The number changes whenever a class lists its state in another way.
constexpr std::string_view MAGIC = "corpuscle checkpoint 16\n";

std::filesystem::path file_in(const std::filesystem::path& folder) {
    return folder / "checkpoint";
}

}  // namespace

std::uint64_t checkpoint_checksum(std::span<const char> bytes) {
    constexpr std::uint64_t BASIS = 0xcbf29ce484222325U, PRIME = 0x100000001b3U;
    constexpr int TURN = 29;  // or a word's last bit would stay where it is
    std::uint64_t hash = BASIS;
    const auto take = [&hash](std::uint64_t word) { hash = std::rotl(hash ^ word, TURN) * PRIME; };
    const std::size_t rest = bytes.size() % sizeof(std::uint64_t), whole = bytes.size() - rest;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < whole; i += sizeof(word)) {
        std::memcpy(&word, bytes.data() + i, sizeof(word));
        take(word);
    }
    word = static_cast<std::uint64_t>(rest) << 56U;
    if (rest > 0) std::memcpy(&word, bytes.data() + whole, rest);
    take(word);
    return hash;
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
    StateWriter head;
    Checkpoint copy{checkpoint.scene, checkpoint.t, checkpoint.step, {}};
    std::size_t size = checkpoint.state.size();
    head(copy.scene, copy.t, copy.step, size);
    std::string text(MAGIC);
    text.append(head.bytes().data(), head.bytes().size());
    text.append(checkpoint.state.data(), checkpoint.state.size());
    StateWriter tail;
    std::uint64_t check = checkpoint_checksum(text);
    tail(check);
    text.append(tail.bytes().data(), tail.bytes().size());
    replace_text(file_in(folder), text);
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& folder) {
    const std::filesystem::path file = file_in(folder);
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    const std::string_view text(bytes.data(), bytes.size());
    if (!text.starts_with(MAGIC))
        throw SystemError(
            fmt::format("{} was written by another version of corpuscle; start the run "
                        "anew, without --restart",
                        file.string()));
    Checkpoint out;
    std::uint64_t check = 0;
    std::size_t size = 0;
    const auto damaged = [&] {
        return SystemError(
            fmt::format("{} is damaged; start the run anew, without --restart", file.string()));
    };
    const std::span<const char> all(bytes);
    if (all.size() < MAGIC.size() + sizeof(check)) throw damaged();
    StateReader tail(all.last(sizeof(check)));
    tail(check);
    const std::span<const char> told = all.first(all.size() - sizeof(check));
    if (checkpoint_checksum(told) != check) throw damaged();
    StateReader head(told.subspan(MAGIC.size()));
    head(out.scene, out.t, out.step, size);
    if (size > told.size()) throw damaged();
    out.state.assign(told.end() - static_cast<std::ptrdiff_t>(size), told.end());
    return out;
}

void remove_checkpoint(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::remove(file_in(folder), ignored);
}

}  // namespace corpuscle::io
