// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Serialised.h>

#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CArchive.h>

#include <stdexcept>

namespace offmap::rawlog {
namespace {

/// Appends what is written to a vector; MRPT's memory stream gives its memory back when emptied.
class AppendingStream : public mrpt::io::CStream {
 public:
    explicit AppendingStream(std::vector<std::byte>& to) : to_(to) {}

    size_t Write(const void* from, size_t count) override {
        const auto* bytes = static_cast<const std::byte*>(from);
        to_.insert(to_.end(), bytes, bytes + count);
        return count;
    }
    size_t Read(void*, size_t) override { throw std::logic_error("AppendingStream cannot read"); }
    uint64_t Seek(int64_t, TSeekOrigin) override {
        throw std::logic_error("AppendingStream cannot seek");
    }
    uint64_t getTotalBytesCount() const override { return to_.size(); }
    uint64_t getPosition() const override { return to_.size(); }

 private:
    std::vector<std::byte>& to_;
};

}  // namespace

void serialise(const mrpt::serialization::CSerializable& object, std::vector<std::byte>& to) {
    AppendingStream stream(to);
    auto archive = mrpt::serialization::archiveFrom(static_cast<mrpt::io::CStream&>(stream));
    archive.WriteObject(object);
}

}  // namespace offmap::rawlog
