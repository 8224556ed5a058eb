// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceGuarded.h"

#include "input/Handover.h"
#include "input/Progress.h"
#include "input/UsageError.h"

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/ReportFile.h>

#include <nlohmann/json.hpp>

#include <malloc.h>

namespace offmap::app {

using nlohmann::ordered_json;

namespace {

/// [byte] of address space: a stack, an arena of malloc, two large scans on their way.
constexpr uint64_t perThread = uint64_t{256} << 20;

ordered_json toJson(const ReducedLog& log) {
    return {{"totals", rawlog::toJson(log.totals)},
            {"reduce_ms_bins", log.totals.milliseconds.bins()},
            {"warnings", log.warnings},
            {"seconds", log.seconds}};
}

ReducedLog reducedLogFrom(const ordered_json& json) {
    ReducedLog log;
    log.totals = rawlog::totalsFrom(json.at("totals"));
    log.totals.milliseconds =
        rawlog::DurationHistogram(json.at("reduce_ms_bins").get<std::vector<uint64_t>>());
    log.warnings = json.at("warnings").get<std::vector<std::string>>();
    log.seconds = json.at("seconds");
    return log;
}

/// Large scans come and go: the kernel would clear their pages anew for each. Until the child ends,
/// what one has left is there for the next.
void keepFreedMemory() {
    constexpr int scansAtMost = 64 << 20;  // [byte] beyond which memory is given back at once
    mallopt(M_MMAP_THRESHOLD, scansAtMost / 2);
    mallopt(M_TRIM_THRESHOLD, scansAtMost);
}

/// In the child. MessagePack takes strings of any bytes: file names and labels may hold them.
int reduceAndHandOver(const ReduceJob& job, const LogToReduce& log, const ReadableLog& readable,
                      rawlog::GuardedStatus& status, Handover& handover) {
    keepFreedMemory();
    ordered_json result;
    int exitCode = exitDone;
    try {
        result = toJson(reduceLog(job, log, readable, status));
    } catch (const UsageError& error) {
        result["error"] = error.what();
        exitCode = exitUsage;
    } catch (const std::exception& error) {
        result["error"] = error.what();
        exitCode = exitFailed;
    }
    handover.put(ordered_json::to_msgpack(result));
    return exitCode;
}

bool completelyReduced(const rawlog::ReductionTotals& totals) {
    return totals.scansNotReduced() == 0 && totals.observationsNotSupported() == 0 &&
           totals.columnsWithoutPose == 0 && totals.scans > 0;
}

LogOutcome reduceReadable(const ReduceJob& job, const LogToReduce& log,
                          const ReadableLog& readable) {
    using Kind = rawlog::GuardedOutcome::Kind;
    Handover handover;
    LogOutcome out;
    rawlog::GuardedOptions limits;
    limits.memory += perThread * job.options.threadCount();
    out.guarded = rawlog::runGuarded(
        [&](rawlog::GuardedStatus& status) {
            return reduceAndHandOver(job, log, readable, status, handover);
        },
        limits);
    if (out.guarded.kind == Kind::Finished) {
        const ordered_json result = ordered_json::from_msgpack(handover.content());
        out.exitCode = out.guarded.exitCode;
        if (out.exitCode != exitDone) {
            out.error = result.at("error");
            return out;
        }
        out.reduced = reducedLogFrom(result);
        if (job.options.strict && !completelyReduced(out.reduced->totals)) {
            out.exitCode = exitNotReduced;
        }
        return out;
    }
    Progress::clearLeftover();
    out.exitCode = exitFailed;
    if (out.guarded.kind == Kind::Interrupted) return out;
    const auto place = out.guarded.place.value_or(rawlog::EntryPlace{});
    out.error = rawlog::unreadableEntry(log.files.input, place, out.guarded.cause);
    if (place.index == 0) return out;
    const bool anew = job.options.keepGoing && place.index < readable.entries;
    if (anew) return reduceReadable(job, log, {place.index, out.error});
    if (!job.options.keepGoing) out.error += "; --keep-going writes what stands before it";
    return out;
}

}  // namespace

LogOutcome reduceGuarded(const ReduceJob& job, const LogToReduce& log) {
    return reduceReadable(job, log, {});
}

}  // namespace offmap::app
