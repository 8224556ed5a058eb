// SPDX-License-Identifier: BSD-3-Clause
#include "AsPointCloud.h"

#include <offmap/rawlog/RangeImage.h>
#include <offmap/rawlog/RangeImageScan.h>

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservation3DRangeScan;
using mrpt::maps::CPointsMap;

/// Whether the pixels of the intensity image are those of the range image, and in memory.
bool pixelsHaveIntensity(const Scan& obs) {
    return hasRanges(obs) && obs.hasIntensityImage && !obs.intensityImage.isExternallyStored() &&
           obs.doDepthAndIntensityCamerasCoincide() && !obs.intensityImage.isEmpty() &&
           obs.intensityImage.getPixelDepth() == mrpt::img::PixelDepth::D8U &&
           obs.intensityImage.getWidth() == static_cast<size_t>(obs.rangeImage.cols()) &&
           obs.intensityImage.getHeight() == static_cast<size_t>(obs.rangeImage.rows());
}

CPointsMap::Ptr emptyMap(const Scan& obs) {
    if (!pixelsHaveIntensity(obs)) return mrpt::maps::CSimplePointsMap::Create();
    if (obs.intensityImage.isColor()) return mrpt::maps::CColouredPointsMap::Create();
    return mrpt::maps::CPointsMapXYZI::Create();
}

/// Colour or intensity of a pixel, each 0 ... 1; intensity is the first.
mrpt::math::TPoint3Df colourOf(const mrpt::img::CImage& image, size_t pixel) {
    const size_t width = image.getWidth();
    const auto* value = image.ptr<uint8_t>(static_cast<unsigned>(pixel % width),
                                           static_cast<unsigned>(pixel / width));
    const bool colour = image.isColor();  // stored blue, green, red
    const auto share = [&](size_t channel) { return static_cast<float>(value[channel]) / 255.0F; };
    return colour ? mrpt::math::TPoint3Df(share(2), share(1), share(0))
                  : mrpt::math::TPoint3Df(share(0), 0, 0);
}

void insertReturns(CPointsMap& map, const Scan& obs, SlotMask keep) {
    const RangeImage image(obs);
    const bool intensity = pixelsHaveIntensity(obs);
    for (size_t slot = 0; slot < image.slots(); ++slot) {
        if (!keep[slot] || image.steps(slot) == 0) continue;
        const size_t pixel = slot % image.pixels();
        const auto p = image.point(slot / image.pixels(), pixel);
        if (intensity) {
            const auto colour = colourOf(obs.intensityImage, pixel);
            map.insertPointRGB(p.x, p.y, p.z, colour.x, colour.y, colour.z);
        } else {
            map.insertPoint(p.x, p.y, p.z);
        }
    }
}

/// [0, 1] Rec. 601, as MRPT itself turns colours into grey.
float brightnessAt(const mrpt::img::CImage& image, size_t pixel) {
    const auto colour = colourOf(image, pixel);
    if (!image.isColor()) return colour.x;
    return 0.299F * colour.x + 0.587F * colour.y + 0.114F * colour.z;
}

}  // namespace

std::vector<float> brightnessOf(const Scan& obs) {
    if (!pixelsHaveIntensity(obs)) return {};
    const RangeImage image(obs);
    std::vector<float> out(image.slots());
    for (size_t slot = 0; slot < out.size(); ++slot) {
        out[slot] = brightnessAt(obs.intensityImage, slot % image.pixels());
    }
    return out;
}

mrpt::obs::CObservation::Ptr RangeImageScan::asPointCloud(
    const mrpt::obs::CObservation& observation, SlotMask keep,
    const SensorConfig& /*config*/) const {
    checkMask(observation, keep);
    const Scan& obs = dynamic_cast<const Scan&>(observation);
    const auto out = cloudLike(obs, emptyMap(obs));
    if (hasRanges(obs)) {
        insertReturns(*out->pointcloud, obs, keep);
    } else {
        for (size_t i = 0; i < keep.size(); ++i) {
            if (!keep[i]) continue;
            out->pointcloud->insertPoint(obs.points3D_x[i], obs.points3D_y[i], obs.points3D_z[i]);
        }
    }
    return out;
}

}  // namespace offmap::rawlog
