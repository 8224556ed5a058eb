// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace offmap::test {

/// A return as its observation encodes it: (packet, block, slot, distance, intensity) of a
/// Velodyne, (ray, range) of a 2D scan, (x, y, z, intensity) of a cloud, (layer, row, column,
/// steps) of a depth camera, and (-1, x, y, z) of its points, (layer, row, column, steps,
/// intensity) of a rotating scan.
using Return = std::array<double, 5>;

inline void addReturns(std::vector<Return>& returns,
                       const mrpt::obs::CObservation3DRangeScan& obs) {
    const auto addLayer = [&](const mrpt::math::CMatrix_u16& image, double layer) {
        for (int i = 0; i < image.rows() * image.cols(); ++i) {
            if (image.data()[i] == 0) continue;
            returns.push_back({layer, static_cast<double>(i / obs.rangeImage.cols()),
                               static_cast<double>(i % obs.rangeImage.cols()),
                               static_cast<double>(image.data()[i])});
        }
    };
    double layer = 0;
    addLayer(obs.rangeImage, layer);
    for (const auto& [name, image] : obs.rangeImageOtherLayers) addLayer(image, ++layer);
    for (size_t i = 0; obs.hasPoints3D && i < obs.points3D_x.size(); ++i) {
        const Return point{-1, obs.points3D_x[i], obs.points3D_y[i], obs.points3D_z[i]};
        if (point != Return{-1}) returns.push_back(point);
    }
}

/// \param layer 0: the range image
inline void addReturns(std::vector<Return>& returns, const mrpt::math::CMatrix_u16& image,
                       double layer, const mrpt::math::CMatrix_u8* intensities) {
    for (int row = 0; row < image.rows(); ++row) {
        for (int column = 0; column < image.cols(); ++column) {
            if (image(row, column) == 0) continue;
            const double intensity = intensities ? (*intensities)(row, column) : 0;
            returns.push_back({layer, static_cast<double>(row), static_cast<double>(column),
                               static_cast<double>(image(row, column)), intensity});
        }
    }
}

inline void addReturns(std::vector<Return>& returns,
                       const mrpt::obs::CObservationRotatingScan& obs) {
    const bool hasIntensity = obs.intensityImage.rows() == obs.rangeImage.rows() &&
                              obs.intensityImage.cols() == obs.rangeImage.cols();
    double layer = 0;
    addReturns(returns, obs.rangeImage, layer, hasIntensity ? &obs.intensityImage : nullptr);
    for (const auto& [name, image] : obs.rangeOtherLayers) {
        addReturns(returns, image, ++layer, nullptr);
    }
}

/// The returns of an observation, sorted.
inline std::vector<Return> returnsOf(const mrpt::obs::CObservation& obs) {
    std::vector<Return> returns;
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs)) {
        for (size_t i = 0; i < scan->getScanSize(); ++i) {
            if (!scan->getScanRangeValidity(i)) continue;
            returns.push_back({static_cast<double>(i), scan->getScanRange(i)});
        }
    } else if (const auto* turn = dynamic_cast<const mrpt::obs::CObservationVelodyneScan*>(&obs)) {
        for (size_t p = 0; p < turn->scan_packets.size(); ++p) {
            for (size_t b = 0; b < 12; ++b) {
                for (size_t s = 0; s < 32; ++s) {
                    const auto& hit = turn->scan_packets[p].blocks[b].laser_returns[s];
                    if (hit.distance() == 0) continue;
                    returns.push_back({static_cast<double>(p), static_cast<double>(b),
                                       static_cast<double>(s), static_cast<double>(hit.distance()),
                                       static_cast<double>(hit.intensity())});
                }
            }
        }
    } else if (const auto* rotating =
                   dynamic_cast<const mrpt::obs::CObservationRotatingScan*>(&obs)) {
        addReturns(returns, *rotating);
    } else if (const auto* cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&obs)) {
        for (size_t i = 0; i < cloud->pointcloud->size(); ++i) {
            float x = 0, y = 0, z = 0, intensity = 0, unused = 0;
            cloud->pointcloud->getPointRGB(i, x, y, z, intensity, unused, unused);
            returns.push_back({x, y, z, intensity});
        }
    }
    if (const auto* image = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&obs)) {
        addReturns(returns, *image);
    }
    std::sort(returns.begin(), returns.end());
    return returns;
}

/// Both together, sorted; a return in both is there twice.
inline std::vector<Return> together(const std::vector<Return>& a, const std::vector<Return>& b) {
    std::vector<Return> all;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
}

inline bool is3dScan(const mrpt::obs::CObservation& obs) {
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs)) {
        return !scan->isPlanarScan(0.1);
    }
    return dynamic_cast<const mrpt::obs::CObservationVelodyneScan*>(&obs) ||
           dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&obs) ||
           dynamic_cast<const mrpt::obs::CObservationRotatingScan*>(&obs) ||
           dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&obs);
}

}  // namespace offmap::test
