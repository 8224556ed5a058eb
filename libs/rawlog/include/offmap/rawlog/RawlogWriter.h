// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/OutputFile.h>

#include <mrpt/serialization/CSerializable.h>

#include <vector>

namespace offmap::rawlog {

/// Writes a gzip rawlog entry by entry; it appears under its name with publish().
class RawlogWriter {
 public:
    /// gzip level 1 unless told otherwise: on laser data a higher one gains next to nothing.
    /// \throw std::runtime_error naming the file, the cause and the fix, as all members do.
    explicit RawlogWriter(const std::filesystem::path& target, OutputOptions options = {1});

    /// Copies entries as they stood in another rawlog.
    void writeBytes(std::span<const std::byte> entry) { file_.write(entry); }
    void write(const mrpt::serialization::CSerializable& object);

    /// For those who write in several threads: takes entries in three steps, see OutputFile.
    OutputFile& file() { return file_; }

    /// See OutputFile. \return the size of the file [byte]
    uint64_t finish() { return file_.finish(); }
    void publish() { file_.publish(); }

    const std::filesystem::path& target() const { return file_.target(); }

 private:
    OutputFile file_;
    std::vector<std::byte> serialised_;  ///< reused
};

}  // namespace offmap::rawlog
