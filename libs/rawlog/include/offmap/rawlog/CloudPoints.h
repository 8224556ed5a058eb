// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cstddef>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// Points whose x, y and z [m] stand in an array each, as MRPT's maps keep them: so many can be
/// looked at in one step.
struct CloudPoints {
    std::span<const float> x, y, z;  ///< of one size

    size_t size() const { return x.size(); }
    mrpt::math::TPoint3Df operator[](size_t i) const { return {x[i], y[i], z[i]}; }
    CloudPoints subspan(size_t first, size_t count) const {
        return {x.subspan(first, count), y.subspan(first, count), z.subspan(first, count)};
    }
};

/// The arrays for points that stand otherwise.
class CloudArrays {
 public:
    CloudArrays() = default;
    explicit CloudArrays(std::span<const mrpt::math::TPoint3Df> points) {
        reserve(points.size());
        for (const auto& point : points) add(point);
    }
    void reserve(size_t points) {
        for (auto* array : {&x_, &y_, &z_}) array->reserve(points);
    }
    void add(const mrpt::math::TPoint3Df& point) {
        x_.push_back(point.x);
        y_.push_back(point.y);
        z_.push_back(point.z);
    }
    /// Holds until a point is added.
    CloudPoints points() const { return {x_, y_, z_}; }

 private:
    std::vector<float> x_, y_, z_;
};

}  // namespace offmap::rawlog
