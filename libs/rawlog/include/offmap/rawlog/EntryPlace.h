// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace offmap::rawlog {

/// Where an entry stands in a rawlog.
struct EntryPlace {
    uint64_t index = 0;   ///< counted from 0
    uint64_t offset = 0;  ///< [byte] of its beginning in the uncompressed stream

    friend bool operator==(const EntryPlace&, const EntryPlace&) = default;
};

/// "x.rawlog: entry 412 at byte 1,234,567 cannot be read (<reason>); the file is truncated or
/// corrupt"
std::string unreadableEntry(const std::filesystem::path& file, const EntryPlace& place,
                            std::string_view reason);

}  // namespace offmap::rawlog
