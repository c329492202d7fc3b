// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace corpuscle::io {

/// Room on the disk that is held for the last version of the results, should the disk be full by
/// then: a file of blocks that nobody else gets. Where the disk has none to hold, that is no error.
class Reserve {
public:
    /// Holds nothing yet.
    /// @param file  whose blocks are the room; made by hold_for(), removed by release()
    explicit Reserve(std::filesystem::path file) : file_(std::move(file)) {}

    /// Holds room for another version of this size, and some growth.                     [byte]
    void hold_for(std::uint64_t version);
    /// Gives all of it back.
    void release();

    [[nodiscard]] std::uint64_t size() const { return size_; }  ///< held now             [byte]

private:
    std::filesystem::path file_;
    std::uint64_t size_ = 0;
};

/// Tries out whether a folder's disk takes a file of this size, and leaves none.          [byte]
/// @throws SystemError with the reason where it does not
void expect_room(const std::filesystem::path& folder, std::uint64_t size);

}  // namespace corpuscle::io
