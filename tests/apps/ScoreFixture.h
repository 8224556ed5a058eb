// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFixture.h"

#include <offmap/evaluation/TruthFile.h>
#include <offmap/rawlog/DecodedPoints.h>
#include <offmap/rawlog/ScanClasses.h>

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <set>
#include <utility>

namespace offmap::test {

/// A log, its truth as a test decides it, and the score of what became of the log.
class ScoreFixture : public ReduceFixture {
 protected:
    using Truth = std::vector<evaluation::ObservationTruth>;

    static std::vector<mrpt::math::TPoint3Df> pointsOf(const mrpt::obs::CObservation& obs) {
        rawlog::SensorConfig config;
        for (const double degrees : rotatingElevations()) {
            config.elevations.push_back(mrpt::DEG2RAD(degrees));
        }
        const auto* scanClass = rawlog::scanClassOf(obs, config);
        if (!scanClass) return {};
        return rawlog::decodedPoints(obs, *scanClass, config);
    }

    /// One scan an observation. \param isMapped by the number of the point in the whole log
    static Truth truthOf(const Path& log, const std::function<bool(size_t)>& isMapped) {
        Truth truth;
        size_t i = 0;
        for (const auto& obs : observationsOf(log)) {
            truth.push_back({truth.size(), obs->timestamp, obs->sensorLabel, {}});
            for (const auto& point : pointsOf(*obs)) {
                evaluation::TruePoint one{point, isMapped(i++)};
                if (!one.mapped) one.standOff = 0.1F;
                one.onVerticalSegment = i % 3 == 0;
                truth.back().points.push_back(one);
            }
        }
        return truth;
    }

    void writeTruth(const Truth& truth) const {
        std::string text;
        evaluation::TruthWriter writer([&](std::string_view piece) { text += piece; });
        for (const auto& observation : truth) writer.add(observation);
        writeFile(truth_, text);
    }

    Arguments scoreArguments(const Path& log, const Arguments& more = {}) const {
        Arguments all{"score", truth_, log};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    /// The score as JSON.
    nlohmann::json scoreOf(const Path& log, const Arguments& more = {}) const {
        Arguments arguments = scoreArguments(log, {"--json", json_, "--force"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = runOffmap(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return run.exitCode == 0 ? nlohmann::json::parse(readFile(json_)) : nlohmann::json();
    }

    Path truth_ = folder_ / "truth.csv";
    Path json_ = folder_ / "score.json";
    Path removed_ = folder_ / "removed.rawlog";
};

}  // namespace offmap::test
