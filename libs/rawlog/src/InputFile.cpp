// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/InputFile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <sys/stat.h>
#include <utility>
#include <zlib.h>

namespace offmap::rawlog {
namespace {

constexpr size_t pieceSize = 1 << 18;  // [byte]
constexpr int gzipOnly = 15 + 16;      // largest window, gzip header expected

[[noreturn]] void failToOpen(const std::filesystem::path& file, int error) {
    std::string_view fix = "check the file and the disk";
    if (error == ENOENT || error == ENOTDIR) fix = "check the path";
    if (error == EACCES || error == EPERM) fix = "check its permissions";
    throw std::runtime_error(
        fmt::format("cannot open {}: {}; {}", file.string(), std::strerror(error), fix));
}

uint64_t checkedSize(std::FILE* file, const std::filesystem::path& path) {
    struct stat info {};
    if (fstat(fileno(file), &info) != 0) failToOpen(path, errno);
    if (S_ISDIR(info.st_mode)) {
        throw std::runtime_error(path.string() + " is a folder; name a file in it");
    }
    if (!S_ISREG(info.st_mode)) {
        throw std::runtime_error(
            path.string() + " is not a regular file; copy its content into one, it is read twice");
    }
    return static_cast<uint64_t>(info.st_size);
}

void endInflate(z_stream* stream) {
    inflateEnd(stream);
    delete stream;
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& file, WaitForMore waitForMore)
    : file_(std::fopen(file.c_str(), "rbe"), std::fclose),
      waitForMore_(std::move(waitForMore)),
      inflate_(nullptr, endInflate) {
    if (!file_) failToOpen(file, errno);
    compressedSize_ = checkedSize(file_.get(), file);
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    compressed_.resize(pieceSize);
    plain_.resize(pieceSize);
    size_t size = 0;
    readPiece(compressed_, size);
    const bool isGzip = size >= 2 && compressed_[0] == 0x1f && compressed_[1] == 0x8b;
    if (!isGzip) {
        plain_.swap(compressed_);
        plainEnd_ = size;
        return;
    }
    auto stream = std::make_unique<z_stream>();
    if (inflateInit2(stream.get(), gzipOnly) != Z_OK) throw std::bad_alloc();
    inflate_.reset(stream.release());
    inflate_->next_in = compressed_.data();
    inflate_->avail_in = static_cast<uInt>(size);
}

size_t InputFile::read(void* to, size_t count) {
    auto* out = static_cast<unsigned char*>(to);
    size_t done = 0;
    while (done < count && (plainBegin_ < plainEnd_ || fill())) {
        const size_t size = std::min(count - done, plainEnd_ - plainBegin_);
        std::memcpy(out + done, plain_.data() + plainBegin_, size);
        plainBegin_ += size;
        done += size;
    }
    position_ += done;
    return done;
}

bool InputFile::atEnd() { return plainBegin_ == plainEnd_ && !fill(); }

bool InputFile::fill() {
    plainBegin_ = plainEnd_ = 0;
    if (!failure_.empty()) return false;
    return inflate_ ? fillInflated() : readPiece(plain_, plainEnd_);
}

bool InputFile::readPiece(std::vector<unsigned char>& to, size_t& size) {
    do {
        std::clearerr(file_.get());  // the end of the file, where it ended before
        size = std::fread(to.data(), 1, to.size(), file_.get());
    } while (size == 0 && !std::ferror(file_.get()) && waitForMore_ && waitForMore_());
    compressedPosition_ += size;
    if (std::ferror(file_.get())) failure_ = fmt::format("read error: {}", std::strerror(errno));
    return size > 0;
}

bool InputFile::fillInflated() {
    z_stream& stream = *inflate_;
    while (failure_.empty() && plainEnd_ == 0) {
        if (stream.avail_in == 0) {
            size_t size = 0;
            if (!readPiece(compressed_, size)) {
                if (inMember_ && failure_.empty()) failure_ = "its gzip stream ends too early";
                return false;
            }
            stream.next_in = compressed_.data();
            stream.avail_in = static_cast<uInt>(size);
        }
        if (!inMember_ && !beginMember()) continue;
        stream.next_out = plain_.data();
        stream.avail_out = static_cast<uInt>(plain_.size());
        const int status = inflate(&stream, Z_NO_FLUSH);
        plainEnd_ = plain_.size() - stream.avail_out;
        if (status == Z_STREAM_END) {
            inMember_ = firstMember_ = false;
        } else if (status != Z_OK && status != Z_BUF_ERROR) {
            failure_ = fmt::format("gzip: {}", stream.msg ? stream.msg : zError(status));
        }
    }
    return plainEnd_ > 0;
}

bool InputFile::beginMember() {
    z_stream& stream = *inflate_;
    if (!firstMember_) {
        // Some tapes and file systems pad with zeros; gzip allows it.
        while (stream.avail_in > 0 && *stream.next_in == 0) ++stream.next_in, --stream.avail_in;
        if (stream.avail_in == 0) return false;
        if (*stream.next_in != 0x1f) {
            failure_ = "bytes that are not gzip follow the end of its gzip stream";
            return false;
        }
    }
    inMember_ = inflateReset(&stream) == Z_OK;
    return inMember_;
}

}  // namespace offmap::rawlog
