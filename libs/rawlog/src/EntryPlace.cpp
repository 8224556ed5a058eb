// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

namespace offmap::rawlog {
std::string unreadableEntry(const std::filesystem::path& file, const EntryPlace& place,
                            std::string_view reason) {
    return fmt::format(
        "{}: entry {} at byte {} cannot be read ({}); the file is truncated or corrupt",
        file.string(), grouped(place.index), grouped(place.offset), reason);
}

}  // namespace offmap::rawlog
