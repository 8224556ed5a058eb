// SPDX-License-Identifier: BSD-3-Clause
#include "MapOutput.h"

#include "input/Console.h"
#include "input/Guarded.h"
#include "input/NamedFiles.h"
#include "input/NumberList.h"
#include "input/UsageError.h"

#include <offmap/maps/LowerCase.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::app {

void MapOutput::addTo(CLI::App& command, const char* what, const char* typeName) {
    command.add_option("-o,--out", file, what)->required()->type_name(typeName)->check(notEmpty);
    command.add_flag("--force", force, "Replace an existing file");
}

std::string MapOutput::extension() const { return maps::lowerCase(file.extension().string()); }

int writeFromMap(const MapSource& source, const MapOutput& output,
                 const std::function<void(const maps::MapOfFile&, rawlog::OutputOptions)>& work) {
    using Kind = rawlog::GuardedOutcome::Kind;
    std::vector<std::filesystem::path> written{output.file};
    written.insert(written.end(), output.companions.begin(), output.companions.end());
    std::vector<NamedFile> named{{"MAP", source.file}};
    for (const auto& file : written) named.emplace_back("OUT", file);
    requireDistinct(named, {{"--config", source.config.file}});
    for (const auto& file : written) {
        if (output.force || !std::filesystem::exists(file)) continue;
        throw std::runtime_error(file.string() + " exists already; --force replaces it");
    }
    const maps::MapOfFile map = source.read();
    for (const std::string& warning : map.warnings) say(stderr, "warning: {}\n", warning);
    const auto outcome = reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
        work(map, {std::nullopt, output.force, &status});
        return static_cast<int>(exitDone);
    });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    say(stderr, "offmap: {}: it could not be made: {}\n", output.file.string(), outcome.cause);
    return exitFailed;
}

}  // namespace offmap::app
