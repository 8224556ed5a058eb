// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/ScanBuilder.h"

#include <offmap/core/Reducer.h>

#include <span>
#include <vector>

namespace offmap::test {

/// A room of 8 x 6 m; a child and a box stand in it that the map does not show. Over both, enough
/// of the wall behind is seen to make a segment.
inline std::vector<Slab> roomWithTwo() {
    auto slabs = boxRoom(8, 6);
    slabs.push_back({{{2, -0.3}, {2, 0.3}}, 0, 1.4});
    slabs.push_back({{{-1, 1.5}, {-0.4, 1.6}}, 0, 0.8});
    return slabs;
}
inline constexpr int mappedSlabs = 4;

inline Eigen::Matrix3d usualCovariance() {
    return Eigen::Vector3d(0.03 * 0.03, 0.02 * 0.02, 0.005 * 0.005).asDiagonal();
}

struct SmallRoom {
    mrpt::poses::CPose3D sensor{0.4, -0.3, 1.1, 0.2, 0, 0};
    BuiltScan built = ScanBuilder(slabs(), sensor).build({}, usualCovariance());
    core::LineMap map{wallsOf(std::span(slabs()).first(mappedSlabs))};

    static const std::vector<Slab>& slabs() {
        static const std::vector<Slab> slabs = roomWithTwo();
        return slabs;
    }
};

inline std::vector<core::PointLabel> labelsOf(const core::LineMap& map,
                                              const core::OrganizedScan& scan,
                                              const core::ReductionConfig& config = {}) {
    return core::Reducer(map, config).reduce(scan).labels;
}

}  // namespace offmap::test
