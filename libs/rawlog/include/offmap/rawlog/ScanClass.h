// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/rawlog/PoseSource.h>
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// The observations of one turn: one, or the columns of a turned 2D scanner.
using Turn = std::vector<mrpt::obs::CObservation::ConstPtr>;

/// What a turn's slots hold. What is not finite or no return is never removed.
struct ReturnCounts {
    uint64_t returns = 0;     ///< finite and not zero
    uint64_t nonFinite = 0;   ///< NaN or infinity
    uint64_t zero = 0;        ///< no return: range 0, invalid ray
    uint64_t duplicates = 0;  ///< of `returns`: repeat another return of the column exactly
    uint64_t self = 0;        ///< of `returns`: the robot's own, see SelfMask.h
};

/// A return that repeats another one of its column exactly. It is left out of the scan and shares
/// the fate of the point that stands for it.
struct DuplicateReturn {
    uint32_t slot;   ///< of the turn
    uint32_t point;  ///< of the scan
};

struct TurnScan {
    core::OrganizedScan scan;  ///< sourceIndex counts the slots of the whole turn
    std::vector<DuplicateReturn> duplicates;
    ReturnCounts counts;

    /// Makes room for so many more.
    void reserve(size_t columns, size_t points) {
        scan.columns.reserve(scan.columns.size() + columns);
        scan.points.reserve(scan.points.size() + points);
        scan.sourceIndex.reserve(scan.sourceIndex.size() + points);
    }
    /// A return of the column that is being taken.
    void add(const mrpt::math::TPoint3Df& point, uint32_t slot) {
        scan.points.push_back(point);
        scan.sourceIndex.push_back(slot);
    }
};

/// A choice among the slots of one observation.
using SlotMask = std::span<const uint8_t>;

/// What becomes of content that belongs to no slot: a point of a Velodyne scan's stored cloud that
/// none of its returns explains. It goes where the returns go that are not removed.
enum class Leftovers : uint8_t { Keep, Drop };

class ColumnStream;

/// What has to be known of one class of 3D observation to reduce it: where its returns are, and how
/// one is taken out. A slot is a place where a return can stand: a ray, a laser return in a packet,
/// a point. The slots of a turn are numbered through its observations.
class ScanClass {
 public:
    virtual ~ScanClass() = default;

    /// Makes what the observation stores in files of its own part of it; to be called before
    /// anything else. \param rawlogFile such files are looked for beside it
    /// \return whether there was any \throw std::runtime_error naming the file that cannot be read
    virtual bool loadExternal(mrpt::obs::CObservation& /*obs*/,
                              const std::filesystem::path& /*rawlogFile*/) const {
        return false;
    }

    virtual size_t slotCount(const mrpt::obs::CObservation& obs) const = 0;

    /// Columns of returns, each with the pose of its sensor.
    virtual TurnScan organize(const Turn& turn, const PoseSource& poses,
                              const SensorConfig& config) const = 0;

    /// The same, for a turn that is still being taken. By default all columns come at its end.
    /// \param poses, config have to outlive it
    virtual std::unique_ptr<ColumnStream> columnStream(const PoseSource& poses,
                                                       const SensorConfig& config) const;

    /// How bright the return in each slot is: 0 ... 1, NaN where that is not told. Whole numbers
    /// count 255 as 1. Empty: the observation does not tell.
    virtual std::vector<float> intensities(const mrpt::obs::CObservation& /*obs*/) const {
        return {};
    }

    /// The same observation with only the chosen returns; the others become "no return" in its own
    /// encoding. \param keep one entry per slot, 0 or 1
    /// \param leftovers Keep for the reduced observation, Drop for its complement
    virtual mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                                  Leftovers leftovers) const = 0;

    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep) const {
        return withOnly(obs, keep, Leftovers::Keep);
    }

    /// The chosen returns as a CObservationPointCloud of the same time, label and sensor pose.
    virtual mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs,
                                                      SlotMask keep,
                                                      const SensorConfig& config) const = 0;

 protected:
    /// \throw std::invalid_argument unless the mask has one entry per slot.
    void checkMask(const mrpt::obs::CObservation& obs, SlotMask keep) const;
};

}  // namespace offmap::rawlog
