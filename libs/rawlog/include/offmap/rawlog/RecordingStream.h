// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/InputFile.h>

#include <mrpt/io/CStream.h>

#include <span>
#include <vector>

namespace offmap::rawlog {

/// Hands the bytes of a file to MRPT's deserialiser and remembers them.
class RecordingStream : public mrpt::io::CStream {
 public:
    explicit RecordingStream(InputFile& input) : input_(input) {}

    /// Forgets what was recorded.
    void beginRecord();
    /// What was read since then; holds until the next read.
    std::span<const std::byte> record() const { return record_; }
    /// True if since then more bytes were asked for than there were.
    bool cameShort() const { return cameShort_; }

    size_t Read(void* to, size_t count) override;
    /// \throw std::logic_error always: this stream is read from front to back.
    size_t Write(const void* from, size_t count) override;
    /// \throw std::logic_error always: this stream is read from front to back.
    uint64_t Seek(int64_t offset, TSeekOrigin origin) override;
    /// \throw std::logic_error always: the uncompressed size is not known beforehand.
    uint64_t getTotalBytesCount() const override;
    uint64_t getPosition() const override { return input_.position(); }

 private:
    InputFile& input_;
    std::vector<std::byte> record_;
    bool cameShort_ = false;
};

}  // namespace offmap::rawlog
