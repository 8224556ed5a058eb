// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseChoice.h>

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {

using mrpt::math::TPose2D;

inline mrpt::Clock::time_point second(double seconds) {
    return mrpt::Clock::fromDouble(1.7e9 + seconds);
}

/// Poses chosen from a log whose scans are of second(0) to second(2).
class PoseChoiceFixture : public testing::Test {
 protected:
    PoseChoiceFixture() {
        SensorSurvey& lidar = survey_.sensors["LIDAR"];
        lidar.scans3d = true;
        lidar.times = TimeSpan{second(0), second(2)};
    }

    void addRobotPoses(const std::string& label, double x = 10) {
        for (int i = 0; i < 3; ++i) {
            survey_.poses[label].push_back({second(i), {x + i, 0, 0, 0, 0, 0}, {}, {}});
        }
    }

    /// A metre a second.
    void addActions() {
        survey_.actions.movements = 2;
        survey_.actions.steps = {{second(0), {}, {}, {}},
                                 {second(1), {1, 0, 0, 0, 0, 0}, {}, {}},
                                 {second(2), {1, 0, 0, 0, 0, 0}, {}, {}}};
    }

    /// Two metres a second; readings begin anywhere, and are not sorted.
    void addOdometry(const std::string& label) {
        survey_.odometry[label] = {
            {second(2), {9, 5, 0}}, {second(0), {5, 5, 0}}, {second(1), {7, 5, 0}}};
    }

    ChosenPoses choose(const PoseRequest& request, bool mayBeMissing = false) const {
        return choosePoses(request, config_, survey_, "run7.rawlog", mayBeMissing);
    }

    /// Why the request is wrong.
    std::string refusalOf(const PoseRequest& request) const {
        try {
            choose(request);
        } catch (const PoseRequestError& e) {
            return e.what();
        } catch (const std::runtime_error& e) {
            return std::string("no pose: ") + e.what();
        }
        return "no error";
    }

    /// Why there is no pose, the request being right.
    std::string lackOf(const PoseRequest& request) const {
        const std::string error = refusalOf(request), prefix = "no pose: ";
        return error.starts_with(prefix) ? error.substr(prefix.size()) : "another error";
    }

    static PoseRequest labelled(const std::string& label,
                                std::optional<TPose2D> initial = std::nullopt) {
        PoseRequest request;
        request.label = label;
        request.initial = initial;
        return request;
    }

    static PoseRequest from(const TPose2D& initial) { return labelled("", initial); }

    static double xAt(const ChosenPoses& poses, double seconds) {
        const PoseLookup lookup = poses.source->at(second(seconds));
        return lookup.vehicleInMap ? lookup.vehicleInMap->x()
                                   : std::numeric_limits<double>::quiet_NaN();
    }

    LogSurvey survey_;
    Config config_;
};

}  // namespace offmap::rawlog
