// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedLogs.h"

#include "input/Console.h"
#include "input/Guarded.h"
#include "input/Handover.h"
#include "input/UsageError.h"

#include <offmap/rawlog/EntryPlace.h>

#include <cstdint>
#include <cstring>
#include <span>

namespace offmap::app {

int workOnLogs(const std::vector<std::filesystem::path>& logs,
               const std::function<int(rawlog::GuardedStatus&, const AtLog&)>& work) {
    using Kind = rawlog::GuardedOutcome::Kind;
    Handover handover;
    const AtLog atLog = [&](size_t log) {
        uint8_t bytes[sizeof log];
        std::memcpy(bytes, &log, sizeof log);
        handover.put(bytes);
    };
    const rawlog::GuardedOutcome outcome =
        reportingErrorsGuarded([&](rawlog::GuardedStatus& status) { return work(status, atLog); });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    size_t log = 0;
    const std::span<const uint8_t> told = handover.content();
    if (told.size() == sizeof log) std::memcpy(&log, told.data(), sizeof log);
    say(stderr, "offmap: {}\n",
        rawlog::unreadableEntry(logs.at(log), outcome.place.value_or(rawlog::EntryPlace{}),
                                outcome.cause));
    return exitFailed;
}

}  // namespace offmap::app
