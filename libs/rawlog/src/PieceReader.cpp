// SPDX-License-Identifier: BSD-3-Clause
#include "PieceReader.h"

#include "MemberCutter.h"

#include <offmap/rawlog/StageTimes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <isa-l/igzip_lib.h>
#include <optional>
#include <stdexcept>
#include <sys/stat.h>
#include <utility>

namespace offmap::rawlog {
namespace {

constexpr size_t pieceSize = 1 << 18;  // [byte]

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

std::string_view inflateError(int status) {
    switch (status) {
        case ISAL_INCORRECT_CHECKSUM:
            return "incorrect checksum";
        case ISAL_INVALID_WRAPPER:
        case ISAL_UNSUPPORTED_METHOD:
            return "incorrect header";
        case ISAL_INVALID_LOOKBACK:
            return "invalid distance";
        default:
            return "invalid block";
    }
}

}  // namespace

PieceReader::PieceReader(const std::filesystem::path& file, InputFile::WaitForMore waitForMore,
                         StageTimes* times)
    : file_(std::fopen(file.c_str(), "rbe"), std::fclose),
      waitForMore_(std::move(waitForMore)),
      times_(times),
      inflate_(nullptr, [](inflate_state* state) { delete state; }),
      compressed_(pieceSize) {
    if (!file_) failToOpen(file, errno);
    compressedSize_ = checkedSize(file_.get(), file);
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    sniffed_ = readCompressed(compressed_);
    const bool isGzip = sniffed_ >= 2 && compressed_[0] == 0x1f && compressed_[1] == 0x8b;
    if (!isGzip) return;
    inflate_.reset(new inflate_state);
    isal_inflate_init(inflate_.get());
    inflate_->next_in = compressed_.data();
    inflate_->avail_in = static_cast<uint32_t>(std::exchange(sniffed_, 0));
}

PieceReader::~PieceReader() = default;

void PieceReader::cutMembers() {
    // A file that grows ends anywhere.
    if (isGzip() && !waitForMore_) cutter_ = std::make_unique<MemberCutter>(*file_);
}

bool PieceReader::unpack(FilePiece& piece) const {
    if (piece.packed.empty()) return true;
    std::optional<StageTimes::Measure> measure;
    if (times_) measure.emplace(*times_, StageTimes::Unpack);
    return unpackMember(piece.packed, piece.bytes);
}

void PieceReader::goOnUncut(uint64_t position) {
    cutter_.reset();
    std::fseek(file_.get(), static_cast<long>(position), SEEK_SET);
    compressedPosition_ = position;
    inflate_->avail_in = 0;
    inMember_ = false;
    firstMember_ = position == 0;
}

/// False if what comes next cannot be cut; then nothing is, from now on.
bool PieceReader::cut(FilePiece& piece) {
    piece.bytes.clear();
    piece.packed.clear();
    piece.failure.clear();
    if (!cutter_->next(piece.packed) && !cutter_->atEnd()) {
        goOnUncut(cutter_->position());
        return false;
    }
    piece.compressedPosition = cutter_->position();
    return true;
}

void PieceReader::read(FilePiece& piece) {
    std::optional<StageTimes::Measure> measure;
    if (times_) measure.emplace(*times_, StageTimes::Unpack);
    if (cutter_ && cut(piece)) return;
    piece.packed.clear();
    piece.bytes.resize(pieceSize);
    size_t size = 0;
    if (failure_.empty()) size = isGzip() ? readInflated(piece.bytes) : readPlain(piece.bytes);
    piece.bytes.resize(size);
    piece.compressedPosition = compressedPosition_;
    piece.failure = failure_;
}

size_t PieceReader::readPlain(std::span<unsigned char> to) {
    if (sniffed_ == 0) return readCompressed(to);
    std::copy_n(compressed_.begin(), sniffed_, to.begin());
    return std::exchange(sniffed_, 0);
}

size_t PieceReader::readCompressed(std::span<unsigned char> to) {
    size_t size = 0;
    do {
        std::clearerr(file_.get());  // the end of the file, where it ended before
        size = std::fread(to.data(), 1, to.size(), file_.get());
    } while (size == 0 && !std::ferror(file_.get()) && waitForMore_ && waitForMore_());
    compressedPosition_ += size;
    if (std::ferror(file_.get())) failure_ = fmt::format("read error: {}", std::strerror(errno));
    return size;
}

size_t PieceReader::readInflated(std::span<unsigned char> to) {
    inflate_state& state = *inflate_;
    size_t size = 0;
    while (failure_.empty() && size == 0) {
        if (!inMember_ && !beginMember()) break;
        state.next_out = to.data();
        state.avail_out = static_cast<uint32_t>(to.size());
        const int status = isal_inflate(&state);
        size = to.size() - state.avail_out;
        if (status != ISAL_DECOMP_OK) {
            failure_ = fmt::format("gzip: {}", inflateError(status));
        } else if (state.block_state == ISAL_BLOCK_FINISH) {
            inMember_ = firstMember_ = false;
        } else if (size == 0 && !haveInput()) {
            if (failure_.empty()) failure_ = "its gzip stream ends too early";
        }
    }
    return size;
}

bool PieceReader::haveInput() {
    inflate_state& state = *inflate_;
    if (state.avail_in > 0) return true;
    state.next_in = compressed_.data();
    state.avail_in = static_cast<uint32_t>(readCompressed(compressed_));
    return state.avail_in > 0;
}

/// False where the file ends, or something else than a member follows.
bool PieceReader::beginMember() {
    inflate_state& state = *inflate_;
    while (haveInput()) {
        // Some tapes and file systems pad with zeros; gzip allows it.
        if (!firstMember_ && *state.next_in == 0) {
            ++state.next_in, --state.avail_in;
            continue;
        }
        if (!firstMember_ && *state.next_in != 0x1f) {
            failure_ = "bytes that are not gzip follow the end of its gzip stream";
            return false;
        }
        isal_inflate_reset(&state);
        state.crc_flag = ISAL_GZIP;
        return inMember_ = true;
    }
    return false;
}

}  // namespace offmap::rawlog
