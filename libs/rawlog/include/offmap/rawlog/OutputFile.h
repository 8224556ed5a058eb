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

struct z_stream_s;

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
/// the content alone: no time stamp, no file name.
class OutputFile {
 public:
    /// \throw std::runtime_error naming the file, the cause and the fix, as all members do.
    explicit OutputFile(const std::filesystem::path& target, const OutputOptions& options = {});
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

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
    void deflatePiece(std::span<const std::byte> bytes, int flush);
    void writePlain(const void* bytes, size_t count);
    void syncFolder() const;
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_, temporary_;
    OutputOptions options_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::unique_ptr<z_stream_s, void (*)(z_stream_s*)> deflate_;  ///< null: not compressed
    std::vector<unsigned char> compressed_;
    uint64_t size_ = 0;  ///< [byte] written to the disk
};

}  // namespace offmap::rawlog
