// SPDX-License-Identifier: BSD-3-Clause
#include "LogCheck.h"

#include "BytesFromChild.h"

#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>

#include <limits>

namespace offmap::app {

void requireReadable(const std::filesystem::path& log, const rawlog::Config& config) {
    constexpr size_t message = 1 << 16;  // [byte] more than any
    bytesFromChild(
        message,
        [&](rawlog::GuardedStatus& status) -> Bytes {
            rawlog::RawlogReader reader(log);
            const auto survey =
                rawlog::surveyLog(reader, config, std::numeric_limits<uint64_t>::max(),
                                  [&] { status.atEntry(reader.place()); });
            if (survey.damage && survey.entries == 0) throw *survey.damage;
            return {};
        },
        [&](const rawlog::GuardedOutcome& outcome) {
            return rawlog::unreadableEntry(log, outcome.place.value_or(rawlog::EntryPlace{}),
                                           outcome.cause);
        });
}

}  // namespace offmap::app
