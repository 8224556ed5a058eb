// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SimulatedRobot.h"

#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offmap::test {

using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

/// \param gzipLevel none: not compressed
template <class Pointers>
void writeLog(const std::filesystem::path& file, const Pointers& objects,
              std::optional<int> gzipLevel = 1) {
    rawlog::RawlogWriter writer(file, {gzipLevel, true});
    for (const auto& object : objects) writer.write(*object);
    writer.publish();
}

/// A second at which all sensors of the robot record, odd entries in between.
inline Observations oneSecondOf(SimulatedRobot& robot) {
    Observations log{robot.localisation(), robot.odometry()};
    robot.wait(0.05);
    log.insert(log.end(), {robot.vlp16(), robot.imu(), robot.horizontalScan(), robot.cloud()});
    const Observations fans = robot.sweep();
    log.insert(log.end(), fans.begin(), fans.begin() + 40);
    log.insert(log.end(), {robot.imu(), robot.localisation()});
    log.insert(log.end(), fans.begin() + 40, fans.end());
    robot.wait(0.15);
    return log;
}

inline Observations secondsOf(SimulatedRobot& robot, int seconds) {
    Observations log{robot.comment("recorded in the office")};
    for (int second = 0; second < seconds; ++second) {
        const Observations more = oneSecondOf(robot);
        log.insert(log.end(), more.begin(), more.end());
    }
    log.push_back(robot.localisation());
    return log;
}

/// The same observations in the action/sensory-frame format. Comments stay entries of their own.
inline Objects inFrames(const Observations& observations, size_t perFrame = 4) {
    Objects entries;
    mrpt::obs::CSensoryFrame::Ptr frame;
    for (const auto& obs : observations) {
        if (dynamic_cast<const mrpt::obs::CObservationComment*>(obs.get())) {
            entries.push_back(obs);
            continue;
        }
        if (!frame || frame->size() == perFrame) {
            mrpt::obs::CActionRobotMovement2D action;
            action.timestamp = obs->timestamp;
            action.computeFromOdometry(mrpt::poses::CPose2D(0.01, 0, 0), {});
            auto actions = mrpt::obs::CActionCollection::Create();
            actions->insert(action);
            frame = mrpt::obs::CSensoryFrame::Create();
            entries.insert(entries.end(), {actions, frame});
        }
        frame->push_back(obs);
    }
    return entries;
}

struct LogEntry {
    std::string bytes;  ///< as they stand in the uncompressed stream
    mrpt::serialization::CSerializable::Ptr object;
};

inline std::vector<LogEntry> entriesOf(const std::filesystem::path& file) {
    std::vector<LogEntry> entries;
    rawlog::RawlogReader reader(file);
    while (const auto entry = reader.next()) {
        const auto* begin = reinterpret_cast<const char*>(entry->bytes.data());
        entries.push_back({{begin, entry->bytes.size()}, entry->object});
    }
    return entries;
}

/// The observation that the entry is, or those of the frame that it is.
inline Observations observationsOf(const LogEntry& entry) {
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry.object)) {
        return {frame->begin(), frame->end()};
    }
    if (const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry.object)) {
        return {obs};
    }
    return {};
}

inline Observations observationsOf(const std::filesystem::path& file) {
    Observations all;
    for (const LogEntry& entry : entriesOf(file)) {
        for (const auto& obs : observationsOf(entry)) all.push_back(obs);
    }
    return all;
}

}  // namespace offmap::test
