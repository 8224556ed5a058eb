// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace offmap::rawlog {

struct FilePiece;
class PieceReader;
class ReadAhead;
class StageTimes;

/// How a file is read.
struct Reading {
    bool ahead = false;           ///< by threads of TBB that are idle too, not only by who asks
    StageTimes* times = nullptr;  ///< that unpacking is added to; may be null
};

/// A file read from front to back: plain, gzip, or several gzip members one after the other. Unlike
/// MRPT's gzip stream it tells a file that is cut short, fails its checksum or has something else
/// appended from one that is complete.
class InputFile {
 public:
    /// Called where the file ends for now; true: it may have grown, so that reading goes on.
    using WaitForMore = std::function<bool()>;

    /// \throw std::runtime_error naming the file, the cause and the fix.
    explicit InputFile(const std::filesystem::path& file, WaitForMore waitForMore = {},
                       Reading reading = {});
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Reads up to `count` uncompressed bytes; fewer only where the file ends or fails.
    size_t read(void* to, size_t count);

    /// True if nothing can be read any more: the file is at its end, or has failed.
    bool atEnd();

    /// Why reading stopped before the end of the file; empty if nothing failed.
    const std::string& failure() const;

    bool isGzip() const;
    uint64_t position() const { return position_; }  ///< [byte] uncompressed
    uint64_t compressedPosition() const;             ///< [byte] of the file
    uint64_t compressedSize() const;                 ///< [byte] of the file

 private:
    bool fill();

    std::unique_ptr<PieceReader> reader_;
    std::unique_ptr<ReadAhead> ahead_;  ///< null: nobody reads ahead
    std::unique_ptr<FilePiece> piece_;
    size_t done_ = 0;  ///< [byte] of the piece that have been read
    uint64_t position_ = 0;
};

}  // namespace offmap::rawlog
