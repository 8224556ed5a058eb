// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/GzipMember.h>

#include <array>
#include <isa-l/igzip_lib.h>
#include <libdeflate.h>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace offmap::rawlog {
namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
};

constexpr size_t levels = 10;

/// This thread's own: a compressor is working memory.
libdeflate_compressor& compressorOf(int level) {
    using Compressor = std::unique_ptr<libdeflate_compressor, FreeCompressor>;
    thread_local std::array<Compressor, levels> compressors;
    Compressor& compressor = compressors[static_cast<size_t>(level)];
    if (!compressor) compressor.reset(libdeflate_alloc_compressor(level));
    if (!compressor) throw std::bad_alloc();
    return *compressor;
}

using Bytes = std::span<const std::byte>;

std::vector<std::byte> deflated(Bytes content, int level) {
    libdeflate_compressor& compressor = compressorOf(level);
    std::vector<std::byte> member(libdeflate_gzip_compress_bound(&compressor, content.size()));
    member.resize(libdeflate_gzip_compress(&compressor, content.data(), content.size(),
                                           member.data(), member.size()));
    return member;
}

/// By ISA-L, whose first level is three times as quick as libdeflate's, and as good as zlib's but
/// for a few percent. \pre content is below 4 GiB
std::vector<std::byte> quicklyDeflated(Bytes content) {
    struct Working {
        isal_zstream stream;
        std::array<uint8_t, ISAL_DEF_LVL1_DEFAULT> level;
    };
    thread_local const auto working = std::make_unique<Working>();
    isal_zstream& stream = working->stream;
    isal_deflate_init(&stream);
    stream.level = 1;
    stream.level_buf = working->level.data();
    stream.level_buf_size = static_cast<uint32_t>(working->level.size());
    stream.gzip_flag = IGZIP_GZIP;
    stream.end_of_stream = 1;
    // ISA-L only reads it.
    stream.next_in = reinterpret_cast<uint8_t*>(const_cast<std::byte*>(content.data()));
    stream.avail_in = static_cast<uint32_t>(content.size());
    std::vector<std::byte> member;
    while (stream.internal_state.state != ZSTATE_END) {
        constexpr size_t wrapping = 64;  // [byte] more than header, checksum and size
        const size_t room = stream.avail_in / 2 + wrapping;
        member.resize(stream.total_out + room);
        stream.next_out = reinterpret_cast<uint8_t*>(member.data() + stream.total_out);
        stream.avail_out = static_cast<uint32_t>(room);
        if (isal_deflate(&stream) != COMP_OK) throw std::logic_error("ISA-L cannot compress");
    }
    member.resize(stream.total_out);
    return member;
}

}  // namespace

void checkGzipLevel(int level) {
    if (level < 0 || level >= static_cast<int>(levels)) {
        throw std::invalid_argument("gzip level must be 0 to 9");
    }
}

std::vector<std::byte> gzipMember(std::span<const std::byte> content, int level) {
    checkGzipLevel(level);
    const bool quick = level == 1 && content.size() <= std::numeric_limits<uint32_t>::max();
    return quick ? quicklyDeflated(content) : deflated(content, level);
}

}  // namespace offmap::rawlog
