// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/checkpoint.hpp"

#include <fmt/format.h>

#include <array>
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
constexpr std::string_view MAGIC = "corpuscle checkpoint 24\n";
static_assert(MAGIC.size() % sizeof(std::uint64_t) == 0);  // Checksum takes whole words

std::filesystem::path file_in(const std::filesystem::path& folder) {
    return folder / "checkpoint";
}

/// The checksum of bytes that come in parts; all but the last are whole words.
class Checksum {
public:
    void add(std::span<const char> words) {
        std::uint64_t word = 0;
        for (; words.size() >= sizeof(word); words = words.subspan(sizeof(word))) {
            std::memcpy(&word, words.data(), sizeof(word));
            take(word);
        }
        rest_ = words;
    }
    [[nodiscard]] std::uint64_t end() {
        std::uint64_t word = static_cast<std::uint64_t>(rest_.size()) << 56U;
        if (!rest_.empty()) std::memcpy(&word, rest_.data(), rest_.size());
        take(word);
        return hash_;
    }

private:
    static constexpr std::uint64_t BASIS = 0xcbf29ce484222325U, PRIME = 0x100000001b3U;
    static constexpr int TURN = 29;  ///< or a word's last bit would stay where it is

    void take(std::uint64_t word) { hash_ = std::rotl(hash_ ^ word, TURN) * PRIME; }

    std::uint64_t hash_ = BASIS;
    std::span<const char> rest_;
};

std::string_view text_of(const std::vector<char>& bytes) {
    return {bytes.data(), bytes.size()};
}

}  // namespace

std::uint64_t checkpoint_checksum(std::span<const char> bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.end();
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
    StateWriter head, tail;
    head.raw(MAGIC.data(), MAGIC.size());
    Checkpoint copy{checkpoint.scene, checkpoint.t, checkpoint.step, {}};
    std::size_t size = checkpoint.state.size();
    head(copy.scene, copy.t, copy.step, size);
    Checksum sum;
    sum.add(head.bytes());
    sum.add(checkpoint.state);
    std::uint64_t check = sum.end();
    tail(check);
    const std::array parts{text_of(head.bytes()), text_of(checkpoint.state), text_of(tail.bytes())};
    replace_text(file_in(folder), parts);
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
