// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ImagePoints.h>

#include <cmath>
#include <utility>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservation3DRangeScan;
using mrpt::math::TPoint3Df;

constexpr uint32_t none = ImagePoints::none;

TPoint3Df pointAt(const Scan& obs, size_t i) {
    return {obs.points3D_x[i], obs.points3D_y[i], obs.points3D_z[i]};
}

/// A pixel per point, were they numbered so; empty if they cannot be.
using Numbering = std::vector<uint32_t>;

Numbering byPlace(const Scan& obs, const RangeImage& image) {
    Numbering pixels;
    if (obs.points3D_x.size() != image.pixels()) return pixels;
    for (uint32_t pixel = 0; pixel < image.pixels(); ++pixel) pixels.push_back(pixel);
    return pixels;
}

Numbering byIndices(const Scan& obs, const RangeImage& image) {
    const size_t size = obs.points3D_x.size();
    Numbering pixels;
    if (obs.points3D_idxs_x.size() != size || obs.points3D_idxs_y.size() != size) return pixels;
    for (size_t i = 0; i < size; ++i) {
        const size_t row = obs.points3D_idxs_y[i], column = obs.points3D_idxs_x[i];
        const bool inside = row < image.rows() && column < image.columns();
        pixels.push_back(inside ? static_cast<uint32_t>(row * image.columns() + column) : none);
    }
    return pixels;
}

Numbering byOrder(const Scan& obs, const RangeImage& image, size_t layer) {
    Numbering pixels;
    for (uint32_t pixel = 0; pixel < image.pixels(); ++pixel) {
        if (image.steps(layer, pixel) != 0) pixels.push_back(pixel);
    }
    if (pixels.size() != obs.points3D_x.size()) pixels.clear();
    return pixels;
}

/// Whether more than half of the returns among the pixels stand where their points do. These may be
/// in the camera's frame or in the vehicle's.
bool agrees(const Scan& obs, const RangeImage& image, size_t layer, const Numbering& pixels) {
    constexpr float tolerance = 0.05F;  // far more than calibrations differ, far less than a pixel
                                        // anywhere else in the image
    size_t returns = 0, inCamera = 0, inVehicle = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] == none || image.steps(layer, pixels[i]) == 0) continue;
        const TPoint3Df stored = pointAt(obs, i), point = image.point(layer, pixels[i]);
        const TPoint3Df moved(obs.sensorPose.composePoint(mrpt::math::TPoint3D(point)));
        const float far = tolerance * point.norm();
        ++returns;
        inCamera += (stored - point).norm() <= far;
        inVehicle += (stored - moved).norm() <= far;
    }
    return 2 * inCamera > returns || 2 * inVehicle > returns;
}

ImagePoints numbered(const RangeImage& image, size_t layer, const Numbering& pixels) {
    ImagePoints points;
    points.slotOf.reserve(pixels.size());
    for (const uint32_t pixel : pixels) {
        const bool isReturn = pixel != none && image.steps(layer, pixel) != 0;
        points.slotOf.push_back(isReturn ? static_cast<uint32_t>(layer * image.pixels() + pixel)
                                         : none);
    }
    return points;
}

}  // namespace

ImagePoints findImagePoints(const Scan& obs, const RangeImage& image) {
    ImagePoints points;
    points.slotOf.assign(obs.points3D_x.size(), none);
    const Numbering places = byPlace(obs, image), indices = byIndices(obs, image);
    points.organized = !places.empty();
    for (size_t layer = 0; layer < image.layers(); ++layer) {
        if (agrees(obs, image, layer, places)) {
            points.slotOf = numbered(image, layer, places).slotOf;
            return points;
        }
        for (const Numbering& pixels : {indices, byOrder(obs, image, layer)}) {
            if (agrees(obs, image, layer, pixels)) return numbered(image, layer, pixels);
        }
    }
    return points;
}

void filterPoints(Scan& obs, const ImagePoints& points, SlotMask keep, Leftovers leftovers) {
    const size_t size = points.slotOf.size();
    const bool indexed = obs.points3D_idxs_x.size() == size && obs.points3D_idxs_y.size() == size;
    size_t left = 0;
    for (size_t i = 0; i < size; ++i) {
        const uint32_t slot = points.slotOf[i];
        const bool stays = slot == none ? leftovers == Leftovers::Keep : keep[slot] != 0;
        if (!stays && !points.organized) continue;
        const TPoint3Df point = stays ? pointAt(obs, i) : TPoint3Df();
        obs.points3D_x[left] = point.x;
        obs.points3D_y[left] = point.y;
        obs.points3D_z[left] = point.z;
        if (indexed) {
            obs.points3D_idxs_x[left] = obs.points3D_idxs_x[i];
            obs.points3D_idxs_y[left] = obs.points3D_idxs_y[i];
        }
        ++left;
    }
    for (auto* axis : {&obs.points3D_x, &obs.points3D_y, &obs.points3D_z}) axis->resize(left);
    if (!indexed) return;
    obs.points3D_idxs_x.resize(left);
    obs.points3D_idxs_y.resize(left);
}

void storeIndices(Scan& obs, const ImagePoints& points, const RangeImage& image) {
    obs.points3D_idxs_x.assign(points.slotOf.size(), 0);
    obs.points3D_idxs_y.assign(points.slotOf.size(), 0);
    for (size_t i = 0; i < points.slotOf.size(); ++i) {
        if (points.slotOf[i] == none) continue;
        const size_t pixel = points.slotOf[i] % image.pixels();
        obs.points3D_idxs_x[i] = static_cast<uint16_t>(pixel % image.columns());
        obs.points3D_idxs_y[i] = static_cast<uint16_t>(pixel / image.columns());
    }
}

}  // namespace offmap::rawlog
