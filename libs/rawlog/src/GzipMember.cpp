// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/GzipMember.h>

#include <array>
#include <libdeflate.h>
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

}  // namespace

void checkGzipLevel(int level) {
    if (level < 0 || level >= static_cast<int>(levels)) {
        throw std::invalid_argument("gzip level must be 0 to 9");
    }
}

std::vector<std::byte> gzipMember(std::span<const std::byte> content, int level) {
    checkGzipLevel(level);
    libdeflate_compressor& compressor = compressorOf(level);
    std::vector<std::byte> member(libdeflate_gzip_compress_bound(&compressor, content.size()));
    member.resize(libdeflate_gzip_compress(&compressor, content.data(), content.size(),
                                           member.data(), member.size()));
    return member;
}

}  // namespace offmap::rawlog
