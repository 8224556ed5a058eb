// SPDX-License-Identifier: BSD-3-Clause
#include "LiveCommand.h"

#include "../SummaryText.h"
#include "LiveCommandOptions.h"
#include "LiveText.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/Interruption.h"
#include "input/LiveInput.h"
#include "input/LiveRecorder.h"
#include "input/NamedFiles.h"
#include "input/UsageError.h"

#include <offmap/live/LiveReduction.h>
#include <offmap/rawlog/RegisterClasses.h>

#include <memory>
#include <unistd.h>
#include <utility>

namespace offmap::app {

namespace {

using Steady = std::chrono::steady_clock;

double secondsSince(Steady::time_point begin) {
    return std::chrono::duration<double>(Steady::now() - begin).count();
}

/// Once a second, on a terminal always in the same line.
class RunningLine {
 public:
    explicit RunningLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

    void tell(const live::LiveReduction& reduction, double seconds) {
        if (quiet_ || seconds < next_) return;
        next_ = seconds + 1;
        const std::string line = runningLineOf(reduction.figures(), seconds);
        say(stderr, "{}{}{}", terminal_ ? wiped : "", line, terminal_ ? "" : "\n");
    }
    void clear() const {
        if (terminal_ && next_ > 0) say(stderr, "{}", wiped);
    }

 private:
    static constexpr const char* wiped = "\r\x1b[K";

    bool quiet_, terminal_;
    double next_ = 0;  // [s]
};

/// Until the source ends, the time is over or somebody interrupts it.
void waitForEnd(const LiveCommandOptions& options, const live::LiveReduction& reduction) {
    const Interruption interruption;
    const auto begin = Steady::now();
    RunningLine line(options.quiet);
    while (!reduction.waitUntilFinished(std::chrono::milliseconds(50))) {
        const double seconds = secondsSince(begin);
        if (interruption.came() || (options.seconds && seconds >= *options.seconds)) break;
        line.tell(reduction, seconds);
    }
    line.clear();
}

LiveRequest requestOf(const LiveCommandOptions& options) {
    LiveRequest request;
    request.from = options.from;
    request.shared = options.shared;
    return request;
}

int run(const LiveCommandOptions& options) {
    const rawlog::Config config = options.shared.readConfig();
    options.from.speedFactor();  // what is wrong with it is told now
    requireDistinct({{"--record", options.record}},
                    {{"SOURCE", options.from.source}, {"--map", options.shared.map}});
    LoadedMap map = options.shared.readMap(config);
    for (const std::string& warning : map.warnings) say(stderr, "warning: {}\n", warning);
    rawlog::registerMrptClasses();
    LiveInput input = openLiveInput(requestOf(options), config);
    std::unique_ptr<LiveRecorder> recorder;
    if (!options.record.empty()) {
        recorder = std::make_unique<LiveRecorder>(options.record, options.force);
    }
    say(stdout, "source  {}\n{}poses   {}\n", input.description, summaryOf(map),
        input.posesDescription);

    const auto begin = Steady::now();
    live::LiveSetup setup{std::make_shared<core::LineMap>(std::move(map.lines)), input.poses,
                          config};
    const auto onFrame = [&](const live::LiveFramePtr& frame) {
        if (input.tracked && frame->reduced.vehicleInMap) {
            input.tracked->correct(*frame->reduced.vehicleInMap, frame->reduced.record.time);
        }
        if (recorder) recorder->add(*frame);
    };
    live::LiveReduction reduction(std::move(input.source), std::move(setup),
                                  {options.waiting, onFrame});
    waitForEnd(options, reduction);
    const double seconds = secondsSince(begin);
    reduction.stop();
    const live::LiveFigures figures = reduction.figures();
    say(stdout, "{}{}", summaryOf(figures.totals, seconds), liveSummaryOf(figures));
    if (recorder) {
        recorder->publish();
        say(stdout, "wrote   {} ({})\n", options.record.string(), sizeText(sizeOf(options.record)));
    }
    if (!input.warning.empty()) say(stderr, "warning: {}\n", input.warning);
    const std::string failure =
        figures.source.state == live::SourceState::Failed ? figures.source.message : "";
    for (const std::string& what : {failure, reduction.failure()}) {
        if (!what.empty()) throw std::runtime_error(what);
    }
    return exitDone;
}

}  // namespace

void addLive(CLI::App& command, int& exitCode) {
    const auto options = std::make_shared<LiveCommandOptions>();
    options->addTo(command);
    command.footer("Ctrl-C ends it; what was recorded is then complete.");
    command.callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace offmap::app
