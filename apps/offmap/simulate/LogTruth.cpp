// SPDX-License-Identifier: BSD-3-Clause
#include "LogSimulation.h"

#include <offmap/core/LevelledScan.h>
#include <offmap/core/VerticalSegments.h>
#include <offmap/rawlog/DecodedPoints.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/ScanClasses.h>

#include <stdexcept>

namespace offmap::app {

namespace {

/// Per slot of the turn, whether its return is on a vertical segment.
std::vector<uint8_t> slotsOnSegments(const rawlog::TurnScan& turn, size_t slots) {
    core::LevelledScan levelled;
    core::level(turn.scan, levelled);
    std::vector<core::VerticalSegment> segments;
    core::VerticalSegmentFinder({}).find(turn.scan, levelled, segments);
    std::vector<uint8_t> ofSlot(slots, 0), ofPoint(turn.scan.points.size(), 0);
    for (const core::VerticalSegment& segment : segments) {
        for (uint32_t i = segment.begin; i < segment.end; ++i) ofPoint[i] = 1;
    }
    for (size_t i = 0; i < ofPoint.size(); ++i) ofSlot[turn.scan.sourceIndex[i]] = ofPoint[i];
    for (const auto& duplicate : turn.duplicates) {
        ofSlot[duplicate.slot] = ofPoint[duplicate.point];
    }
    return ofSlot;
}

}  // namespace

std::vector<evaluation::ObservationTruth> truthOf(const evaluation::SimulatedScan& scan,
                                                  const std::vector<EncodedObservation>& encoded,
                                                  const rawlog::SensorConfig& config,
                                                  uint64_t scanNumber) {
    const auto* scanClass = rawlog::scanClassOf(*encoded.front().observation, config);
    if (!scanClass) throw std::logic_error("a simulated observation without a class");
    rawlog::Turn turn;
    size_t slots = 0;
    for (const EncodedObservation& one : encoded) {
        turn.push_back(one.observation);
        slots += scanClass->slotCount(*one.observation);
    }
    const rawlog::FixedPose level({0, 0, 0}, 0, 0);
    const auto onSegment = slotsOnSegments(scanClass->organize(turn, level, config), slots);

    std::vector<evaluation::ObservationTruth> truth;
    size_t firstSlot = 0;
    for (const EncodedObservation& one : encoded) {
        const auto& obs = *one.observation;
        const auto points = rawlog::decodedPoints(obs, *scanClass, config);
        if (points.size() != one.returns.size()) {
            throw std::logic_error("a simulated observation has other returns than it should");
        }
        evaluation::ObservationTruth ofOne{scanNumber, obs.timestamp, obs.sensorLabel, {}};
        for (size_t i = 0; i < points.size(); ++i) {
            const evaluation::PointTruth& point = scan.truth[one.returns[i].point];
            ofOne.points.push_back({points[i], point.mapped, point.kind, point.standOff,
                                    onSegment[firstSlot + one.returns[i].slot] != 0});
        }
        firstSlot += scanClass->slotCount(obs);
        truth.push_back(std::move(ofOne));
    }
    return truth;
}

}  // namespace offmap::app
