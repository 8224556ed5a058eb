// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudReducer.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/PlacedCloud.h>
#include <offmap/rawlog/SelfMask.h>

namespace offmap::rawlog {

namespace {

const Config& checked(const Config& config) {
    config.validate();
    return config;
}

}  // namespace

CloudReducer::CloudReducer(const core::LineMap& map, const Config& config)
    : reducer_(map, checked(config).reduction), sensor_(config.sensor) {}

const std::vector<core::PointLabel>& CloudReducer::reduce(
    std::span<const mrpt::math::TPoint3Df> points,
    const mrpt::poses::CPose3DPDFGaussian& vehicleInMap,
    const mrpt::poses::CPose3D& sensorInVehicle) {
    organized_ = {};
    const CloudArrays arrays(points);
    appendCloud(organized_, {arrays.points(), {}, FixedPose(vehicleInMap).at({}), sensorInVehicle},
                0, sensor_);
    maskSelfReturns(organized_, sensor_);
    result_ = &reducer_.reduce(organized_.scan);
    labels_.assign(points.size(), core::PointLabel::NotOnVerticalSegment);
    for (size_t i = 0; i < result_->labels.size(); ++i) {
        labels_[organized_.scan.sourceIndex[i]] = result_->labels[i];
    }
    for (const DuplicateReturn& duplicate : organized_.duplicates) {
        labels_[duplicate.slot] = result_->labels[duplicate.point];
    }
    return labels_;
}

}  // namespace offmap::rawlog
