// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/InputFile.h>
#include <offmap/rawlog/RecordingStream.h>

#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

namespace offmap::rawlog {

/// A rawlog that cannot be read, or not further than to the entry at `place`.
class RawlogError : public std::runtime_error {
 public:
    RawlogError(const std::string& message, const EntryPlace& at)
        : std::runtime_error(message), place(at) {}

    EntryPlace place;
};

struct RawlogEntry {
    EntryPlace place;
    std::span<const std::byte> bytes;  ///< as they stand in the uncompressed stream; holds until
                                       ///< the next entry is read
    mrpt::serialization::CSerializable::Ptr object;  ///< null where a null pointer is stored
};

/// Reads a rawlog entry by entry: gzip (also of several members) or plain. Corrupt bytes can crash
/// MRPT's deserialiser, so files that are not trusted are read inside runGuarded().
class RawlogReader {
 public:
    /// \param waitForMore of a log that is still being written, see InputFile
    /// \throw RawlogError if the file cannot be opened, is empty or not what it should be.
    explicit RawlogReader(const std::filesystem::path& file,
                          InputFile::WaitForMore waitForMore = {}, Reading reading = {});
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;

    /// The next entry; none at the clean end of the file.
    /// \throw RawlogError if it cannot be read; the reader is then of no further use.
    std::optional<RawlogEntry> next();

    /// Where the next entry begins; after the last one, the number of entries and bytes.
    const EntryPlace& place() const { return place_; }

    bool isGzip() const { return input_.isGzip(); }
    uint64_t compressedPosition() const { return input_.compressedPosition(); }  ///< [byte] read
    uint64_t compressedSize() const { return input_.compressedSize(); }  ///< [byte] of the file

 private:
    mrpt::serialization::CSerializable::Ptr readObject();
    [[noreturn]] void fail(const std::string& reason) const;

    std::filesystem::path file_;
    InputFile input_;
    RecordingStream stream_;
    mrpt::serialization::CArchive::UniquePtr archive_;
    EntryPlace place_;
};

}  // namespace offmap::rawlog
