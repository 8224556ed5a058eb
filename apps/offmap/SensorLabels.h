// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::app {

/// \throw UsageError naming those there are, if the log holds no 3D scan of this label that could
/// be reduced
void requireScansOf(const std::string& label, const rawlog::LogSurvey& survey,
                    const std::filesystem::path& log);

/// Looks whether what is set for single sensors can be meant.
/// \return warnings: settings of sensors that the log holds no 3D scan of
/// \throw UsageError if such a sensor is given a pose, or one whose pose differs in each scan
std::vector<std::string> checkSingleSensors(const rawlog::Config& config,
                                            const rawlog::LogSurvey& survey,
                                            const std::filesystem::path& log);

}  // namespace offmap::app
