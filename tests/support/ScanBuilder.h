// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>

#include <mrpt/math/TSegment2D.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace offmap::test {

/// An upright rectangle, from z to z.
struct Slab {
    mrpt::math::TSegment2D line;   ///< [m] map frame
    double bottom = 0, top = 2.5;  ///< [m]
};

/// The beams of a scanner, which look upright into the map however the sensor is tilted.
struct Beams {
    uint32_t columns = 360, rows = 181;
    double firstAzimuth = -std::numbers::pi;    ///< [rad]
    double azimuthSpan = 2 * std::numbers::pi;  ///< [rad] negative: clockwise
    double lowest = -std::numbers::pi / 3, highest = std::numbers::pi / 3;  ///< [rad] elevation
};

inline constexpr int floorSurface = -1;

/// A scan without noise, and the slab (or floorSurface) that each of its points lies on.
struct BuiltScan {
    core::OrganizedScan scan;
    std::vector<int> surface;
};

/// The scan of slabs on a floor at z = 0, each return on the first surface that its beam meets.
class ScanBuilder {
 public:
    ScanBuilder(std::span<const Slab> slabs, const mrpt::poses::CPose3D& sensorInMap)
        : slabs_(slabs), sensorInMap_(sensorInMap) {}

    BuiltScan build(const Beams& beams,
                    const Eigen::Matrix3d& groundCovariance = Eigen::Matrix3d::Zero()) const {
        BuiltScan built;
        for (uint32_t c = 0; c < beams.columns; ++c) {
            const double azimuth = beams.firstAzimuth + beams.azimuthSpan * c / beams.columns;
            core::ScanColumn column;
            column.begin = static_cast<uint32_t>(built.scan.points.size());
            column.azimuth = static_cast<float>(azimuth);
            column.sensor = core::SensorPose{sensorInMap_, groundCovariance};
            for (uint32_t r = 0; r < beams.rows; ++r) {
                const double elevation =
                    beams.lowest + (beams.highest - beams.lowest) * r / (beams.rows - 1);
                addReturn(sensorInMap_.yaw() + azimuth, elevation, built);
            }
            column.end = static_cast<uint32_t>(built.scan.points.size());
            built.scan.columns.push_back(column);
        }
        return built;
    }

 private:
    void addReturn(double bearing, double elevation, BuiltScan& built) const {
        const double slope = std::tan(elevation), height = sensorInMap_.z();
        std::optional<std::pair<double, int>> nearest;
        if (slope < 0) nearest = {-height / slope, floorSurface};
        for (size_t s = 0; s < slabs_.size(); ++s) {
            const auto range = rangeTo(slabs_[s].line, bearing);
            if (!range || (nearest && *range >= nearest->first)) continue;
            const double z = height + *range * slope;
            if (z < slabs_[s].bottom || z > slabs_[s].top) continue;
            nearest = {*range, static_cast<int>(s)};
        }
        if (!nearest) return;
        const auto [range, surface] = *nearest;
        const mrpt::math::TPoint3D inMap(sensorInMap_.x() + range * std::cos(bearing),
                                         sensorInMap_.y() + range * std::sin(bearing),
                                         height + range * slope);
        const auto p = sensorInMap_.inverseComposePoint(inMap);
        built.scan.points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y),
                                       static_cast<float>(p.z));
        built.scan.sourceIndex.push_back(static_cast<uint32_t>(built.surface.size()));
        built.surface.push_back(surface);
    }

    std::optional<double> rangeTo(const mrpt::math::TSegment2D& line, double bearing) const {
        const double ux = std::cos(bearing), uy = std::sin(bearing);
        const double ax = line.point1.x - sensorInMap_.x(), ay = line.point1.y - sensorInMap_.y();
        const double bx = line.point2.x - sensorInMap_.x(), by = line.point2.y - sensorInMap_.y();
        const double left = ux * ay - uy * ax, right = ux * by - uy * bx;
        if (left * right > 0 || left == right) return std::nullopt;
        const double share = left / (left - right);
        const double range = ux * (ax + share * (bx - ax)) + uy * (ay + share * (by - ay));
        return range > 0 ? std::optional(range) : std::nullopt;
    }

    std::span<const Slab> slabs_;
    mrpt::poses::CPose3D sensorInMap_;
};

/// A wall in the map for every slab.
inline std::vector<core::Wall> wallsOf(std::span<const Slab> slabs, double sigma = 0.02) {
    std::vector<core::Wall> walls;
    for (const Slab& slab : slabs) walls.push_back({slab.line, sigma});
    return walls;
}

/// Four slabs around the origin, x in [-length / 2, length / 2], y in [-width / 2, width / 2].
inline std::vector<Slab> boxRoom(double length, double width) {
    const double x = length / 2, y = width / 2;
    return {{{{-x, -y}, {x, -y}}}, {{{x, -y}, {x, y}}}, {{{x, y}, {-x, y}}}, {{{-x, y}, {-x, -y}}}};
}

}  // namespace offmap::test
