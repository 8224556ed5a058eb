// SPDX-License-Identifier: BSD-3-Clause
#include "LiveEntries.h"

#include "input/NumberList.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <filesystem>

namespace offmap::window {

namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

void requireFile(const std::string& file) {
    std::error_code ignored;
    if (file.empty()) throw app::UsageError("There is no file named yet");
    if (fs::is_regular_file(file, ignored)) return;
    throw app::UsageError(fs::exists(file, ignored)
                              ? fmt::format("{} is not a file", file)
                              : fmt::format("{} is not there; mind its spelling and folder", file));
}

/// What a source is, its name tells.
void requireKind(const LiveEntries& entries, const app::SourceOptions& from) {
    const bool isIni = fs::path(from.source).extension() == ".ini";
    if (entries.kind == LiveKind::Sensors && !isIni) {
        throw app::UsageError(
            fmt::format("{}: a file of sensors has a name that ends in .ini", from.source));
    }
    if (entries.kind == LiveKind::Capture && !from.isCapture()) {
        throw app::UsageError(
            fmt::format("{}: a capture has a name that ends in .pcap or .pcapng", from.source));
    }
    if (entries.kind == LiveKind::GrowingLog && (isIni || from.isCapture())) {
        throw app::UsageError(fmt::format("{} is not a rawlog", from.source));
    }
}

app::SourceOptions sourceOf(const LiveEntries& entries) {
    app::SourceOptions from;
    if (hasFile(entries.kind)) {
        from.source = trimmed(entries.file);
        requireFile(from.source);
        requireKind(entries, from);
    } else {
        from.source = "udp:" + trimmed(entries.port);
        from.udpPort();  // throws for a port that is none
    }
    from.follow = entries.kind == LiveKind::GrowingLog;
    if (!hasLabel(entries.kind)) return from;
    from.label = trimmed(entries.label);
    if (from.label.empty()) throw app::UsageError("The scans need a sensor label");
    return from;
}

std::string poseOf(const LiveEntries& entries) {
    const std::string x = trimmed(entries.x), y = trimmed(entries.y), yaw = trimmed(entries.yaw);
    app::parseNumbers(x, "x", "in metres");
    app::parseNumbers(y, "y", "in metres");
    app::parseNumbers(yaw, "The yaw", "in degrees");
    return fmt::format("{},{},{}", x, y, yaw);
}

}  // namespace

bool hasFile(LiveKind kind) { return kind != LiveKind::Network; }

bool hasLabel(LiveKind kind) { return kind == LiveKind::Network || kind == LiveKind::Capture; }

bool mayTellPoses(LiveKind kind) {
    return kind == LiveKind::Sensors || kind == LiveKind::GrowingLog;
}

LiveChoice liveChoiceOf(const LiveEntries& entries) {
    LiveChoice choice;
    choice.from = sourceOf(entries);
    if (entries.poses == LivePoseKind::FromSource) {
        if (mayTellPoses(entries.kind)) return choice;
        throw app::UsageError(
            "A Velodyne tells no poses: say where the robot stands, or where it begins to move");
    }
    (entries.poses == LivePoseKind::Fixed ? choice.poses.fixed : choice.from.track) =
        poseOf(entries);
    return choice;
}

}  // namespace offmap::window
