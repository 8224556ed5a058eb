// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedMap.h"

#include "BytesFromChild.h"
#include "PackedMap.h"

#include <fmt/format.h>

namespace offmap::app {

namespace {

/// Maps of some 30 million walls; larger ones are no plans.
constexpr size_t capacity = size_t{1} << 31;  // [byte]

}  // namespace

maps::MapOfFile readMapGuarded(const std::filesystem::path& file, const maps::MapOptions& options) {
    return unpacked(bytesFromChild(
        capacity, [&](rawlog::GuardedStatus&) { return packed(maps::readMap(file, options)); },
        [&](const rawlog::GuardedOutcome& outcome) {
            return fmt::format("{}: the map cannot be read: {}; is the file damaged?",
                               file.string(), outcome.cause);
        }));
}

}  // namespace offmap::app
