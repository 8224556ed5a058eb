// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace offmap::rawlog {

/// Is told of temporary files, so that they can be removed if the program that writes them dies.
class TemporaryFiles {
 public:
    virtual ~TemporaryFiles() = default;
    virtual void add(const std::filesystem::path& file) = 0;     ///< before the file is created
    virtual void remove(const std::filesystem::path& file) = 0;  ///< after it is gone
};

struct OutputOptions {
    std::optional<int> gzipLevel = {};      ///< 0 to 9; none: not compressed
    bool overwrite = false;                 ///< an existing file may be replaced
    TemporaryFiles* temporaries = nullptr;  ///< must outlive the file
};

/// A file that appears under its name only when it is complete. Until publish() its content stands
/// in a hidden temporary file beside it, which the destructor removes. The bytes written depend on
/// the content alone: no time stamp, no file name. Compressed, it is cut into blocks of fixed size,
/// each a gzip member, so that threads can share the work.
class OutputFile {
 public:
    /// \throw std::runtime_error naming the file, the cause and the fix, as all members do.
    explicit OutputFile(const std::filesystem::path& target, const OutputOptions& options = {});
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

    /// write() in three steps, for a compressed file: what the bytes complete, in order; each block
    /// packed, in any thread; the packed ones, in order.
    std::vector<std::vector<std::byte>> cut(std::span<const std::byte> bytes);
    std::vector<std::byte> packed(std::span<const std::byte> block) const;
    void append(std::span<const std::byte> packed);

    /// Brings everything to the disk and closes the file. Several files can so be known to be
    /// complete before the first is published. \return its size [byte]
    uint64_t finish();

    /// Gives the file its name. Calls finish() if that was not done.
    void publish();

    const std::filesystem::path& target() const { return target_; }

 private:
    void checkTarget() const;
    void openTemporary();
    void removeTemporary() noexcept;
    void syncFolder() const;
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_, temporary_;
    OutputOptions options_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::vector<std::byte> block_;  ///< that is not full yet
    uint64_t size_ = 0;             ///< [byte] written to the disk
};

}  // namespace offmap::rawlog
