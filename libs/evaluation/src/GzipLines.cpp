// SPDX-License-Identifier: BSD-3-Clause
#include "GzipLines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <zlib.h>

namespace offmap::evaluation {

namespace {

constexpr size_t textSize = 1 << 20;  // [byte], also the longest line

}  // namespace

GzipLines::GzipLines(const std::filesystem::path& file)
    : path_(file), file_(nullptr, gzclose), text_(textSize) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        throw std::runtime_error(file.string() + " is a folder; name a file in it");
    }
    errno = 0;
    file_.reset(gzopen(file.c_str(), "rb"));
    if (!file_) {
        throw std::runtime_error(
            fmt::format("cannot open {}: {}; check the path and its permissions", file.string(),
                        errno != 0 ? std::strerror(errno) : "out of memory"));
    }
    gzbuffer(file_.get(), 1 << 18);
}

void GzipLines::fill() {
    std::copy(text_.begin() + static_cast<std::ptrdiff_t>(begin_),
              text_.begin() + static_cast<std::ptrdiff_t>(end_), text_.begin());
    end_ -= begin_;
    begin_ = 0;
    const auto free = static_cast<unsigned>(text_.size() - end_);
    const int size = gzread(file_.get(), text_.data() + end_, free);
    int status = Z_OK;
    const char* cause = gzerror(file_.get(), &status);
    if (size < 0 || (status != Z_OK && status != Z_STREAM_END)) {
        throw std::runtime_error(
            fmt::format("{}, after line {}: {}; the file is truncated or corrupt", path_.string(),
                        line_, status == Z_ERRNO ? std::strerror(errno) : cause));
    }
    end_ += static_cast<size_t>(size);
    atEnd_ = size == 0;
}

std::optional<std::string_view> GzipLines::next() {
    size_t searched = 0;
    const void* newline = nullptr;
    for (;;) {
        newline = std::memchr(text_.data() + begin_ + searched, '\n', end_ - begin_ - searched);
        if (newline || atEnd_) break;
        searched = end_ - begin_;
        if (searched == text_.size()) {
            ++line_;
            fail("the line is longer than any of a text file; name another file");
        }
        fill();
    }
    if (!newline && begin_ == end_) return std::nullopt;
    ++line_;
    const char* from = text_.data() + begin_;
    const char* to = newline ? static_cast<const char*>(newline) : text_.data() + end_;
    begin_ = newline ? static_cast<size_t>(to - text_.data()) + 1 : end_;
    if (to != from && to[-1] == '\r') --to;
    return std::string_view(from, to);
}

void GzipLines::fail(const std::string& message) const {
    throw std::runtime_error(fmt::format("{}, line {}: {}", path_.string(), line_, message));
}

}  // namespace offmap::evaluation
