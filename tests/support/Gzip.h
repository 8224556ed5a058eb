// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <zlib.h>

namespace offmap::test {

/// One gzip member. \param level 0: stored as it is
inline std::string gzipped(const std::string& content, int level = 6) {
    z_stream stream{};
    deflateInit2(&stream, level, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    const int status = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (status != Z_STREAM_END) throw std::runtime_error("deflate failed");
    return packed;
}

/// What a file holds, decompressed by zlib's own file reader; plain files as they are.
inline std::string gunzippedFile(const std::filesystem::path& file) {
    gzFile in = gzopen(file.c_str(), "rb");
    if (in == nullptr) throw std::runtime_error("cannot read " + file.string());
    std::string content, piece(1 << 16, '\0');
    int size = 0;
    while ((size = gzread(in, piece.data(), static_cast<unsigned>(piece.size()))) > 0) {
        content.append(piece, 0, static_cast<size_t>(size));
    }
    if (gzclose(in) != Z_OK || size < 0) throw std::runtime_error("damaged: " + file.string());
    return content;
}

}  // namespace offmap::test
