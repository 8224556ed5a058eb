// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random/RandomGenerators.h>

#include <algorithm>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

namespace {

/// Whether it can be reduced, by itself; if it is the first that cannot, notes why.
bool isScan(const CObservation& obs, const SensorConfig& config, SensorSurvey& sensor) {
    if (scanClassOf(obs, config)) return true;
    if (!sensor.unsupported) sensor.unsupported = unsupportedReason(obs, config);
    return false;
}

void see(LogSurvey& survey, const Config& config, const CObservation& obs) {
    if (const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&obs)) {
        survey.poses[obs.sensorLabel].push_back(stampedPose(*pose));
        return;
    }
    const bool hasTime = obs.timestamp != INVALID_TIMESTAMP;
    const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&obs);
    if (odometry && hasTime) {
        survey.odometry[obs.sensorLabel].push_back({obs.timestamp, odometry->odometry.asTPose()});
    }
    SensorSurvey& sensor = survey.sensors[obs.sensorLabel];
    if (hasTime) sensor.times = spanned(sensor.times, obs.timestamp);
    if (sensor.observations++ == 0) sensor.className = classNameOf(obs);
    if (const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&obs)) {
        sensor.sweep.see(*scan);
    } else if (isScan(obs, config.sensorOf(obs.sensorLabel), sensor)) {
        sensor.scans3d = true;
    }
}

void see(ActionSurvey& survey, const mrpt::obs::CActionCollection& actions) {
    ++survey.collections;
    if (auto step = movementOf(actions)) {
        ++survey.movements;
        survey.steps.push_back(*step);
    }
}

/// The movement before a frame has led to the place where the frame was taken, at the time of its
/// first observation; the stamps of actions are often not set.
void see(ActionSurvey& survey, const mrpt::obs::CSensoryFrame& frame) {
    ++survey.frames;
    const auto first = std::find_if(frame.begin(), frame.end(), [](const auto& obs) {
        return obs && obs->timestamp != INVALID_TIMESTAMP;
    });
    if (first == frame.end()) return;
    if (survey.steps.empty() || survey.steps.back().time) survey.steps.emplace_back();
    survey.steps.back().time = (*first)->timestamp;
}

void see(LogSurvey& survey, const Config& config,
         const mrpt::serialization::CSerializable::Ptr& entry) {
    forEachObservation(entry,
                       [&](const CObservation::Ptr& obs, size_t) { see(survey, config, *obs); });
    if (const auto* actions = dynamic_cast<const mrpt::obs::CActionCollection*>(entry.get())) {
        see(survey.actions, *actions);
    } else if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(entry.get())) {
        see(survey.actions, *frame);
    }
}

}  // namespace

TimeSpan spanned(const std::optional<TimeSpan>& span, mrpt::Clock::time_point time) {
    if (!span) return {time, time};
    return {std::min(span->begin, time), std::max(span->end, time)};
}

bool LogSurvey::holdsScans() const {
    return std::ranges::any_of(sensors, [](const auto& sensor) { return sensor.second.scans3d; });
}

std::optional<TimeSpan> LogSurvey::scanTimes() const {
    std::optional<TimeSpan> span;
    for (const auto& [label, sensor] : sensors) {
        if (!sensor.scans3d || !sensor.times) continue;
        span = spanned(spanned(span, sensor.times->begin), sensor.times->end);
    }
    return span;
}

bool LogSurvey::reducible(const CObservation& obs, const SensorConfig& config) const {
    if (!scanClassOf(obs, config)) return false;
    if (!dynamic_cast<const CObservation2DRangeScan*>(&obs)) return true;
    const auto sensor = sensors.find(obs.sensorLabel);
    return sensor != sensors.end() && sensor->second.sweep.isSweep();
}

LogSurvey surveyLog(RawlogReader& reader, const Config& config, uint64_t maxEntries,
                    const std::function<void()>& onEntry) {
    // Of odometry actions with a motion model of particles, MRPT draws the particles while it
    // reads.
    mrpt::random::getRandomGenerator().randomize(1);
    LogSurvey survey;
    try {
        while (survey.entries < maxEntries) {
            onEntry();
            const auto entry = reader.next();
            if (!entry) break;
            ++survey.entries;
            see(survey, config, entry->object);
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
