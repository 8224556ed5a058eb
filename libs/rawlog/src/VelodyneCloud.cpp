// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/VelodyneCloud.h>
#include <offmap/rawlog/VelodynePackets.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/math/TPoint3D.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

/// [m] How far a stored point may be from its return: 1 cm, and what MRPT's decoder makes of the
/// azimuth, up to 0.015 degrees. Neighbouring returns of a laser are 0.2 degrees apart.
float maxDistance(float x, float y, float z) {
    return 0.01F + 3e-4F * std::sqrt(x * x + y * y + z * z);
}

constexpr uint64_t gone = std::numeric_limits<uint64_t>::max();

/// Whether a return can be there: lasers reach 131 m. The tree answers no query whose squared
/// distance is not a number.
bool isInReach(float x, float y, float z) {
    constexpr float reach = 1000;  // [m]
    return std::abs(x) < reach && std::abs(y) < reach && std::abs(z) < reach;
}

class ReturnFinder {
 public:
    explicit ReturnFinder(const VelodyneReturns& returns) {
        tree_.reserve(returns.points.size());
        slots_.reserve(returns.points.size());
        for (size_t i = 0; i < returns.points.size(); ++i) {
            const auto& p = returns.points[i];
            if (!isInReach(p.x, p.y, p.z)) continue;
            tree_.insertPointFast(p.x, p.y, p.z);
            slots_.push_back(returns.slots[i]);
        }
        tree_.mark_as_modified();
    }

    std::optional<uint32_t> slotNear(float x, float y, float z) const {
        if (slots_.empty() || !isInReach(x, y, z)) return {};
        float squared = 0;
        const size_t nearest = tree_.kdTreeClosestPoint3D(x, y, z, squared);
        if (std::sqrt(squared) > maxDistance(x, y, z)) return {};
        return slots_[nearest];
    }

 private:
    std::vector<uint32_t> slots_;
    mrpt::maps::CSimplePointsMap tree_;
};

/// Per point: its index among the points that stay, or `gone`.
std::vector<uint64_t> newIndices(const Scan& obs, SlotMask keep, Leftovers leftovers) {
    // MRPT made the cloud, without azimuth corrections.
    const ReturnFinder finder(decodePackets(obs, {.correctAzimuth = false}));
    const Scan::TPointCloud& cloud = obs.point_cloud;
    std::vector<uint64_t> indices(cloud.size(), gone);
    uint64_t next = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
        const auto slot = finder.slotNear(cloud.x[i], cloud.y[i], cloud.z[i]);
        const bool stays = slot ? keep[*slot] != 0 : leftovers == Leftovers::Keep;
        if (stays) indices[i] = next++;
    }
    return indices;
}

/// Vectors that were not filled in are left alone.
template <class T>
void filter(std::vector<T>& values, const std::vector<uint64_t>& indices) {
    if (values.size() != indices.size()) return;
    size_t left = 0;
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] != gone) values[left++] = values[i];
    }
    values.resize(left);
}

void renumber(std::vector<uint64_t>& pointsOfLaser, const std::vector<uint64_t>& indices) {
    size_t left = 0;
    for (const uint64_t i : pointsOfLaser) {
        if (i < indices.size() && indices[i] != gone) pointsOfLaser[left++] = indices[i];
    }
    pointsOfLaser.resize(left);
}

}  // namespace

void filterStoredCloud(Scan& obs, SlotMask keep, Leftovers leftovers) {
    Scan::TPointCloud& cloud = obs.point_cloud;
    if (cloud.size() == 0) return;
    if (cloud.y.size() != cloud.size() || cloud.z.size() != cloud.size()) {  // damaged
        if (leftovers == Leftovers::Drop) cloud.clear();
        return;
    }
    const auto indices = newIndices(obs, keep, leftovers);
    filter(cloud.x, indices);
    filter(cloud.y, indices);
    filter(cloud.z, indices);
    filter(cloud.intensity, indices);
    filter(cloud.timestamp, indices);
    filter(cloud.azimuth, indices);
    filter(cloud.laser_id, indices);
    for (auto& pointsOfLaser : cloud.pointsForLaserID) renumber(pointsOfLaser, indices);
}

}  // namespace offmap::rawlog
