// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Reducer.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/ScanClass.h>

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <ranges>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// The x, y, z of any range of points that have them, such as those of a pcl::PointCloud.
template <std::ranges::input_range Points>
std::vector<mrpt::math::TPoint3Df> xyzOf(const Points& points) {
    std::vector<mrpt::math::TPoint3Df> out;
    for (const auto& p : points) {
        out.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
    }
    return out;
}

/// Finds the returns in clouds of a program's own that the map knows. Keeps its working memory from
/// cloud to cloud; one per thread.
class CloudReducer {
 public:
    /// The map must outlive it. Of `config`, what is said of the reduction and of all sensors
    /// holds. \throw std::invalid_argument if the configuration is not valid.
    explicit CloudReducer(const core::LineMap& map, const Config& config = {});

    /// \param points [m] in the sensor's frame, in any order, compensated for movement. What is not
    /// finite or the origin is no return, and kept
    /// \param vehicleInMap where the vehicle was. An estimate that is not finite, or whose
    /// covariance is none, lets everything stay
    /// \param sensorInVehicle the mounting; the identity if the estimate is the sensor's own
    /// \return one label per point, in the order of `points`; core::isRemoved() tells which go. It
    /// belongs to the reducer and holds until the next call
    const std::vector<core::PointLabel>& reduce(std::span<const mrpt::math::TPoint3Df> points,
                                                const mrpt::poses::CPose3DPDFGaussian& vehicleInMap,
                                                const mrpt::poses::CPose3D& sensorInVehicle = {});

    /// Of the last cloud: its columns; sourceIndex counts its points.
    const TurnScan& organized() const { return organized_; }
    /// Of the last cloud: segments and verdicts, and whether it was kept whole, and why. \pre
    /// there was one
    const core::ReductionResult& result() const { return *result_; }

 private:
    core::Reducer reducer_;
    SensorConfig sensor_;
    TurnScan organized_;
    const core::ReductionResult* result_ = nullptr;
    std::vector<core::PointLabel> labels_;
};

}  // namespace offmap::rawlog
