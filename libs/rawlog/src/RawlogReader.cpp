// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RegisterClasses.h>
#include <offmap/rawlog/ShortReason.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <utility>

namespace offmap::rawlog {
namespace {

InputFile opened(const std::filesystem::path& file, InputFile::WaitForMore waitForMore,
                 Reading reading) {
    try {
        return InputFile(file, std::move(waitForMore), reading);
    } catch (const std::runtime_error& e) {
        throw RawlogError(e.what(), {});
    }
}

// An object begins with the length of its class name, the highest bit set, and the name; before
// MRPT 0.5.5 with the length as 32 bits.
bool beginsLikeAnObject(std::span<const std::byte> bytes) {
    if (bytes.size() < 5) return false;
    const auto byte = [&](size_t i) { return std::to_integer<unsigned char>(bytes[i]); };
    const bool isOld = byte(0) < 0x80;
    if (isOld && (byte(1) != 0 || byte(2) != 0 || byte(3) != 0)) return false;
    const size_t begin = isOld ? 4 : 1;
    const size_t end = std::min<size_t>(bytes.size(), begin + (byte(0) & 0x7f));
    for (size_t i = begin; i < end; ++i) {
        const bool isNameLetter = std::isalnum(byte(i)) || std::strchr("_:<>,", byte(i));
        if (!isNameLetter) return false;
    }
    return end > begin;
}

bool belongsInRawlog(const mrpt::serialization::CSerializable* object) {
    return !object || dynamic_cast<const mrpt::obs::CObservation*>(object) ||
           dynamic_cast<const mrpt::obs::CActionCollection*>(object) ||
           dynamic_cast<const mrpt::obs::CSensoryFrame*>(object);
}

}  // namespace

RawlogReader::RawlogReader(const std::filesystem::path& file, InputFile::WaitForMore waitForMore,
                           Reading reading)
    : file_(file),
      input_(opened(file, std::move(waitForMore), reading)),
      stream_(input_),
      archive_(
          mrpt::serialization::archiveUniquePtrFrom(static_cast<mrpt::io::CStream&>(stream_))) {
    registerMrptClasses();
    if (!input_.atEnd()) return;
    if (!input_.failure().empty()) fail(input_.failure());
    throw RawlogError(file_.string() + " is empty: it holds no entry; check how it was recorded",
                      place_);
}

std::optional<RawlogEntry> RawlogReader::next() {
    stream_.beginRecord();
    if (input_.atEnd()) {
        if (!input_.failure().empty()) fail(input_.failure());
        return std::nullopt;
    }
    const EntryPlace begin = place_;
    RawlogEntry entry{begin, {}, readObject()};
    entry.bytes = stream_.record();
    place_ = {begin.index + 1, input_.position()};
    return entry;
}

mrpt::serialization::CSerializable::Ptr RawlogReader::readObject() {
    mrpt::serialization::CSerializable::Ptr object;
    try {
        object = archive_->ReadObject();
    } catch (const std::exception& e) {
        if (!input_.failure().empty()) fail(input_.failure());
        if (place_.index == 0 && !beginsLikeAnObject(stream_.record())) {
            throw RawlogError(file_.string() +
                                  " is not a rawlog: it does not begin with an MRPT "
                                  "object; name a .rawlog file",
                              place_);
        }
        fail(stream_.cameShort() ? "the file ends inside it" : shortReason(e));
    }
    if (place_.index == 0 && !belongsInRawlog(object.get())) {
        throw RawlogError(file_.string() + " is not a rawlog: it holds a " + classNameOf(*object) +
                              "; name a .rawlog file",
                          place_);
    }
    return object;
}

void RawlogReader::fail(const std::string& reason) const {
    throw RawlogError(unreadableEntry(file_, place_, reason), place_);
}

}  // namespace offmap::rawlog
