// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/evaluation/OffsetTally.h>
#include <offmap/evaluation/SeenSegments.h>
#include <offmap/evaluation/SurfaceLines.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace offmap::evaluation {

struct PlanCheckConfig {
    double binLength = 0.25;   ///< [m] about, along a wall; a whole number of bins fills it
    double gate = 0.35;        ///< [m] a surface further off its wall is another one
    double maxRange = 100;     ///< [m] of a wall that is looked for on a ray
    uint32_t minSegments = 2;  ///< that show a bin, or show through it
    SurfaceLineConfig line{};
};

/// What became of a bin: the first of these that holds.
enum class BinState : uint8_t {
    Seen,     ///< a surface stands along it within the gate
    Missing,  ///< the sensor looked through it
    Hidden,   ///< things stand in front
    OutOfView,
};

/// Stable snake_case name, as in the profile: "seen", "missing", "hidden", "out_of_view".
std::string_view toString(BinState state);

/// A piece of a wall. Offsets are [m] across it, positive behind it as seen from the sensor.
struct BinCheck {
    double from, to;  ///< [m] along the wall, from its first end
    BinState state = BinState::OutOfView;
    Spread offset;  ///< of the segments on it, weighted by their heights
    std::optional<double> leftFace, rightFace;  ///< [m] the surface seen from that side stands to
                                                ///< the left of the wall, on the way from its first
                                                ///< end to its second
    uint64_t through = 0;                       ///< segments seen through it
    uint64_t inFront = 0;                       ///< segments that hide it
    double clearance = 0;                       ///< [m] of these from the wall, the sum
};

struct WallCheck {
    uint32_t wall;  ///< index into LineMap::walls()
    double length;  ///< [m]
    std::vector<BinCheck> bins;
    double seen = 0, missing = 0, hidden = 0;  ///< [0, 1] of the bins
    Spread
        offset;  ///< of the bins that are seen, each of weight 1; of the spread's own, see spread
    double spread = 0;     ///< [m] standard deviation of all segments about the mean
    double rms = 0;        ///< [m] of the bins' means
    double largest = 0;    ///< [m] the bin's mean that is furthest off, with its sign
    double largestAt = 0;  ///< [m] along the wall, the middle of that bin
    std::optional<double> leftFace, rightFace;  ///< [m] as in BinCheck, the mean
    uint64_t through = 0, inFront = 0;
    double clearance = 0;  ///< [m] mean of what hides it; 0 without
};

/// Compares a plan with what scans show of the building. Memory grows with the walls seen, not with
/// the scans.
class PlanCheck {
 public:
    /// The map must outlive it.
    PlanCheck(const core::LineMap& map, const PlanCheckConfig& config);

    /// One scan's segments, by column.
    void add(std::span<const SeenSegment> segments);

    /// One entry per wall, in the order of the map.
    std::vector<WallCheck> walls() const;

 private:
    struct Bin {
        OffsetTally left, right;  // seen from the wall's left, right
        uint64_t through = 0, inFront = 0;
        double clearance = 0;
    };
    /// How a segment stands to a wall.
    struct Stand {
        uint32_t wall;
        size_t bin;
        double behind;  // [m]
        bool fromLeft;
    };

    void addOne(const SeenSegment& segment, const mrpt::math::TPoint2D* along);
    std::optional<Stand> standAt(uint32_t index, const SeenSegment& segment,
                                 const mrpt::math::TPoint2D* along) const;
    Bin& binOf(uint32_t wall, size_t bin);
    size_t binsOf(uint32_t wall) const;
    size_t binAt(uint32_t wall, double share) const;
    BinCheck checkOf(const Bin& bin) const;

    const core::LineMap& map_;
    PlanCheckConfig config_;
    std::vector<std::vector<Bin>> bins_;  // per wall; empty if nothing was seen of it
};

}  // namespace offmap::evaluation
