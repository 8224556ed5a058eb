// SPDX-License-Identifier: BSD-3-Clause
#include "SmallRoom.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace offmap::core {

using mrpt::poses::CPose3D;
using test::labelsOf;
using Room = test::SmallRoom;

namespace {

/// The columns of a scan in another order.
OrganizedScan rearranged(const OrganizedScan& scan, const std::vector<uint32_t>& columns) {
    OrganizedScan out;
    for (const uint32_t c : columns) {
        ScanColumn column = scan.columns[c];
        column.begin = static_cast<uint32_t>(out.points.size());
        for (uint32_t i = scan.columns[c].begin; i < scan.columns[c].end; ++i) {
            out.points.push_back(scan.points[i]);
            out.sourceIndex.push_back(scan.sourceIndex[i]);
        }
        column.end = static_cast<uint32_t>(out.points.size());
        out.columns.push_back(column);
    }
    return out;
}

/// Labels by source index.
std::vector<PointLabel> inSourceOrder(const OrganizedScan& scan,
                                      const std::vector<PointLabel>& labels) {
    std::vector<PointLabel> ordered(labels.size());
    for (size_t i = 0; i < labels.size(); ++i) ordered[scan.sourceIndex[i]] = labels[i];
    return ordered;
}

}  // namespace

TEST(ReducerInvariance, rotatingWorldAndPoseTogetherChangesNoLabel) {
    const Room room;
    const auto expected = labelsOf(room.map, room.built.scan);
    for (const mrpt::math::TPose2D motion :
         {mrpt::math::TPose2D(0, 0, 0.7), mrpt::math::TPose2D(100, -50, 0),
          mrpt::math::TPose2D(-3, 8, 2.5)}) {
        auto walls = room.map.walls();
        for (Wall& wall : walls) {
            wall.line = {motion.composePoint(wall.line.point1),
                         motion.composePoint(wall.line.point2)};
        }
        OrganizedScan moved = room.built.scan;
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(motion.phi).toRotationMatrix();
        for (ScanColumn& column : moved.columns) {
            column.sensor->sensorInMap = CPose3D(motion) + column.sensor->sensorInMap;
            column.sensor->groundCovariance =
                turn * column.sensor->groundCovariance * turn.transpose();
        }
        EXPECT_EQ(labelsOf(LineMap(walls), moved), expected);
    }
}

TEST(ReducerInvariance, clockwiseColumnsChangeNoLabel) {
    const Room room;
    const auto& scan = room.built.scan;
    std::vector<uint32_t> backwards;
    for (size_t c = scan.columns.size(); c > 0; --c) backwards.push_back(uint32_t(c - 1));
    const OrganizedScan clockwise = rearranged(scan, backwards);
    EXPECT_EQ(inSourceOrder(clockwise, labelsOf(room.map, clockwise)), labelsOf(room.map, scan));
}

TEST(ReducerInvariance, columnThatAFullTurnBeginsWithChangesNoLabel) {
    const Room room;
    const auto& scan = room.built.scan;
    const auto expected = labelsOf(room.map, scan);
    const auto columns = static_cast<uint32_t>(scan.columns.size());
    for (const uint32_t first : {1u, 45u, 180u, 359u}) {
        std::vector<uint32_t> order;
        for (uint32_t c = 0; c < columns; ++c) order.push_back((first + c) % columns);
        const OrganizedScan shifted = rearranged(scan, order);
        EXPECT_EQ(inSourceOrder(shifted, labelsOf(room.map, shifted)), expected) << first;
    }
}

}  // namespace offmap::core
