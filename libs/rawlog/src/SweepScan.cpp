// SPDX-License-Identifier: BSD-3-Clause
#include "AsPointCloud.h"

#include <offmap/rawlog/SweepColumns.h>
#include <offmap/rawlog/SweepFan.h>
#include <offmap/rawlog/SweepScan.h>

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cmath>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservation2DRangeScan;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

bool isReturn(const Scan& scan, size_t i) {
    return scan.getScanRangeValidity(i) && std::isfinite(scan.getScanRange(i)) &&
           scan.getScanRange(i) > 0;
}

mrpt::maps::CPointsMap::Ptr cloudOf(const Scan& scan, SlotMask keep) {
    mrpt::maps::CPointsMap::Ptr cloud;
    if (scan.hasIntensity()) {
        cloud = mrpt::maps::CPointsMapXYZI::Create();
    } else {
        cloud = mrpt::maps::CSimplePointsMap::Create();
    }
    for (size_t i = 0; i < scan.getScanSize(); ++i) {
        if (!keep[i] || !isReturn(scan, i)) continue;
        const double range = scan.getScanRange(i), angle = beamAngle(scan, i);
        const auto x = static_cast<float>(range * std::cos(angle));
        const auto y = static_cast<float>(range * std::sin(angle));
        const float intensity =
            scan.hasIntensity() ? static_cast<float>(scan.getScanIntensity(i)) : 0.0F;
        cloud->insertPointRGB(x, y, 0, intensity, 0, 0);
    }
    return cloud;
}

}  // namespace

size_t SweepScan::slotCount(const mrpt::obs::CObservation& obs) const {
    return asScan(obs).getScanSize();
}

std::vector<float> SweepScan::intensities(const mrpt::obs::CObservation& obs) const {
    const Scan& scan = asScan(obs);
    if (!scan.hasIntensity()) return {};
    std::vector<float> out(scan.getScanSize());
    for (size_t i = 0; i < out.size(); ++i) {
        out[i] = static_cast<float>(scan.getScanIntensity(i)) / 255.0F;
    }
    return out;
}

TurnScan SweepScan::organize(const Turn& turn, const PoseSource& poses,
                             const SensorConfig& config) const {
    return organizeSweep(turn, poses, config);
}

mrpt::obs::CObservation::Ptr SweepScan::withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                                 Leftovers /*leftovers*/) const {
    checkMask(obs, keep);
    auto out = std::make_shared<Scan>(asScan(obs));
    for (size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] || !out->getScanRangeValidity(i)) continue;
        out->setScanRangeValidity(i, false);
        out->setScanRange(i, 0);
        if (out->hasIntensity()) out->setScanIntensity(i, 0);
    }
    return out;
}

mrpt::obs::CObservation::Ptr SweepScan::asPointCloud(const mrpt::obs::CObservation& obs,
                                                     SlotMask keep,
                                                     const SensorConfig& /*config*/) const {
    checkMask(obs, keep);
    const Scan& scan = asScan(obs);
    return cloudLike(scan, cloudOf(scan, keep));
}

}  // namespace offmap::rawlog
