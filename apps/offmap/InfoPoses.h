// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/SharedOptions.h"

#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/PoseChoice.h>
#include <offmap/rawlog/PoseCoverage.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// One source of poses that a log has, or that the command line gives.
struct PoseSourceFacts {
    rawlog::PoseOrigin origin = rawlog::PoseOrigin::None;
    std::string label;    ///< of robot poses or odometry
    uint64_t count = 0;   ///< poses, movements or readings
    uint64_t faulty = 0;  ///< of those: not finite, or with a covariance that is none
    std::optional<rawlog::TimeSpan> times;
    std::optional<double> rate;           ///< [Hz]
    std::optional<double> sigmaPosition;  ///< [m] median of what they state
    std::optional<double> sigmaHeading;   ///< [rad] likewise

    std::unique_ptr<rawlog::PoseSource> poses;       ///< null: they cannot be chosen
    std::unique_ptr<rawlog::PoseCoverage> coverage;  ///< null where `poses` is
};

/// Which poses there are, which ones reduction would take, and what it lacks to take them.
struct PoseFacts {
    std::vector<PoseSourceFacts> sources;
    std::optional<size_t> chosen;  ///< among `sources`
    bool labelMissing = false;     ///< several that --pose-label has to choose from
    bool initialMissing = false;   ///< movements, but not where they began: --initial-pose

    const PoseSourceFacts* chosenSource() const { return chosen ? &sources[*chosen] : nullptr; }

    /// Of robot poses with several labels, takes those that cover most; to be called when the
    /// coverage is known.
    void chooseBest();
};

/// \throw UsageError if the options ask for poses that there are not
PoseFacts findPoses(const SharedOptions& options, const rawlog::Config& config,
                    const std::filesystem::path& log, const rawlog::LogSurvey& survey);

}  // namespace offmap::app
