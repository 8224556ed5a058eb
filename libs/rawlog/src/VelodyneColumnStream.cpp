// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneColumnStream.h"

#include <offmap/rawlog/ColumnBuilder.h>

#include <limits>
#include <utility>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

}  // namespace

void VelodyneColumnStream::add(const Turn& soFar, TurnScan& out) {
    const Scan& obs = asScan(*soFar.front());
    if (config_.timeReference != TimeReference::First || obs.scan_packets.empty()) return;
    decode(obs);
    const VelodyneReturns& decoded = progress_.decoded;
    if (!decoded.azimuthCorrections.empty()) return;
    const auto until = poses_.settled().until;
    size_t end = progress_.firings;
    while (end < decoded.firings.size() && decoded.firings[end].time < until) ++end;
    append(gatherFirstReturns(decoded, progress_.firings, end), obs, out);
    progress_.firings = end;
}

void VelodyneColumnStream::finish(const Turn& turn, TurnScan& out) {
    for (const auto& observation : turn) {
        const Scan& obs = asScan(*observation);
        decode(obs);
        VelodyneColumns gathered = gatherColumns(progress_.decoded, progress_.firings);
        out.reserve(gathered.columns.size(), gathered.returns.size());
        append(std::move(gathered), obs, out);
        const size_t slots = obs.scan_packets.size() * slotsPerPacket;
        out.counts.zero += slots - progress_.decoded.points.size();
        firstSlot_ += static_cast<uint32_t>(slots);
        progress_ = {};
    }
}

void VelodyneColumnStream::decode(const Scan& obs) {
    decodeFurther(obs, progress_.packets, {.timeReference = config_.timeReference},
                  progress_.decoded);
    progress_.packets = obs.scan_packets.size();
}

/// By their lasers, if there is not more than one return of each: nothing has to be sorted then.
void VelodyneColumnStream::orderUpward(std::span<uint32_t> returns) {
    constexpr uint32_t none = std::numeric_limits<uint32_t>::max();
    const VelodyneReturns& decoded = progress_.decoded;
    ofLaser_.assign(decoded.upward.size(), none);
    for (const uint32_t r : returns) {
        uint32_t& ofLaser = ofLaser_[decoded.lasers[r]];
        if (ofLaser != none) return;
        ofLaser = r;
    }
    size_t next = 0;
    for (const uint8_t laser : decoded.upward) {
        if (ofLaser_[laser] != none) returns[next++] = ofLaser_[laser];
    }
}

void VelodyneColumnStream::append(VelodyneColumns gathered, const Scan& obs, TurnScan& out) {
    const mrpt::poses::CPose3D mounting = sensorInVehicle(obs, config_);
    const VelodyneReturns& decoded = progress_.decoded;
    for (const VelodyneColumn& from : gathered.columns) {
        const size_t begin = out.scan.points.size();
        const auto ofColumn =
            std::span(gathered.returns).subspan(from.begin, from.end - from.begin);
        orderUpward(ofColumn);
        for (const uint32_t r : ofColumn) {
            if (!countReturn(out.counts, decoded.points[r])) continue;
            out.add(decoded.points[r], firstSlot_ + decoded.slots[r]);
        }
        core::ScanColumn& column = out.scan.columns.emplace_back();
        column.azimuth = static_cast<float>(azimuthInVehicle(from.azimuth, mounting));
        column.time = from.time;
        placeColumn(column, poses_.at(from.time), mounting);
        closeColumn(out, mounting, begin);
    }
}

}  // namespace offmap::rawlog
