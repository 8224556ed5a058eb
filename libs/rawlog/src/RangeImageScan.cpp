// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/ImageColumns.h>
#include <offmap/rawlog/ImagePoints.h>
#include <offmap/rawlog/RangeImageScan.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservation3DRangeScan;
using mrpt::math::TPoint3Df;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

core::ScanColumn columnOf(const Scan& obs, const PoseSource& poses,
                          const mrpt::poses::CPose3D& mounting) {
    core::ScanColumn column;
    column.time = obs.timestamp;
    placeColumn(column, poses.at(obs.timestamp), mounting);
    return column;
}

/// Adds the pixel's return in this layer, and those of later layers that equal it; nothing if an
/// earlier layer had it.
void addReturns(std::vector<ColumnReturn>& returns, const RangeImage& image, size_t layer,
                uint32_t pixel, uint32_t firstSlot, ReturnCounts& counts) {
    const uint16_t steps = image.steps(layer, pixel);
    if (steps == 0) {
        ++counts.zero;
        return;
    }
    for (size_t earlier = 0; earlier < layer; ++earlier) {
        if (image.steps(earlier, pixel) == steps) return;
    }
    const TPoint3Df point = image.point(layer, pixel);
    for (size_t l = layer; l < image.layers(); ++l) {
        if (image.steps(l, pixel) != steps || !countReturn(counts, point)) continue;
        returns.push_back({point, firstSlot + static_cast<uint32_t>(l * image.pixels() + pixel)});
    }
}

void appendImage(TurnScan& out, const Scan& obs, uint32_t firstSlot, const PoseSource& poses,
                 const SensorConfig& config) {
    const mrpt::poses::CPose3D mounting = sensorInVehicle(obs, config);
    const RangeImage image(obs);
    core::ScanColumn column = columnOf(obs, poses, mounting);
    std::vector<ColumnReturn> returns;
    const auto imageColumns = findImageColumns(image, mounting, config.columnWidth);
    out.reserve(imageColumns.size(), image.pixels());
    for (size_t layer = 0; layer < image.layers(); ++layer) {
        for (const ImageColumn& imageColumn : imageColumns) {
            returns.clear();
            for (const uint32_t pixel : imageColumn.pixels) {
                addReturns(returns, image, layer, pixel, firstSlot, out.counts);
            }
            if (returns.empty() && layer > 0) continue;
            column.azimuth = static_cast<float>(imageColumn.azimuth);
            appendColumn(out, column, mounting, returns);
        }
    }
}

/// Stored points alone.
void appendPoints(TurnScan& out, const Scan& obs, uint32_t firstSlot, const PoseSource& poses,
                  const SensorConfig& config) {
    const mrpt::poses::CPose3D mounting = sensorInVehicle(obs, config);
    std::vector<ColumnReturn> returns;
    CloudArrays levelled;  // in the vehicle's axes
    for (size_t i = 0; i < obs.points3D_x.size(); ++i) {
        const TPoint3Df point(obs.points3D_x[i], obs.points3D_y[i], obs.points3D_z[i]);
        if (!countReturn(out.counts, point)) continue;
        returns.push_back({point, firstSlot + static_cast<uint32_t>(i)});
        levelled.add(TPoint3Df(mounting.rotateVector(mrpt::math::TVector3D(point))));
    }
    const CloudColumns columns = findCloudColumns(levelled.points(), config.columnWidth);
    std::vector<std::vector<ColumnReturn>> byColumn(columns.azimuths.size());
    for (const ColumnRun& run : columns.runs) {
        for (uint32_t i = run.begin; i < run.end; ++i) byColumn[run.column].push_back(returns[i]);
    }
    core::ScanColumn column = columnOf(obs, poses, mounting);
    for (size_t c = 0; c < byColumn.size(); ++c) {
        column.azimuth = static_cast<float>(columns.azimuths[c]);
        appendColumn(out, column, mounting, byColumn[c]);
    }
}

/// Every stored point a slot of its own.
ImagePoints pointsAlone(const Scan& obs) {
    ImagePoints points;
    for (uint32_t i = 0; i < obs.points3D_x.size(); ++i) points.slotOf.push_back(i);
    points.organized =
        points.slotOf.size() == uint64_t{obs.cameraParams.ncols} * obs.cameraParams.nrows;
    return points;
}

void zeroRanges(Scan& obs, SlotMask keep) {
    size_t slot = 0;
    const auto apply = [&](mrpt::math::CMatrix_u16& layer) {
        uint16_t* steps = layer.data();
        const auto pixels = static_cast<size_t>(layer.rows()) * static_cast<size_t>(layer.cols());
        for (size_t pixel = 0; pixel < pixels; ++pixel) {
            if (!keep[slot++]) steps[pixel] = 0;
        }
    };
    apply(obs.rangeImage);
    for (auto& [name, layer] : obs.rangeImageOtherLayers) apply(layer);
}

bool pointsHaveOneSize(const Scan& obs) {
    return obs.points3D_x.size() == obs.points3D_y.size() &&
           obs.points3D_x.size() == obs.points3D_z.size();
}

}  // namespace

size_t RangeImageScan::slotCount(const mrpt::obs::CObservation& observation) const {
    const Scan& obs = asScan(observation);
    if ((obs.hasRangeImage && obs.rangeImage_isExternallyStored()) ||
        (obs.hasPoints3D && obs.points3D_isExternallyStored())) {
        throw std::logic_error(
            fmt::format("ranges or points of '{}' are still in a file", obs.sensorLabel));
    }
    if (!hasRanges(obs)) return obs.hasPoints3D ? obs.points3D_x.size() : 0;
    return static_cast<size_t>(obs.rangeImage.size()) * (1 + obs.rangeImageOtherLayers.size());
}

TurnScan RangeImageScan::organize(const Turn& turn, const PoseSource& poses,
                                  const SensorConfig& config) const {
    TurnScan out;
    size_t firstSlot = 0;
    for (const auto& member : turn) {
        const Scan& obs = asScan(*member);
        const size_t slots = slotCount(obs);
        const auto append = hasRanges(obs) ? appendImage : appendPoints;
        if (slots > 0) append(out, obs, static_cast<uint32_t>(firstSlot), poses, config);
        firstSlot += slots;
    }
    return out;
}

mrpt::obs::CObservation::Ptr RangeImageScan::withOnly(const mrpt::obs::CObservation& observation,
                                                      SlotMask keep, Leftovers leftovers) const {
    checkMask(observation, keep);
    const Scan& obs = asScan(observation);
    auto out = std::make_shared<Scan>(obs);
    const bool ranges = hasRanges(obs);
    if (obs.hasPoints3D && !obs.points3D_x.empty()) {
        const auto points = ranges ? findImagePoints(obs, RangeImage(obs)) : pointsAlone(obs);
        filterPoints(*out, points, keep, leftovers);
    }
    if (ranges) zeroRanges(*out, keep);
    return out;
}

std::optional<std::string> unsupportedRangeImage(const Scan& obs) {
    std::optional<std::string> fault;
    if (hasRanges(obs)) {
        fault = rangeImageFault(obs);
    } else if (!obs.hasPoints3D) {
        fault = "neither a range image nor points";
    }
    if (obs.hasPoints3D && !pointsHaveOneSize(obs)) fault = "its points lack coordinates";
    if (!fault) return {};
    return fmt::format("CObservation3DRangeScan: {}, copied unchanged", *fault);
}

}  // namespace offmap::rawlog
