// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogInventory.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SelfMask.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

namespace {

bool hasTime(const CObservation& obs) { return obs.timestamp.time_since_epoch().count() > 0; }

/// To 1 mm and 0.01 degrees.
bool sameMounting(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b) {
    const double angle = mrpt::DEG2RAD(0.01);
    return a.distanceTo(b) < 1e-3 && std::abs(mrpt::math::wrapToPi(a.yaw() - b.yaw())) < angle &&
           std::abs(a.pitch() - b.pitch()) < angle &&
           std::abs(mrpt::math::wrapToPi(a.roll() - b.roll())) < angle;
}

void countActions(const mrpt::obs::CActionCollection& collection, EntryCounts& counts) {
    ++counts.actionCollections;
    for (const auto& action : collection) {
        if (action) ++counts.actions[classNameOf(*action)];
    }
}

}  // namespace

LogInventory::LogInventory(const LogSurvey& survey, const Config& config,
                           std::filesystem::path input, std::set<std::string> sensors,
                           std::vector<PoseCoverage*> coverages)
    : survey_(survey),
      input_(std::move(input)),
      chosen_(std::move(sensors)),
      coverages_(std::move(coverages)),
      configs_(config),
      finder_(config.reduction.vertical) {}

void LogInventory::add(const RawlogEntry& entry) {
    using mrpt::obs::CActionCollection;
    if (!entry.object) {
        ++entries_.nothing;
    } else if (const auto* actions = dynamic_cast<const CActionCollection*>(entry.object.get())) {
        countActions(*actions, entries_);
    } else if (dynamic_cast<const mrpt::obs::CSensoryFrame*>(entry.object.get())) {
        ++entries_.sensoryFrames;
    } else {
        ++entries_.observations;
    }
    forEachObservation(entry.object,
                       [this](const CObservation::Ptr& obs, size_t) { addObservation(obs); });
}

void LogInventory::addObservation(const CObservation::Ptr& obs) {
    const SensorConfig& config = configs_.of(obs->sensorLabel);
    SensorInventory& sensor = sensors_[{obs->sensorLabel, classNameOf(*obs)}];
    const mrpt::poses::CPose3D mounting = sensorInVehicle(*obs, config);
    if (sensor.observations++ == 0) {
        sensor.model = sensorModelOf(*obs);
        sensor.mounting = mounting;
    }
    sensor.mountingVaries |= !sameMounting(*sensor.mounting, mounting);
    if (hasTime(*obs)) {
        sensor.interval.add(obs->timestamp);
        sensor.span = spanned(sensor.span, obs->timestamp);
        span_ = spanned(span_, obs->timestamp);
        for (PoseCoverage* coverage : coverages_) coverage->follow(obs->timestamp);
    } else {
        ++entries_.withoutTime;
    }
    if (survey_.reducible(*obs, config)) {
        addScan(sensor, obs, config);
    } else if (const auto reason = unsupportedReason(*obs, config)) {
        sensor.scans3d = true;
        ++sensor.notReducible[*reason];
    }
}

void LogInventory::addScan(SensorInventory& sensor, const CObservation::Ptr& obs,
                           const SensorConfig& config) {
    sensor.scans3d = true;
    try {
        if (scanClassOf(*obs, config)->loadExternal(*obs, input_)) ++sensor.external;
    } catch (const std::exception& error) {
        ++sensor.external;
        if (sensor.externalMissing++ == 0) sensor.externalProblem = error.what();
        return;
    }
    ++sensor.reducible;
    if (chosen_.empty() || chosen_.contains(obs->sensorLabel)) {
        if (hasTime(*obs)) scanSpan_ = spanned(scanSpan_, obs->timestamp);
        const mrpt::poses::CPose3D mounting = sensorInVehicle(*obs, config);
        for (PoseCoverage* coverage : coverages_) coverage->add(obs->timestamp, mounting);
    }
    const auto* fan = dynamic_cast<const CObservation2DRangeScan*>(obs.get());
    if (!fan) return countTurn(sensor, {obs}, config);
    auto& turns = open_.try_emplace({obs->sensorLabel, classNameOf(*obs)}, config).first->second;
    for (const Turn& turn : turns.add(*fan, obs)) countTurn(sensor, turn, config);
}

void LogInventory::countTurn(SensorInventory& sensor, const Turn& turn,
                             const SensorConfig& config) {
    static const PoseTrack noPoses{{}};
    TurnScan organized = scanClassOf(*turn.front(), config)->organize(turn, noPoses, config);
    maskSelfReturns(organized, config);
    core::level(organized.scan, levelled_);
    finder_.find(organized.scan, levelled_, segments_);
    for (const core::VerticalSegment& segment : segments_) {
        sensor.onVerticalSegments += segment.end - segment.begin;
    }
    const ReturnCounts& counts = organized.counts;
    ++sensor.scans;
    sensor.counts.returns += counts.returns;
    sensor.counts.nonFinite += counts.nonFinite;
    sensor.counts.zero += counts.zero;
    sensor.counts.duplicates += counts.duplicates;
    sensor.counts.self += counts.self;
}

void LogInventory::finish() {
    for (auto& [sensor, turns] : open_) {
        for (const Turn& turn : turns.finish()) {
            countTurn(sensors_[sensor], turn, configs_.of(sensor.first));
        }
    }
}

}  // namespace offmap::rawlog
