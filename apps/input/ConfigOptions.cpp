// SPDX-License-Identifier: BSD-3-Clause
#include "ConfigOptions.h"

#include "NumberList.h"
#include "Presets.h"
#include "UsageError.h"

#include <offmap/rawlog/ConfigFile.h>

namespace offmap::app {

void ConfigOptions::addTo(CLI::App& command) {
    command
        .add_option("--config", file,
                    "Parameters, or a preset's name; what is not set keeps its default")
        ->type_name("FILE.yaml|NAME")
        ->check(notEmpty);
    command.add_option("--set", settings, "One parameter, after --config; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void ConfigOptions::applyTo(rawlog::Config& config) const {
    try {
        if (!file.empty()) rawlog::applyYaml(config, configFile(file));
        for (const std::string& setting : settings) rawlog::applySetting(config, setting);
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
}

}  // namespace offmap::app
