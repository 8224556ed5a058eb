// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::rawlog {

/// Cuts a gzip file into its members without unpacking it, so that threads can share that work:
/// where bytes like those at the beginning of the file come again, the next member seems to begin.
/// Whether it does shows when the one before is unpacked.
class MemberCutter {
 public:
    /// Reads from the beginning of the file. \param file outlives this
    explicit MemberCutter(std::FILE& file);

    /// Takes what seems to be the next member. \return false where the file ends, cannot be read,
    /// or has no other member near by
    bool next(std::vector<unsigned char>& packed);

    uint64_t position() const { return position_; }  ///< [byte] of the file: what is not taken
    bool atEnd() const { return ended_ && left().empty(); }

 private:
    bool readMore();
    std::string_view left() const;
    size_t headerFrom(size_t begin) const;

    static constexpr size_t headerSize = 10;    // [byte] of a member without name and comment
    static constexpr size_t longest = 1 << 21;  // [byte] of a member, packed
    std::FILE& file_;
    std::vector<unsigned char> bytes_;  // up to where the file was read
    size_t taken_ = 0;                  // of them
    std::string header_;
    uint64_t position_ = 0;
    bool ended_ = false;
};

/// Unpacks a gzip member that is no more than some MiB. \return false unless it is exactly one, and
/// sound
bool unpackMember(std::span<const unsigned char> packed, std::vector<unsigned char>& unpacked);

}  // namespace offmap::rawlog
