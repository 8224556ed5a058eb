// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/World.h>

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::evaluation {

/// A return of a log, and what it truly comes from.
struct TruePoint {
    mrpt::math::TPoint3Df point;  ///< [m] finite; exactly what a reader of the log decodes
    bool mapped = false;          ///< the map shows the surface that it comes from
    SurfaceKind kind = SurfaceKind::Object;
    std::optional<float> standOff = {};  ///< [m] of an object before the nearest wall of the map
    bool onVerticalSegment = false;

    friend bool operator==(const TruePoint&, const TruePoint&) = default;
};

/// All returns of one observation of a log.
struct ObservationTruth {
    uint64_t scan = 0;  ///< number of its turn; the columns of a turned 2D scanner share one
    mrpt::Clock::time_point time{};  ///< the observation's
    std::string sensor;              ///< its label
    std::vector<TruePoint> points;
};

/// Writes the ground truth of a log's returns as CSV, a row each, observation by observation in the
/// order of the log. doc/formats.md tells what its columns mean.
class TruthWriter {
 public:
    /// Takes the text piece by piece; it may well be compressed.
    using Sink = std::function<void(std::string_view)>;

    explicit TruthWriter(Sink sink);

    /// An observation without returns leaves no row.
    /// \throw std::invalid_argument if no reader could tell it again: a point or stand-off that is
    /// not finite, a label with a line break, time and label of the observation before
    void add(const ObservationTruth& observation);

 private:
    Sink sink_;
    std::string rows_;  ///< of one observation; reused
    std::string key_;   ///< the first fields of the latest rows
};

class GzipLines;

/// Reads such a file, plain or gzip, observation by observation, so that it costs no memory.
class TruthReader {
 public:
    /// \throw std::runtime_error naming the file, the line, the cause and the fix, as all members
    /// do.
    explicit TruthReader(const std::filesystem::path& file);
    ~TruthReader();

    /// The next observation; null at the end. Holds until the next call.
    const ObservationTruth* next();

 private:
    std::unique_ptr<GzipLines> lines_;
    ObservationTruth current_;
    std::string key_;  ///< the first fields of each of its rows, as they stand in the file
    std::optional<std::string> ahead_;  ///< the first row of the next one
};

}  // namespace offmap::evaluation
