// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct z_stream_s;

namespace offmap::rawlog {

/// A file read from front to back: plain, gzip, or several gzip members one after the other. Unlike
/// MRPT's gzip stream it tells a file that is cut short, fails its checksum or has something else
/// appended from one that is complete.
class InputFile {
 public:
    /// Called where the file ends for now; true: it may have grown, so that reading goes on.
    using WaitForMore = std::function<bool()>;

    /// \throw std::runtime_error naming the file, the cause and the fix.
    explicit InputFile(const std::filesystem::path& file, WaitForMore waitForMore = {});

    /// Reads up to `count` uncompressed bytes; fewer only where the file ends or fails.
    size_t read(void* to, size_t count);

    /// True if nothing can be read any more: the file is at its end, or has failed.
    bool atEnd();

    /// Why reading stopped before the end of the file; empty if nothing failed.
    const std::string& failure() const { return failure_; }

    bool isGzip() const { return inflate_ != nullptr; }
    uint64_t position() const { return position_; }                      ///< [byte] uncompressed
    uint64_t compressedPosition() const { return compressedPosition_; }  ///< [byte] of the file
    uint64_t compressedSize() const { return compressedSize_; }          ///< [byte] of the file

 private:
    bool fill();
    bool fillInflated();
    bool beginMember();
    bool readPiece(std::vector<unsigned char>& to, size_t& size);

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    WaitForMore waitForMore_;
    std::unique_ptr<z_stream_s, void (*)(z_stream_s*)> inflate_;  ///< null: the file is plain
    std::vector<unsigned char> compressed_, plain_;
    size_t plainBegin_ = 0, plainEnd_ = 0;  ///< what of plain_ is not yet read
    bool inMember_ = false, firstMember_ = true;
    std::string failure_;
    uint64_t position_ = 0, compressedPosition_ = 0, compressedSize_ = 0;
};

}  // namespace offmap::rawlog
