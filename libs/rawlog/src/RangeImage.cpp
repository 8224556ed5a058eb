// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RangeImage.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservation3DRangeScan;
using mrpt::math::TPoint3Df;

/// The rays by the camera alone: MRPT keeps a table for each pose of a sensor too. A distortion
/// that cannot be undone leaves the origin.
std::vector<TPoint3Df> raysOf(const Scan& obs) {
    Scan camera;
    camera.cameraParams = obs.cameraParams;
    camera.range_is_depth = obs.range_is_depth;
    camera.rangeImage.setSize(obs.rangeImage.rows(), obs.rangeImage.cols());
    static std::mutex filling;  // MRPT fills a new table without a lock
    const std::lock_guard lock(filling);
    const Scan::unproject_LUT_t& table = camera.get_unproj_lut();
    std::vector<TPoint3Df> rays(table.Kxs.size());
    for (size_t i = 0; i < rays.size(); ++i) {
        const TPoint3Df ray(table.Kxs[i], table.Kys[i], table.Kzs[i]);
        const bool finite = std::isfinite(ray.x) && std::isfinite(ray.y) && std::isfinite(ray.z);
        if (finite) rays[i] = ray;
    }
    return rays;
}

std::optional<std::string> cameraFault(const mrpt::img::TCamera& camera) {
    if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt) {
        return "a fisheye camera (kannala_brandt) is not supported yet";
    }
    const bool sane = camera.fx() > 0 && camera.fy() > 0 && std::isfinite(camera.fx()) &&
                      std::isfinite(camera.fy()) && std::isfinite(camera.cx()) &&
                      std::isfinite(camera.cy()) &&
                      std::ranges::all_of(camera.dist, [](double d) { return std::isfinite(d); });
    if (!sane) {
        return fmt::format("the camera has no valid calibration (fx {:g}, fy {:g})", camera.fx(),
                           camera.fy());
    }
    return {};
}

std::optional<std::string> sizeFault(const Scan& obs) {
    const auto rows = obs.rangeImage.rows(), columns = obs.rangeImage.cols();
    if (obs.cameraParams.nrows != static_cast<uint64_t>(rows) ||
        obs.cameraParams.ncols != static_cast<uint64_t>(columns)) {
        return fmt::format(
            "the camera's calibration is for {} x {} pixels, the range image has {} x {}",
            obs.cameraParams.ncols, obs.cameraParams.nrows, columns, rows);
    }
    for (const auto& [name, layer] : obs.rangeImageOtherLayers) {
        // MRPT 2.5.8 stores a layer's sizes in the wrong order: one that was read has rows and
        // columns exchanged, its pixels in their right order.
        const bool same = layer.rows() == rows && layer.cols() == columns;
        const bool exchanged = layer.rows() == columns && layer.cols() == rows;
        if (!same && !exchanged) {
            return fmt::format("layer '{}' has {} x {} pixels, the range image {} x {}", name,
                               layer.cols(), layer.rows(), columns, rows);
        }
    }
    const uint64_t slots = static_cast<uint64_t>(rows) * static_cast<uint64_t>(columns) *
                           (1 + obs.rangeImageOtherLayers.size());
    if (slots > std::numeric_limits<uint32_t>::max()) return "the range image is too large";
    return {};
}

}  // namespace

RangeImage::RangeImage(const Scan& obs)
    : rows_(static_cast<size_t>(obs.rangeImage.rows())),
      columns_(static_cast<size_t>(obs.rangeImage.cols())),
      unit_(obs.rangeUnits),
      layers_{obs.rangeImage.data()},
      rays_(raysOf(obs)) {
    for (const auto& [name, layer] : obs.rangeImageOtherLayers) layers_.push_back(layer.data());
}

bool hasRanges(const Scan& obs) {
    return obs.hasRangeImage && (obs.rangeImage_isExternallyStored() || obs.rangeImage.size() != 0);
}

std::optional<std::string> rangeImageFault(const Scan& obs) {
    if (!(obs.rangeUnits > 0) || !std::isfinite(obs.rangeUnits)) {
        return fmt::format("rangeUnits is {:g}", obs.rangeUnits);
    }
    if (auto fault = cameraFault(obs.cameraParams)) return fault;
    if (obs.rangeImage_isExternallyStored()) return {};
    return sizeFault(obs);
}

}  // namespace offmap::rawlog
