// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/GzipMember.h>
#include <offmap/rawlog/OutputFile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <random>
#include <stdexcept>
#include <unistd.h>
#include <utility>

namespace offmap::rawlog {
namespace fs = std::filesystem;
namespace {

constexpr size_t pieceSize = 1 << 18;  // [byte]
constexpr size_t blockSize = 1 << 20;  // [byte] uncompressed; 20 to 30 bytes of gzip for each

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

}  // namespace

OutputFile::OutputFile(const fs::path& target, const OutputOptions& options)
    : target_(target), options_(options), file_(nullptr, std::fclose) {
    checkTarget();
    if (options.gzipLevel) checkGzipLevel(*options.gzipLevel);
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
    if (!options_.gzipLevel) return append(bytes);
    for (const auto& block : cut(bytes)) append(packed(block));
}

std::vector<std::vector<std::byte>> OutputFile::cut(std::span<const std::byte> bytes) {
    if (!file_) throw std::logic_error("OutputFile is finished already");
    std::vector<std::vector<std::byte>> full;
    while (!bytes.empty()) {
        if (block_.empty()) block_.reserve(blockSize);
        const auto part = bytes.first(std::min(bytes.size(), blockSize - block_.size()));
        block_.insert(block_.end(), part.begin(), part.end());
        bytes = bytes.subspan(part.size());
        if (block_.size() == blockSize) full.push_back(std::exchange(block_, {}));
    }
    return full;
}

std::vector<std::byte> OutputFile::packed(std::span<const std::byte> block) const {
    return gzipMember(block, options_.gzipLevel.value());
}

void OutputFile::append(std::span<const std::byte> packed) {
    if (!file_) throw std::logic_error("OutputFile is finished already");
    if (std::fwrite(packed.data(), 1, packed.size(), file_.get()) != packed.size()) fail(errno);
    size_ += packed.size();
}

uint64_t OutputFile::finish() {
    if (!file_) return size_;
    const bool last = !block_.empty() || size_ == 0;  // of nothing, an empty member
    if (options_.gzipLevel && last) append(packed(std::exchange(block_, {})));
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
