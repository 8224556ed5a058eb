// SPDX-License-Identifier: BSD-3-Clause
#include "MapCheckOptions.h"

#include "input/NamedFiles.h"
#include "input/NumberList.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <cmath>

namespace offmap::app {

namespace {

/// A check of CLI11. CLI::Range lets NaN pass.
CLI::Validator within(double low, double high) {
    return {[low, high](std::string& text) {
                double number = 0;
                const bool fits =
                    CLI::detail::lexical_cast(text, number) && number >= low && number <= high;
                return fits ? "" : fmt::format("{} is not from {} to {}", text, low, high);
            },
            ""};
}

}  // namespace

void MapCheckOptions::addTo(CLI::App& command) {
    command.add_option("LOG", logs, "Rawlogs of the building; they are only read")
        ->required()
        ->type_name("FILE");
    command.add_option("-o,--out", output, "How each wall stands to what is seen of it")
        ->required()
        ->type_name("F.csv")
        ->check(notEmpty);
    shared.addTo(command);
    command.add_option("--profile", profile, "The same along each wall, bin by bin")
        ->type_name("F.csv")
        ->check(notEmpty);
    command
        .add_option("--svg", picture,
                    "The plan with its walls coloured by how far they are off; PNG or SVG")
        ->type_name("F.svg|F.png")
        ->check(notEmpty);
    command.add_option("--bin", check.binLength, "Length of a bin along a wall (0.25)")
        ->check(within(0.02, 10))
        ->type_name("METRES");
    command.add_option("--gate", check.gate, "What is further off a wall is something else (0.35)")
        ->check(within(0.02, 2))
        ->type_name("METRES");
    command.add_flag("--json", json, "Tell the summary and all walls as JSON, on stdout");
    command.add_flag("--force", force, "Replace existing files");
}

void MapCheckOptions::requireFiles() const {
    std::vector<NamedFile> read{{"--map", shared.map},
                                {"--config", shared.config.file},
                                {"--trajectory", shared.poses.trajectory}};
    for (const auto& log : logs) read.emplace_back("LOG", log);
    requireDistinct({{"OUT", output}, {"--profile", profile}, {"--svg", picture}}, read);
    if (picture.empty() || picture.extension() == ".svg" || picture.extension() == ".png") return;
    throw UsageError(picture.string() +
                     ": the picture is an SVG or a PNG; name it so, .svg or .png");
}

}  // namespace offmap::app
