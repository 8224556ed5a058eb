// SPDX-License-Identifier: BSD-3-Clause
#include "AsPointCloud.h"

#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/RotatingGeometry.h>
#include <offmap/rawlog/RotatingScan.h>

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <limits>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationRotatingScan;
using Image = mrpt::math::CMatrix_u16;

const Scan& asScan(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Scan&>(obs); }

/// The range image and the other layers, in the order of their slots.
std::vector<const Image*> imagesOf(const Scan& obs) {
    std::vector<const Image*> images{&obs.rangeImage};
    for (const auto& [name, layer] : obs.rangeOtherLayers) images.push_back(&layer);
    return images;
}

size_t cellsOf(const Scan& obs) { return size_t{obs.rowCount} * obs.columnCount; }

uint16_t valueAt(const Image& image, uint32_t row, uint32_t column) {
    return image(static_cast<int>(row), static_cast<int>(column));
}

/// The columns of one image that stand at the same place of their firings: of each beam, they hold
/// one return.
struct Track {
    const Image* image;
    uint32_t firstSlot;     ///< of the image, in the turn
    uint32_t columnOffset;  ///< from the firing's first column
};

std::vector<Track> tracksOf(const Scan& obs, uint32_t firstSlot, uint32_t columnsPerFiring) {
    std::vector<Track> tracks;
    for (const Image* image : imagesOf(obs)) {
        for (uint32_t offset = 0; offset < columnsPerFiring; ++offset) {
            tracks.push_back({image, firstSlot, offset});
        }
        firstSlot += static_cast<uint32_t>(cellsOf(obs));
    }
    return tracks;
}

class Organizer {
 public:
    Organizer(TurnScan& out, const Scan& obs, uint32_t firstSlot, const PoseSource& poses,
              const SensorConfig& config)
        : out_(out),
          obs_(obs),
          poses_(poses),
          mounting_(sensorInVehicle(obs, config)),
          geometry_(obs, config),
          tracks_(tracksOf(obs, firstSlot, geometry_.columnsPerFiring())) {}

    void append() {
        const uint32_t columns = geometry_.columns(), step = geometry_.columnsPerFiring();
        for (size_t t = 0; t < tracks_.size(); ++t) {
            for (uint32_t firing = 0; firing < columns; firing += step) {
                gather(t, firing);
                if (!returns_.empty()) appendReturns(firing);
            }
        }
        out_.counts.zero += imagesOf(obs_).size() * cellsOf(obs_) - values_;
    }

 private:
    uint16_t value(size_t track, uint32_t row, uint32_t firing) const {
        return valueAt(*tracks_[track].image, row, firing + tracks_[track].columnOffset);
    }

    bool repeatsAnEarlierTrack(size_t track, uint32_t row, uint32_t firing) const {
        for (size_t earlier = 0; earlier < track; ++earlier) {
            if (value(earlier, row, firing) == value(track, row, firing)) return true;
        }
        return false;
    }

    /// The returns of a firing that a track is the first to hold, and those that repeat them.
    void gather(size_t track, uint32_t firing) {
        returns_.clear();
        for (uint32_t row = 0; row < obs_.rowCount; ++row) {
            const uint16_t range = value(track, row, firing);
            if (range == 0 || repeatsAnEarlierTrack(track, row, firing)) continue;
            const auto point = geometry_.point(row, firing, range);
            for (size_t t = track; t < tracks_.size(); ++t) {
                if (value(t, row, firing) != range) continue;
                ++values_;
                if (!countReturn(out_.counts, point)) continue;
                const uint32_t column = firing + tracks_[t].columnOffset;
                returns_.push_back({point, tracks_[t].firstSlot + row * obs_.columnCount + column});
            }
        }
    }

    void appendReturns(uint32_t firing) {
        core::ScanColumn column;
        column.azimuth = static_cast<float>(azimuthInVehicle(geometry_.azimuth(firing), mounting_));
        column.time = geometry_.time(firing);
        placeColumn(column, poses_.at(column.time), mounting_);
        appendColumn(out_, column, mounting_, returns_);
    }

    TurnScan& out_;
    const Scan& obs_;
    const PoseSource& poses_;
    mrpt::poses::CPose3D mounting_;
    RotatingGeometry geometry_;
    std::vector<Track> tracks_;
    std::vector<ColumnReturn> returns_;
    uint64_t values_ = 0;  // cells that are not 0
};

bool hasIntensity(const Scan& obs) {
    return obs.intensityImage.rows() == obs.rowCount &&
           obs.intensityImage.cols() == obs.columnCount;
}

/// Puts the points of the chosen slots into a map.
template <class Insert>
void insertPoints(const Scan& obs, SlotMask keep, const SensorConfig& config, Insert&& insert) {
    const RotatingGeometry geometry(obs, config);
    size_t slot = 0;
    for (const Image* image : imagesOf(obs)) {
        for (uint32_t row = 0; row < obs.rowCount; ++row) {
            for (uint32_t column = 0; column < obs.columnCount; ++column) {
                const uint16_t value = valueAt(*image, row, column);
                if (!keep[slot++] || value == 0) continue;
                insert(geometry.point(row, column, value), image == &obs.rangeImage, row, column);
            }
        }
    }
}

}  // namespace

size_t RotatingScan::slotCount(const mrpt::obs::CObservation& obs) const {
    return cellsOf(asScan(obs)) * (1 + asScan(obs).rangeOtherLayers.size());
}

std::vector<float> RotatingScan::intensities(const mrpt::obs::CObservation& obs) const {
    const Scan& scan = asScan(obs);
    if (!hasIntensity(scan)) return {};
    // Of other layers' returns, the image says nothing.
    std::vector<float> out(slotCount(obs), std::numeric_limits<float>::quiet_NaN());
    size_t slot = 0;
    for (int row = 0; row < scan.intensityImage.rows(); ++row) {
        for (int column = 0; column < scan.intensityImage.cols(); ++column) {
            out[slot++] = static_cast<float>(scan.intensityImage(row, column)) / 255.0F;
        }
    }
    return out;
}

TurnScan RotatingScan::organize(const Turn& turn, const PoseSource& poses,
                                const SensorConfig& config) const {
    TurnScan out;
    size_t firstSlot = 0;
    for (const auto& obs : turn) {
        Organizer(out, asScan(*obs), static_cast<uint32_t>(firstSlot), poses, config).append();
        firstSlot += slotCount(*obs);
    }
    return out;
}

mrpt::obs::CObservation::Ptr RotatingScan::withOnly(const mrpt::obs::CObservation& obs,
                                                    SlotMask keep, Leftovers /*leftovers*/) const {
    checkMask(obs, keep);
    auto out = std::make_shared<Scan>(asScan(obs));
    size_t slot = 0;
    const auto clear = [&](Image& image, mrpt::math::CMatrix_u8* intensities) {
        for (int row = 0; row < image.rows(); ++row) {
            for (int column = 0; column < image.cols(); ++column) {
                if (keep[slot++]) continue;
                image(row, column) = 0;
                if (intensities) (*intensities)(row, column) = 0;
            }
        }
    };
    clear(out->rangeImage, hasIntensity(*out) ? &out->intensityImage : nullptr);
    for (auto& [name, layer] : out->rangeOtherLayers) clear(layer, nullptr);
    return out;
}

mrpt::obs::CObservation::Ptr RotatingScan::asPointCloud(const mrpt::obs::CObservation& obs,
                                                        SlotMask keep,
                                                        const SensorConfig& config) const {
    checkMask(obs, keep);
    const Scan& scan = asScan(obs);
    if (hasIntensity(scan)) {
        auto cloud = mrpt::maps::CPointsMapXYZI::Create();
        insertPoints(
            scan, keep, config, [&](const auto& p, bool first, uint32_t row, uint32_t column) {
                const int full =
                    first ? scan.intensityImage(static_cast<int>(row), static_cast<int>(column))
                          : 0;
                cloud->insertPointRGB(p.x, p.y, p.z, static_cast<float>(full) / 255.0F, 0, 0);
            });
        return cloudLike(scan, cloud);
    }
    auto cloud = mrpt::maps::CSimplePointsMap::Create();
    insertPoints(scan, keep, config, [&](const auto& p, bool, uint32_t, uint32_t) {
        cloud->insertPoint(p.x, p.y, p.z);
    });
    return cloudLike(scan, cloud);
}

}  // namespace offmap::rawlog
