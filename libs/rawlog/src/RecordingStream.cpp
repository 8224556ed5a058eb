// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RecordingStream.h>

#include <stdexcept>

namespace offmap::rawlog {

void RecordingStream::beginRecord() {
    record_.clear();
    cameShort_ = false;
}

size_t RecordingStream::Read(void* to, size_t count) {
    const size_t size = input_.read(to, count);
    const auto* bytes = static_cast<const std::byte*>(to);
    record_.insert(record_.end(), bytes, bytes + size);
    cameShort_ = cameShort_ || size < count;
    return size;
}

size_t RecordingStream::Write(const void*, size_t) {
    throw std::logic_error("RecordingStream cannot be written to");
}

uint64_t RecordingStream::Seek(int64_t, TSeekOrigin) {
    throw std::logic_error("RecordingStream cannot seek");
}

uint64_t RecordingStream::getTotalBytesCount() const {
    throw std::logic_error("RecordingStream does not know its size");
}

}  // namespace offmap::rawlog
