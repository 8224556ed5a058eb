// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/PoseOptions.h"
#include "input/SourceOptions.h"

#include <cstdint>
#include <string>

namespace offmap::window {

enum class LiveKind : uint8_t {
    Network,     ///< a Velodyne that sends to a UDP port
    Sensors,     ///< an INI file as rawlog-grabber takes it
    Capture,     ///< packets of a Velodyne in a file
    GrowingLog,  ///< a rawlog while it is written
};

enum class LivePoseKind : uint8_t {
    FromSource,  ///< only where the source is a log or an INI file
    Fixed,       ///< the robot stands
    Tracked,     ///< the robot moves from there, and its scans tell where to
};

/// What a user enters to watch something live, as text.
struct LiveEntries {
    LiveKind kind = LiveKind::Network;
    std::string port = "2368";
    std::string file;  ///< of all but Network
    std::string label = "VELODYNE";
    LivePoseKind poses = LivePoseKind::Tracked;
    std::string x = "0", y = "0", yaw = "0";  ///< [m], [m], [deg]
};

bool hasFile(LiveKind kind);
/// Whether the scans get the label that is entered; those of others have their own.
bool hasLabel(LiveKind kind);
bool mayTellPoses(LiveKind kind);

/// As the command line would say it.
struct LiveChoice {
    app::SourceOptions from;
    app::PoseOptions poses;
};

/// \throw app::UsageError saying what is wrong with which entry
LiveChoice liveChoiceOf(const LiveEntries& entries);

}  // namespace offmap::window
