// SPDX-License-Identifier: BSD-3-Clause
#include "PlanScan.h"

#include <offmap/core/CorrectedPose.h>
#include <offmap/view/CorrectedScan.h>
#include <offmap/view/PoseMarks.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace offmap::window {

namespace {

PlanPose onPlan(const mrpt::poses::CPose3D& sensorInMap, const Eigen::Matrix2d& covariance) {
    return {{sensorInMap.x(), sensorInMap.y()}, sensorInMap.yaw(), covariance};
}

}  // namespace

PlanScan planPosesOf(const live::LiveFrame& frame) {
    PlanScan plan;
    const core::ScanColumn* column = view::middleColumn(frame.reduced.organized.scan);
    if (!column) return plan;
    plan.stated =
        onPlan(column->sensor->sensorInMap, column->sensor->groundCovariance.topLeftCorner<2, 2>());
    if (frame.reduced.vehicleInMap && frame.result.alignment) {
        const core::PoseCorrection& correction = frame.result.alignment->correction;
        plan.refined = onPlan(core::correctedSensor(correction, *column),
                              correction.covariance.topLeftCorner<2, 2>());
    }
    return plan;
}

PlanScan planScanOf(const live::LiveFrame& frame) {
    PlanScan plan = planPosesOf(frame);
    const core::OrganizedScan& scan = frame.reduced.organized.scan;
    const auto& labels = frame.result.labels;
    for (const core::ScanColumn& column : scan.columns) {
        if (!column.sensor) continue;
        const mrpt::poses::CPose3D sensorInMap = view::foundSensor(column, frame.result);
        const uint32_t end = std::min(column.end, static_cast<uint32_t>(labels.size()));
        for (uint32_t i = column.begin; i < end; ++i) {
            if (labels[i] != core::PointLabel::Kept) continue;
            const auto place = sensorInMap.composePoint(scan.points[i]);
            plan.kept.emplace_back(place.x, place.y);
        }
    }
    return plan;
}

std::vector<mrpt::math::TPoint2D> ellipseOutline(const PlanPose& pose, double deviations) {
    std::vector<mrpt::math::TPoint2D> outline;
    const Eigen::LLT<Eigen::Matrix2d> root(pose.covariance);
    if (!pose.covariance.allFinite() || root.info() != Eigen::Success) return outline;
    const Eigen::Matrix2d lower = deviations * Eigen::Matrix2d(root.matrixL());
    constexpr int corners = 48;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        const Eigen::Vector2d offset = lower * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        outline.emplace_back(pose.place.x + offset.x(), pose.place.y + offset.y());
    }
    return outline;
}

}  // namespace offmap::window
