// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct gzFile_s;

namespace offmap::evaluation {

/// The lines of a text file, plain or gzip, one after the other.
class GzipLines {
 public:
    /// \throw std::runtime_error naming the file, as all members do.
    explicit GzipLines(const std::filesystem::path& file);

    /// Without its end, "\n" or "\r\n"; none at the end of the file. Holds until the next call.
    std::optional<std::string_view> next();

    /// \throw std::runtime_error always: "FILE, line N: MESSAGE"
    [[noreturn]] void fail(const std::string& message) const;

 private:
    void fill();

    std::filesystem::path path_;
    std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> file_;
    std::vector<char> text_;
    size_t begin_ = 0, end_ = 0;  ///< what of text_ is not yet read
    bool atEnd_ = false;
    uint64_t line_ = 0;  ///< number of the latest line, from 1
};

}  // namespace offmap::evaluation
