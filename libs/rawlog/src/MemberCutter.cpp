// SPDX-License-Identifier: BSD-3-Clause
#include "MemberCutter.h"

#include <algorithm>
#include <cstring>
#include <isa-l/igzip_lib.h>

namespace offmap::rawlog {

MemberCutter::MemberCutter(std::FILE& file) : file_(file) {
    std::fseek(&file_, 0, SEEK_SET);
    readMore();
    std::copy_n(bytes_.begin(), std::min(bytes_.size(), headerSize), header_.begin());
}

bool MemberCutter::readMore() {
    constexpr size_t piece = 1 << 18;
    const size_t before = bytes_.size();
    bytes_.resize(before + piece);
    const size_t size = std::fread(bytes_.data() + before, 1, piece, &file_);
    bytes_.resize(before + size);
    ended_ = size == 0 && !std::ferror(&file_);
    return size > 0;
}

/// Where a header begins from some byte on; the number of bytes if none does.
size_t MemberCutter::headerFrom(size_t begin) const {
    const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(begin, bytes_.size()));
    const auto found = std::search(from, bytes_.end(), header_.begin(), header_.end());
    return static_cast<size_t>(found - bytes_.begin());
}

bool MemberCutter::next(std::vector<unsigned char>& packed) {
    size_t end = headerFrom(1);
    while (end == bytes_.size() && end < longest) {
        if (!readMore()) break;
        end = headerFrom(end > headerSize ? end - headerSize : 1);
    }
    if (bytes_.empty() || (end == bytes_.size() && !ended_)) return false;
    const auto behind = bytes_.begin() + static_cast<std::ptrdiff_t>(end);
    packed.assign(bytes_.begin(), behind);
    bytes_.erase(bytes_.begin(), behind);
    position_ += end;
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
