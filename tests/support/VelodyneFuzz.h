// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scans.h"
#include "VelodyneMaker.h"

#include <offmap/rawlog/VelodyneModel.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <stdexcept>
#include <vector>

namespace offmap::test {

using FuzzBytes = std::span<const uint8_t>;

/// What the first byte of an input chooses.
struct FuzzChoice {
    explicit FuzzChoice(uint8_t byte)
        : model(byte & 3),
          dual(byte & 4),
          repair(byte & 8),
          calibrated(byte & 16),
          cloud(byte & 32),
          timeReference(static_cast<rawlog::TimeReference>((byte >> 6) % 3)) {}

    int model;        ///< 0 VLP-16, 1 HDL-32E, 2 HDL-64E, 3: whatever the bytes say
    bool dual;        ///< return mode
    bool repair;      ///< gives the blocks the headers of the model
    bool calibrated;  ///< the observation holds a calibration; some of its corrections are input
    bool cloud;       ///< and a point cloud of the input's bytes
    rawlog::TimeReference timeReference;
};

/// Takes the next value off the input; zero if it is used up.
template <class T>
T take(FuzzBytes& bytes) {
    T value{};
    const size_t size = std::min(sizeof value, bytes.size());
    if (size > 0) std::memcpy(&value, bytes.data(), size);
    bytes = bytes.subspan(size);
    return value;
}

inline mrpt::obs::VelodyneCalibration fuzzCalibration(const FuzzChoice& choice, FuzzBytes& bytes) {
    using mrpt::obs::VelodyneCalibration;
    VelodyneCalibration calibration =
        choice.model >= 2
            ? hdl64Calibration()
            : VelodyneCalibration::LoadDefaultCalibration(choice.model == 0 ? "VLP16" : "HDL32");
    const size_t changes = take<uint8_t>(bytes) % 4;
    for (size_t i = 0; i < changes; ++i) {
        const size_t laser = take<uint8_t>(bytes) % calibration.laser_corrections.size();
        auto& correction = calibration.laser_corrections[laser];
        correction.azimuthCorrection = take<int16_t>(bytes) / 1000.0;  // [deg]
        correction.distanceCorrection = take<float>(bytes);
    }
    return calibration;
}

inline void repairPacket(const FuzzChoice& choice, VelodynePacket& packet) {
    for (size_t b = 0; b < 12; ++b) {
        setHeader(packet, b, choice.model == 2 && b % 2 == 1 ? lowerBank : upperBank);
    }
    packet.velodyne_model_ID = choice.model == 1 ? 0x21 : 0x22;
    packet.laser_return_mode = choice.dual ? 0x39 : 0x37;
}

inline mrpt::obs::CObservationVelodyneScan fuzzScan(const FuzzChoice& choice, FuzzBytes bytes) {
    mrpt::obs::CObservationVelodyneScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
    if (choice.calibrated) scan.calibration = fuzzCalibration(choice, bytes);
    if (choice.cloud) {
        auto& cloud = scan.point_cloud;
        cloud.x.resize(take<uint8_t>(bytes) % 8);
        cloud.y.resize(take<uint8_t>(bytes) % 2 == 1 ? 3 : cloud.x.size());
        cloud.z.resize(cloud.x.size());
        for (auto* values : {&cloud.x, &cloud.y, &cloud.z}) {
            for (float& value : *values) value = take<float>(bytes);
        }
    }
    while (!bytes.empty()) {
        auto packet = take<VelodynePacket>(bytes);
        if (choice.repair) repairPacket(choice, packet);
        scan.scan_packets.push_back(packet);
    }
    return scan;
}

inline void require(bool holds, const char* what) {
    if (!holds) throw std::logic_error(what);
}

inline void requireSoundColumns(const rawlog::TurnScan& turn,
                                const mrpt::obs::CObservationVelodyneScan& scan) {
    const size_t slots = scan.scan_packets.size() * rawlog::slotsPerPacket;
    std::vector<uint8_t> seen(slots, 0);
    const auto see = [&](uint32_t slot) {
        require(slot < slots, "a slot out of range");
        require(!seen[slot]++, "a slot twice");
        require(rawlog::distanceOf(rawlog::returnInSlot(scan, slot)) != 0, "a point of no return");
    };
    require(turn.scan.sourceIndex.size() == turn.scan.points.size(), "a point without its slot");
    for (const uint32_t slot : turn.scan.sourceIndex) see(slot);
    for (const auto& duplicate : turn.duplicates) {
        see(duplicate.slot);
        require(duplicate.point < turn.scan.points.size(), "a duplicate of no point");
    }
    for (const auto& p : turn.scan.points) {
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "not finite");
    }
    uint32_t next = 0;
    for (const auto& column : turn.scan.columns) {
        require(column.begin == next && column.end >= column.begin, "columns with gaps");
        require(std::isfinite(column.azimuth), "an azimuth that is not finite");
        next = column.end;
    }
    require(next == turn.scan.points.size(), "points outside of all columns");
    const auto& counts = turn.counts;
    require(counts.returns + counts.nonFinite + counts.zero == slots, "slots that do not add up");
    require(turn.scan.points.size() + turn.duplicates.size() == counts.returns, "lost returns");
}

/// What goes out with a mask, and with its complement, must be the whole.
inline void requireWhole(const mrpt::obs::CObservationVelodyneScan& scan, uint32_t seed) {
    using Scan = mrpt::obs::CObservationVelodyneScan;
    const rawlog::VelodyneScan scanClass;
    const auto keep = randomMask(scanClass.slotCount(scan), seed);
    const auto kept =
        std::dynamic_pointer_cast<Scan>(scanClass.withOnly(scan, keep, rawlog::Leftovers::Keep));
    const auto removed = std::dynamic_pointer_cast<Scan>(
        scanClass.withOnly(scan, complementOf(keep), rawlog::Leftovers::Drop));
    for (size_t slot = 0; slot < keep.size(); ++slot) {
        const auto& own = rawlog::returnInSlot(keep[slot] ? *kept : *removed, slot);
        const auto& other = rawlog::returnInSlot(keep[slot] ? *removed : *kept, slot);
        const auto& original = rawlog::returnInSlot(scan, slot);
        require(std::memcmp(&own, &original, sizeof own) == 0, "a return that changed");
        require(rawlog::distanceOf(other) == 0, "a return in both");
    }
    require(kept->point_cloud.size() + removed->point_cloud.size() == scan.point_cloud.size(),
            "stored points that do not add up");
    scanClass.asPointCloud(scan, keep, {});
}

/// Decodes a scan that the bytes make up, and checks what must hold for every one.
/// \throw std::logic_error if it does not
inline void fuzzVelodyne(FuzzBytes bytes) {
    const FuzzChoice choice(take<uint8_t>(bytes));
    const auto seed = take<uint16_t>(bytes);
    const auto scan = fuzzScan(choice, bytes);
    if (rawlog::unsupportedVelodyne(scan)) {
        try {
            rawlog::decodePackets(scan);
        } catch (const std::invalid_argument&) {
            return;
        }
        throw std::logic_error("a scan decoded that is not supported");
    }
    rawlog::SensorConfig config;
    config.timeReference = choice.timeReference;
    const DrivenVehicle still{mrpt::poses::CPose3D()};
    const auto shared = std::make_shared<mrpt::obs::CObservationVelodyneScan>(scan);
    requireSoundColumns(rawlog::VelodyneScan().organize({shared}, still, config), scan);
    requireWhole(scan, seed);
}

/// Inputs of some packets each, for every model and return mode.
inline std::vector<std::vector<uint8_t>> velodyneFuzzSeeds() {
    std::vector<std::vector<uint8_t>> seeds;
    for (const int choice : {0, 4, 9, 13, 16, 18, 20, 17, 26, 32, 48, 58, 3, 19, 74, 144}) {
        const bool hdl64 = (choice & 3) == 2, hdl32 = (choice & 3) == 1;
        std::vector<uint8_t> input{static_cast<uint8_t>(choice), 1, 0};
        if (choice & 16) input.push_back(0);
        if (choice & 32) input.insert(input.end(), 2, 0);
        for (uint32_t p = 0; p < 3; ++p) {
            auto packet = hdl64   ? emptyHdl64Packet(288 * p)
                          : hdl32 ? emptyHdl32Packet(553 * p)
                                  : emptyVlp16Packet(1327 * p);
            if (choice & 4) packet.laser_return_mode = 0x39;
            const size_t stride = hdl64 || (choice & 4) ? 2 : 1;
            for (size_t b = 0; b < 12; ++b) {
                setRotation(packet, b, static_cast<int>(35800 + 20 * (p * 12 + b) / stride));
                for (size_t slot = 0; slot < 32; slot += 1 + b % 3) {
                    setReturn(packet, b, slot, static_cast<uint16_t>(1000 + 10 * slot), 9);
                }
            }
            const auto* begin = reinterpret_cast<const uint8_t*>(&packet);
            input.insert(input.end(), begin, begin + sizeof packet);
        }
        seeds.push_back(std::move(input));
    }
    return seeds;
}

}  // namespace offmap::test
