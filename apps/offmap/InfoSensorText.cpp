// SPDX-License-Identifier: BSD-3-Clause
#include "InfoSensorText.h"

#include "PlainText.h"
#include "TextSections.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

using rawlog::grouped;
using rawlog::SensorInventory;

namespace {

std::string modelText(const rawlog::SensorModel& model) {
    std::vector<std::string> parts;
    if (!model.name.empty()) parts.push_back(printable(model.name));
    if (!model.details.empty()) parts.push_back(model.details);
    return parts.empty() ? "" : fmt::format(": {}", fmt::join(parts, ", "));
}

std::string headLine(const std::string& className, const SensorInventory& sensor) {
    return fmt::format("{} x {}{}{}", grouped(sensor.observations), className,
                       rateText(sensor.interval.rate()), modelText(sensor.model));
}

/// [deg] to 0.1, without a minus before nought.
double degrees(double radians) { return std::round(10 * mrpt::RAD2DEG(radians)) / 10 + 0.0; }

std::string mountingText(const SensorInventory& sensor) {
    const mrpt::poses::CPose3D& at = *sensor.mounting;
    return fmt::format(
        "{} x {:.2f}, y {:.2f}, z {:.2f} m, yaw {:.1f}, pitch {:.1f}, roll {:.1f} deg",
        sensor.mountingVaries ? "mounting varies, at first" : "mounted at", at.x(), at.y(), at.z(),
        degrees(at.yaw()), degrees(at.pitch()), degrees(at.roll()));
}

std::vector<std::string> scannerLines(const std::string& className, const SensorInventory& sensor) {
    std::vector<std::string> lines{headLine(className, sensor)};
    if (sensor.scans > 0) {
        const double points =
            static_cast<double>(sensor.counts.returns) / static_cast<double>(sensor.scans);
        const double upright = static_cast<double>(sensor.onVerticalSegments) /
                               static_cast<double>(std::max<uint64_t>(sensor.counts.returns, 1));
        lines.push_back(fmt::format("{} of {} points{}, {:.0f} % of them on vertical segments",
                                    counted(sensor.scans, "scan"),
                                    grouped(static_cast<uint64_t>(std::lround(points))),
                                    sensor.scans == 1 ? "" : " on average", 100 * upright));
    }
    lines.push_back(mountingText(sensor));
    if (sensor.external > 0) {
        lines.push_back(fmt::format("{} stored in files of their own, {} of which cannot be read",
                                    grouped(sensor.external), grouped(sensor.externalMissing)));
    }
    for (const auto& [reason, count] : sensor.notReducible) {
        const auto why =
            wrapped(fmt::format("{} cannot be reduced: {}", grouped(count), printable(reason)), 2);
        lines.insert(lines.end(), why.begin(), why.end());
    }
    return lines;
}

}  // namespace

std::string scannerSection(const rawlog::LogInventory& inventory) {
    std::vector<Row> rows;
    for (const auto& [name, sensor] : inventory.sensors()) {
        if (sensor.scans3d)
            rows.emplace_back(nameOf(name.first), scannerLines(name.second, sensor));
    }
    return rows.empty() ? section("3D scans", {"none"}) : table("3D scans", rows);
}

std::string othersSection(const rawlog::LogInventory& inventory) {
    std::vector<Row> rows;
    for (const auto& [name, sensor] : inventory.sensors()) {
        if (!sensor.scans3d && name.second != "CObservationRobotPose") {
            rows.push_back({nameOf(name.first), {headLine(name.second, sensor)}});
        }
    }
    for (const auto& [className, count] : inventory.entries().actions) {
        rows.push_back({"(action)", {fmt::format("{} x {}", grouped(count), className)}});
    }
    return table("others", rows);
}

}  // namespace offmap::app
