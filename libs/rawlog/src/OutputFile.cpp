// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/OutputFile.h>

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <random>
#include <stdexcept>
#include <unistd.h>
#include <zlib.h>

namespace offmap::rawlog {
namespace fs = std::filesystem;
namespace {

constexpr size_t pieceSize = 1 << 18;  // [byte]
constexpr int gzipFormat = 15 + 16;    // largest window, gzip header
constexpr int defaultMemory = 8;

std::string_view fixFor(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "free space on that disk, or write to another";
        case EFBIG:
            return "raise the limit of the file size (ulimit -f)";
        case EACCES:
        case EPERM:
        case EROFS:
            return "make its folder writable, or write to another";
        case ENOENT:
        case ENOTDIR:
            return "create its folder first";
        case EEXIST:
            return "choose another name, or allow it to be overwritten (--force)";
        case ENAMETOOLONG:
            return "choose a shorter name";
        default:
            return "check the disk, or write to another";
    }
}

// A file size limit then shows as EFBIG and not as a signal that ends the program.
void ignoreFileSizeSignal() {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction current {};
        sigaction(SIGXFSZ, nullptr, &current);
        if (current.sa_handler == SIG_DFL) std::signal(SIGXFSZ, SIG_IGN);
    });
}

fs::path hiddenNameBeside(const fs::path& target) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
    constexpr size_t longestName = 255 - 13;  // NAME_MAX without ".", ".XXXXXX" and ".part"
    std::random_device random;
    std::uniform_int_distribution<size_t> pick(0, letters.size() - 1);
    std::string suffix(6, ' ');
    for (char& letter : suffix) letter = letters[pick(random)];
    const std::string name = target.filename().string().substr(0, longestName);
    return target.parent_path() / fmt::format(".{}.{}.part", name, suffix);
}

void endDeflate(z_stream* stream) {
    deflateEnd(stream);
    delete stream;
}

}  // namespace

OutputFile::OutputFile(const fs::path& target, const OutputOptions& options)
    : target_(target),
      options_(options),
      file_(nullptr, std::fclose),
      deflate_(nullptr, endDeflate) {
    checkTarget();
    if (options.gzipLevel) {
        auto stream = std::make_unique<z_stream>();
        const int status = deflateInit2(stream.get(), *options.gzipLevel, Z_DEFLATED, gzipFormat,
                                        defaultMemory, Z_DEFAULT_STRATEGY);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        if (status != Z_OK) throw std::invalid_argument("gzip level must be 0 to 9");
        deflate_.reset(stream.release());
        compressed_.resize(pieceSize);
    }
    ignoreFileSizeSignal();
    openTemporary();
}

OutputFile::~OutputFile() { removeTemporary(); }

void OutputFile::checkTarget() const {
    std::error_code error;
    const fs::file_status status = fs::status(target_, error);
    if (!fs::status_known(status)) fail(error.value());
    if (!target_.has_filename() || fs::is_directory(status)) {
        throw std::runtime_error(
            fmt::format("cannot write {}: it is a folder; name a file in it", target_.string()));
    }
    const bool isTaken = fs::exists(fs::symlink_status(target_, error));  // also by a dangling link
    if (isTaken && !options_.overwrite) fail(EEXIST);
    if (!fs::exists(status)) return;
    if (!fs::is_regular_file(status)) {
        throw std::runtime_error(fmt::format(
            "cannot write {}: it is not a regular file; choose another name", target_.string()));
    }
}

void OutputFile::openTemporary() {
    constexpr int attempts = 100;
    for (int i = 0; i < attempts && !file_; ++i) {
        temporary_ = hiddenNameBeside(target_);
        if (options_.temporaries) options_.temporaries->add(temporary_);
        file_.reset(std::fopen(temporary_.c_str(), "wbxe"));
        if (file_) break;
        const int error = errno;
        if (options_.temporaries) options_.temporaries->remove(temporary_);
        temporary_.clear();
        if (error != EEXIST) fail(error);
    }
    if (!file_) fail(EEXIST);
    std::setvbuf(file_.get(), nullptr, _IOFBF, pieceSize);
}

void OutputFile::removeTemporary() noexcept {
    file_.reset();
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    if (options_.temporaries) options_.temporaries->remove(temporary_);
    temporary_.clear();
}

void OutputFile::write(std::span<const std::byte> bytes) {
    if (!file_) throw std::logic_error("OutputFile is finished already");
    if (!deflate_) return writePlain(bytes.data(), bytes.size());
    constexpr size_t longest = 1 << 30;  // zlib counts in 32 bits
    for (; bytes.size() > longest; bytes = bytes.subspan(longest)) {
        deflatePiece(bytes.first(longest), Z_NO_FLUSH);
    }
    deflatePiece(bytes, Z_NO_FLUSH);
}

void OutputFile::deflatePiece(std::span<const std::byte> bytes, int flush) {
    z_stream& stream = *deflate_;
    // zlib's interface is not const-correct; it does not write to its input.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    do {
        stream.next_out = compressed_.data();
        stream.avail_out = static_cast<uInt>(compressed_.size());
        if (deflate(&stream, flush) == Z_STREAM_ERROR) throw std::logic_error("deflate failed");
        writePlain(compressed_.data(), compressed_.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

void OutputFile::writePlain(const void* bytes, size_t count) {
    if (std::fwrite(bytes, 1, count, file_.get()) != count) fail(errno);
    size_ += count;
}

uint64_t OutputFile::finish() {
    if (!file_) return size_;
    if (deflate_) deflatePiece({}, Z_FINISH);
    if (std::fflush(file_.get()) != 0) fail(errno);
    // EINVAL, ENOTSUP: this file system cannot sync
    if (fsync(fileno(file_.get())) != 0 && errno != EINVAL && errno != ENOTSUP) fail(errno);
    if (std::fclose(file_.release()) != 0) fail(errno);
    return size_;
}

void OutputFile::publish() {
    if (temporary_.empty()) throw std::logic_error("OutputFile is published already");
    finish();
    const unsigned flags = options_.overwrite ? 0 : RENAME_NOREPLACE;
    int status = renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), flags);
    if (status != 0 && (errno == EINVAL || errno == ENOSYS)) {  // the file system knows no flags
        status = std::rename(temporary_.c_str(), target_.c_str());
    }
    if (status != 0) fail(errno);
    if (options_.temporaries) options_.temporaries->remove(temporary_);
    temporary_.clear();
    syncFolder();
}

void OutputFile::syncFolder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;  // writable but not readable: the name cannot be synced
    const int error = fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (error == EIO || error == ENOSPC || error == EDQUOT) fail(error);
}

void OutputFile::fail(int error) const {
    const std::string_view cause = error == EEXIST ? "it exists already" : std::strerror(error);
    throw std::runtime_error(
        fmt::format("cannot write {}: {}; {}", target_.string(), cause, fixFor(error)));
}

}  // namespace offmap::rawlog
