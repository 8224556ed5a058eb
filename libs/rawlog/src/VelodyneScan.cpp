// SPDX-License-Identifier: BSD-3-Clause
#include "AsPointCloud.h"
#include "VelodyneColumnStream.h"

#include <offmap/rawlog/VelodyneCloud.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <mrpt/maps/CPointsMapXYZI.h>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

/// Whether return i repeats the one before: both of one laser in dual return mode.
bool isRepeated(const VelodyneReturns& decoded, size_t i) {
    return i > 0 && decoded.lasers[i] == decoded.lasers[i - 1] &&
           decoded.points[i] == decoded.points[i - 1];
}

}  // namespace

size_t VelodyneScan::slotCount(const mrpt::obs::CObservation& obs) const {
    return asScan(obs).scan_packets.size() * slotsPerPacket;
}

std::vector<float> VelodyneScan::intensities(const mrpt::obs::CObservation& obs) const {
    std::vector<float> out(slotCount(obs));
    for (size_t slot = 0; slot < out.size(); ++slot) {
        out[slot] = static_cast<float>(returnInSlot(asScan(obs), slot).intensity()) / 255.0F;
    }
    return out;
}

TurnScan VelodyneScan::organize(const Turn& turn, const PoseSource& poses,
                                const SensorConfig& config) const {
    TurnScan out;
    VelodyneColumnStream(poses, config).finish(turn, out);
    return out;
}

std::unique_ptr<ColumnStream> VelodyneScan::columnStream(const PoseSource& poses,
                                                         const SensorConfig& config) const {
    return std::make_unique<VelodyneColumnStream>(poses, config);
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
        if (isRepeated(decoded, i) && keep[decoded.slots[i - 1]]) continue;
        const auto& p = decoded.points[i];
        const float intensity =
            static_cast<float>(returnInSlot(scan, decoded.slots[i]).intensity()) / 255.0F;
        cloud->insertPointRGB(p.x, p.y, p.z, intensity, 0, 0);
    }
    return cloudLike(scan, cloud);
}

}  // namespace offmap::rawlog
