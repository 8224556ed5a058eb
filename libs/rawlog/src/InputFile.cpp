// SPDX-License-Identifier: BSD-3-Clause
#include "PieceReader.h"
#include "ReadAhead.h"

#include <offmap/rawlog/InputFile.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace offmap::rawlog {

InputFile::InputFile(const std::filesystem::path& file, WaitForMore waitForMore, Reading reading)
    : reader_(std::make_unique<PieceReader>(file, std::move(waitForMore), reading.times)),
      piece_(std::make_unique<FilePiece>()) {
    if (reading.ahead) ahead_ = std::make_unique<ReadAhead>(*reader_);
}

InputFile::~InputFile() = default;

size_t InputFile::read(void* to, size_t count) {
    auto* out = static_cast<unsigned char*>(to);
    size_t size = 0;
    while (size < count && !atEnd()) {
        const size_t part = std::min(count - size, piece_->bytes.size() - done_);
        std::memcpy(out + size, piece_->bytes.data() + done_, part);
        done_ += part;
        size += part;
    }
    position_ += size;
    return size;
}

bool InputFile::atEnd() { return done_ == piece_->bytes.size() && !fill(); }

bool InputFile::fill() {
    if (!piece_->failure.empty()) return false;
    ahead_ ? ahead_->take(*piece_) : reader_->read(*piece_);
    done_ = 0;
    return !piece_->bytes.empty();
}

const std::string& InputFile::failure() const { return piece_->failure; }
bool InputFile::isGzip() const { return reader_->isGzip(); }
uint64_t InputFile::compressedPosition() const { return piece_->compressedPosition; }
uint64_t InputFile::compressedSize() const { return reader_->compressedSize(); }

}  // namespace offmap::rawlog
