// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateCommand.h"

#include "SimulateSummary.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/Progress.h"
#include "input/UsageError.h"

#include <fmt/format.h>
#include <mrpt/obs/CObservationComment.h>

#include <memory>
#include <stdexcept>
#include <system_error>

namespace offmap::app {

namespace fs = std::filesystem;

namespace {

/// A folder that goes again if it was made for outputs that did not appear.
class OutputFolder {
 public:
    /// \throw UsageError if it is a file, std::runtime_error if it cannot be made
    explicit OutputFolder(const fs::path& named)
        : folder_(named.has_filename() ? named : named.parent_path()) {
        std::error_code error;
        if (fs::exists(folder_, error) && !fs::is_directory(folder_, error)) {
            throw UsageError(fmt::format(
                "OUT {} is a file, but a folder is needed: a simulation has several files",
                folder_.string()));
        }
        isNew_ = fs::create_directories(folder_, error);
        if (!error) return;
        throw std::runtime_error(
            fmt::format("cannot create the folder {}: {}; name another with -o", folder_.string(),
                        error.message()));
    }
    ~OutputFolder() {
        std::error_code notEmpty;
        if (isNew_) fs::remove(folder_, notEmpty);
    }
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const fs::path& path() const { return folder_; }

 private:
    fs::path folder_;
    bool isNew_ = false;
};

mrpt::obs::CObservationComment commentOf(const SimulateOptions& options) {
    mrpt::obs::CObservationComment comment;
    comment.timestamp = mrpt::Clock::fromDouble(1.7e9);
    comment.text = fmt::format("simulated by offmap: world {}, class {}, seed {}", options.world,
                               options.scanClass, options.seed);
    return comment;
}

int simulate(const SimulateOptions& options, const SimulatedFiles& files,
             const SimulationPlan& plan, rawlog::GuardedStatus& status) {
    SimulateOutputs outputs(files, options.force, status);
    outputs.writeMaps(plan.map);
    outputs.writeConfig(sensorConfigOf(plan.sensor));
    outputs.add(commentOf(options));
    TruthCounts counts;
    Progress progress(options.quiet);
    for (size_t place = 0; place < plan.places.size(); ++place) {
        const LoggedTurn turn = simulateTurn(plan, place);
        outputs.add(turn);
        counts.add(turn);
        const auto done = static_cast<double>(place + 1);
        progress.tell(done / static_cast<double>(plan.places.size()), place + 1,
                      done * plan.sensor.scanner.turnDuration);
    }
    outputs.publish();
    progress.clear();
    if (!options.quiet) {
        say(stdout, "{}{}", summaryOf(plan, options, counts), nextStepsOf(files, options));
    }
    return exitDone;
}

int simulateGuarded(const SimulateOptions& options) {
    using Kind = rawlog::GuardedOutcome::Kind;
    const SimulationPlan plan = planOf(options);
    const bool needsElevations =
        options.scanClass == "rotating" && !sensorConfigOf(plan.sensor).elevations.empty();
    const OutputFolder folder(options.folder);
    const SimulatedFiles files = filesIn(folder.path(), needsElevations);
    const auto outcome = reportingErrorsGuarded(
        [&](rawlog::GuardedStatus& status) { return simulate(options, files, plan, status); });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    say(stderr, "offmap: the simulation ended early: {}; nothing was written\n", outcome.cause);
    return exitFailed;
}

}  // namespace

void addSimulateCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand(
        "simulate", "Write a log of a simulated robot, its map and the truth about every return");
    const auto options = std::make_shared<SimulateOptions>();
    options->addTo(command);
    command.footer(
        "Writes scans.rawlog, map.lines, map.gridmap.gz and truth.csv.gz into FOLDER; the same "
        "options give the same bytes");
    command.callback([options, &exitCode] { exitCode = simulateGuarded(*options); });
}

}  // namespace offmap::app
