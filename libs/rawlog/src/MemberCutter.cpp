// SPDX-License-Identifier: BSD-3-Clause
#include "MemberCutter.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <isa-l/igzip_lib.h>

namespace offmap::rawlog {

MemberCutter::MemberCutter(std::FILE& file) : file_(file) {
    std::fseek(&file_, 0, SEEK_SET);
    readMore();
    header_ = left().substr(0, headerSize);
}

bool MemberCutter::readMore() {
    constexpr size_t piece = 1 << 18;
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(taken_));
    taken_ = 0;
    const size_t before = bytes_.size();
    bytes_.resize(before + piece);
    const size_t size = std::fread(bytes_.data() + before, 1, piece, &file_);
    bytes_.resize(before + size);
    ended_ = size == 0 && !std::ferror(&file_);
    return size > 0;
}

std::string_view MemberCutter::left() const {
    return {reinterpret_cast<const char*>(bytes_.data()) + taken_, bytes_.size() - taken_};
}

/// How many bytes stand before the header that begins at one of them or later; all if none does.
size_t MemberCutter::headerFrom(size_t begin) const {
    return std::min(left().find(header_, begin), left().size());
}

bool MemberCutter::next(std::vector<unsigned char>& packed) {
    size_t size = headerFrom(1);
    while (size == left().size() && size < longest) {
        if (!readMore()) break;
        size = headerFrom(size > headerSize ? size - headerSize : 1);
    }
    if (left().empty() || (size == left().size() && !ended_)) return false;
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(taken_);
    packed.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
    taken_ += size;
    position_ += size;
    return true;
}

bool unpackMember(std::span<const unsigned char> packed, std::vector<unsigned char>& unpacked) {
    constexpr uint32_t largest = 1 << 24;  // [byte]
    uint32_t size = 0;                     // as the member ends with it
    if (packed.size() < sizeof size) return false;
    std::memcpy(&size, packed.data() + packed.size() - sizeof size, sizeof size);
    if (size > largest) return false;
    unpacked.resize(size);
    inflate_state state;
    isal_inflate_init(&state);
    state.crc_flag = ISAL_GZIP;
    state.next_in = const_cast<unsigned char*>(packed.data());  // ISA-L only reads it
    state.avail_in = static_cast<uint32_t>(packed.size());
    state.next_out = unpacked.data();
    state.avail_out = size;
    return isal_inflate(&state) == ISAL_DECOMP_OK && state.block_state == ISAL_BLOCK_FINISH &&
           state.avail_in == 0 && state.avail_out == 0;
}

}  // namespace offmap::rawlog
