// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

namespace {

void see(LogSurvey& survey, const Config& config, const CObservation& obs) {
    if (const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&obs)) {
        survey.poses[obs.sensorLabel].push_back(stampedPose(*pose));
        return;
    }
    SensorSurvey& sensor = survey.sensors[obs.sensorLabel];
    if (sensor.observations++ == 0) sensor.className = classNameOf(obs);
    if (const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&obs)) {
        sensor.sweep.see(*scan);
    } else if (!sensor.scans3d) {
        sensor.scans3d = scanClassOf(obs, config.sensorOf(obs.sensorLabel)) != nullptr;
    }
}

}  // namespace

bool LogSurvey::holdsScans() const {
    return std::ranges::any_of(sensors, [](const auto& sensor) { return sensor.second.scans3d; });
}

bool LogSurvey::reducible(const CObservation& obs, const SensorConfig& config) const {
    if (!scanClassOf(obs, config)) return false;
    if (!dynamic_cast<const CObservation2DRangeScan*>(&obs)) return true;
    const auto sensor = sensors.find(obs.sensorLabel);
    return sensor != sensors.end() && sensor->second.sweep.isSweep();
}

LogSurvey surveyLog(RawlogReader& reader, const Config& config, uint64_t maxEntries,
                    const std::function<void()>& onEntry) {
    LogSurvey survey;
    try {
        while (survey.entries < maxEntries) {
            onEntry();
            const auto entry = reader.next();
            if (!entry) break;
            ++survey.entries;
            forEachObservation(entry->object, [&](const CObservation::Ptr& obs, size_t) {
                see(survey, config, *obs);
            });
        }
    } catch (const RawlogError& error) {
        survey.damage.emplace(error);
    }
    for (auto& [label, sensor] : survey.sensors) {
        if (sensor.sweep.isSweep()) sensor.scans3d = true;
    }
    return survey;
}

}  // namespace offmap::rawlog
