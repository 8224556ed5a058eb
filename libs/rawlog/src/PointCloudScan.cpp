// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/PlacedCloud.h>
#include <offmap/rawlog/PointCloudScan.h>

#include <fmt/format.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace offmap::rawlog {

namespace {

using Cloud = mrpt::obs::CObservationPointCloud;
using mrpt::maps::CPointsMap, mrpt::maps::CPointsMapXYZI;

const Cloud& asCloud(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Cloud&>(obs); }

CloudPoints pointsOf(const CPointsMap& map) {
    return {map.getPointsBufferRef_x(), map.getPointsBufferRef_y(), map.getPointsBufferRef_z()};
}

/// Slots that follow each other, half-open.
struct SlotRun {
    size_t begin, end;
};

/// What is chosen stands in runs.
std::vector<SlotRun> chosenRuns(SlotMask keep) {
    if (keep.empty()) return {};
    const auto next = [&](int wanted, size_t from) {
        const void* found = std::memchr(keep.data() + from, wanted, keep.size() - from);
        return found ? static_cast<size_t>(static_cast<const uint8_t*>(found) - keep.data())
                     : keep.size();
    };
    std::vector<SlotRun> runs;
    for (size_t begin = next(1, 0); begin < keep.size();) {
        const size_t end = next(0, begin);
        runs.push_back({begin, end});
        begin = next(1, end);
    }
    return runs;
}

/// Copies the chosen points of one map to another, all their channels.
void copyChosen(const CPointsMap& map, std::span<const SlotRun> runs, CPointsMap& chosen) {
    std::vector<float> channels;
    size_t next = 0;
    for (const auto& [begin, end] : runs) {
        for (size_t i = begin; i < end; ++i) {
            map.getPointAllFieldsFast(i, channels);
            chosen.setPointAllFieldsFast(next++, channels);
        }
    }
}

/// The same for what most scanners give, without a list of channels for each point.
void copyChosen(const CPointsMapXYZI& map, std::span<const SlotRun> runs, CPointsMapXYZI& chosen) {
    const CloudPoints points = pointsOf(map);
    const std::span<const float> intensities = map.getPointsBufferRef_intensity();
    size_t next = 0;
    for (const auto& [begin, end] : runs) {
        for (size_t i = begin; i < end; ++i) {
            chosen.setPointFast(next, points.x[i], points.y[i], points.z[i]);
            chosen.setPointColor_fast(next++, intensities[i], 0, 0);  // its red is the intensity
        }
    }
}

/// A map of the same class, with its options and the chosen of its points.
CPointsMap::Ptr chosenOf(const CPointsMap& map, SlotMask keep) {
    auto chosen = std::dynamic_pointer_cast<CPointsMap>(map.GetRuntimeClass()->createObject());
    chosen->genericMapParams = map.genericMapParams;
    chosen->insertionOptions = map.insertionOptions;
    chosen->likelihoodOptions = map.likelihoodOptions;
    chosen->renderOptions = map.renderOptions;
    const std::vector<SlotRun> runs = chosenRuns(keep);
    size_t points = 0;
    for (const auto& [begin, end] : runs) points += end - begin;
    chosen->resize(points);
    if (map.GetRuntimeClass() == CLASS_ID(CPointsMapXYZI)) {
        copyChosen(dynamic_cast<const CPointsMapXYZI&>(map), runs,
                   dynamic_cast<CPointsMapXYZI&>(*chosen));
    } else {
        copyChosen(map, runs, *chosen);
    }
    chosen->mark_as_modified();
    return chosen;
}

}  // namespace

size_t PointCloudScan::slotCount(const mrpt::obs::CObservation& obs) const {
    const Cloud& cloud = asCloud(obs);
    if (cloud.isExternallyStored()) {
        throw std::logic_error(fmt::format("the cloud of '{}' is still in its file '{}'",
                                           cloud.sensorLabel, cloud.getExternalStorageFile()));
    }
    return cloud.pointcloud ? cloud.pointcloud->size() : 0;
}

std::vector<float> PointCloudScan::intensities(const mrpt::obs::CObservation& obs) const {
    const auto* map = dynamic_cast<const CPointsMapXYZI*>(asCloud(obs).pointcloud.get());
    if (!map) return {};
    std::vector<float> out(map->size());
    float brightest = 0;
    for (size_t i = 0; i < out.size(); ++i) {
        out[i] = map->getPointIntensity_fast(i);
        brightest = std::max(brightest, out[i]);
    }
    // MRPT's go to 1; many programs copy the sensor's whole numbers.
    if (brightest > 1) {
        for (float& intensity : out) intensity /= 255.0F;
    }
    return out;
}

TurnScan PointCloudScan::organize(const Turn& turn, const PoseSource& poses,
                                  const SensorConfig& config) const {
    TurnScan out;
    size_t firstSlot = 0;
    for (const auto& obs : turn) {
        const size_t slots = slotCount(*obs);
        const auto& map = asCloud(*obs).pointcloud;
        appendCloud(out,
                    {map ? pointsOf(*map) : CloudPoints{}, obs->timestamp, poses.at(obs->timestamp),
                     sensorInVehicle(*obs, config)},
                    static_cast<uint32_t>(firstSlot), config);
        firstSlot += slots;
    }
    return out;
}

mrpt::obs::CObservation::Ptr PointCloudScan::withOnly(const mrpt::obs::CObservation& obs,
                                                      SlotMask keep,
                                                      Leftovers /*leftovers*/) const {
    checkMask(obs, keep);
    auto out = std::make_shared<Cloud>(asCloud(obs));
    if (out->pointcloud) out->pointcloud = chosenOf(*out->pointcloud, keep);
    return out;
}

mrpt::obs::CObservation::Ptr PointCloudScan::asPointCloud(const mrpt::obs::CObservation& obs,
                                                          SlotMask keep,
                                                          const SensorConfig& /*config*/) const {
    return withOnly(obs, keep, Leftovers::Keep);
}

}  // namespace offmap::rawlog
