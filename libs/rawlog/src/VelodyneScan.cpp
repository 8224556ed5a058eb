// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/VelodyneCloud.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <fmt/format.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

constexpr uint8_t modelHdl32 = 0x21;
constexpr uint8_t modelVlp16 = 0x22;
constexpr size_t vlp16Lasers = 16;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

void appendFirings(TurnScan& out, const Scan& obs, uint32_t firstSlot, const PoseSource& poses,
                   const SensorConfig& config) {
    const mrpt::poses::CPose3D mounting = sensorInVehicle(obs, config);
    const VelodyneReturns decoded = decodePackets(obs);
    std::vector<ColumnReturn> returns;
    for (const VelodyneFiring& firing : decoded.firings) {
        returns.clear();
        for (uint32_t i = firing.begin; i < firing.end; ++i) {
            if (!countReturn(out.counts, decoded.points[i])) continue;
            returns.push_back({decoded.points[i], firstSlot + decoded.slots[i]});
        }
        core::ScanColumn column;
        column.azimuth = static_cast<float>(azimuthInVehicle(firing.azimuth, mounting));
        column.time = firing.time;
        placeColumn(column, poses.at(firing.time), mounting);
        appendColumn(out, column, mounting, returns);
    }
    out.counts.zero += obs.scan_packets.size() * slotsPerPacket - decoded.points.size();
}

}  // namespace

size_t VelodyneScan::slotCount(const mrpt::obs::CObservation& obs) const {
    return asScan(obs).scan_packets.size() * slotsPerPacket;
}

TurnScan VelodyneScan::organize(const Turn& turn, const PoseSource& poses,
                                const SensorConfig& config) const {
    TurnScan out;
    size_t firstSlot = 0;
    for (const auto& obs : turn) {
        appendFirings(out, asScan(*obs), static_cast<uint32_t>(firstSlot), poses, config);
        firstSlot += slotCount(*obs);
    }
    return out;
}

mrpt::obs::CObservation::Ptr VelodyneScan::withOnly(const mrpt::obs::CObservation& obs,
                                                    SlotMask keep, Leftovers leftovers) const {
    checkMask(obs, keep);
    auto out = std::make_shared<Scan>(asScan(obs));
    filterStoredCloud(*out, keep, leftovers);
    size_t slot = 0;
    for (auto& packet : out->scan_packets) {
        for (auto& block : packet.blocks) {
            for (auto& laserReturn : block.laser_returns) {
                if (!keep[slot++]) laserReturn = Scan::laser_return_t{};
            }
        }
    }
    return out;
}

mrpt::obs::CObservation::Ptr VelodyneScan::asPointCloud(const mrpt::obs::CObservation& obs,
                                                        SlotMask keep,
                                                        const SensorConfig& /*config*/) const {
    checkMask(obs, keep);
    const Scan& scan = asScan(obs);
    const VelodyneReturns decoded = decodePackets(scan);
    auto cloud = mrpt::maps::CPointsMapXYZI::Create();
    for (size_t i = 0; i < decoded.points.size(); ++i) {
        if (!keep[decoded.slots[i]]) continue;
        const auto& p = decoded.points[i];
        const float intensity =
            static_cast<float>(returnInSlot(scan, decoded.slots[i]).intensity()) / 255.0F;
        cloud->insertPointRGB(p.x, p.y, p.z, intensity, 0, 0);
    }
    auto out = mrpt::obs::CObservationPointCloud::Create();
    out->timestamp = scan.timestamp;
    out->sensorLabel = scan.sensorLabel;
    out->sensorPose = scan.sensorPose;
    out->pointcloud = cloud;
    return out;
}

std::optional<std::string> unsupportedVelodyne(const Scan& obs) {
    if (obs.scan_packets.empty() && obs.point_cloud.size() > 0) {
        return "a Velodyne scan without its packets is not supported yet, copied unchanged";
    }
    for (const auto& packet : obs.scan_packets) {
        if (packet.velodyne_model_ID == modelHdl32) {
            return "Velodyne HDL-32E is not supported yet, copied unchanged";
        }
        if (packet.velodyne_model_ID != modelVlp16) {
            return fmt::format(
                "Velodyne model 0x{:02x} (VLP-16 is 0x22) is not supported yet, copied unchanged",
                packet.velodyne_model_ID);
        }
        if (packet.laser_return_mode == Scan::RETMODE_DUAL) {
            return "Velodyne dual return mode is not supported yet, copied unchanged";
        }
    }
    const size_t lasers = obs.calibration.laser_corrections.size();
    if (lasers != 0 && lasers != vlp16Lasers) {
        return fmt::format(
            "a Velodyne calibration of {} lasers is not supported yet, copied unchanged", lasers);
    }
    return {};
}

}  // namespace offmap::rawlog
