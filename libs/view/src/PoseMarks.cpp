// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>
#include <offmap/view/PoseMarks.h>

#include <Eigen/Dense>
#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CEllipsoid2D.h>

#include <optional>

namespace offmap::view {

namespace {

using mrpt::opengl::CSetOfObjects;

/// \param covariance [m^2] of x and y, in the map's axes
void addMark(CSetOfObjects& marks, const mrpt::poses::CPose3D& sensorInMap,
             const Eigen::Matrix2d& covariance, double size, const mrpt::img::TColor& colour) {
    const auto s = static_cast<float>(size);
    auto arrow = mrpt::opengl::CArrow::Create(0, 0, 0, s, 0, 0, 0.3F, 0.035F * s, 0.11F * s);
    arrow->setColor_u8(colour);
    arrow->enableLight(false);  // from above, it would be lit from behind
    arrow->setPose(sensorInMap);
    marks.insert(arrow);
    // Not drawn where it is flat; a pose that is known exactly has none.
    if (!(covariance.determinant() > 0)) return;
    auto ellipse = mrpt::opengl::CEllipsoid2D::Create();
    ellipse->setCovMatrix(mrpt::math::CMatrixDouble22(covariance));
    ellipse->setQuantiles(3.0F);
    ellipse->set2DsegmentsCount(48);
    ellipse->setLineWidth(2.0F);
    ellipse->setColor_u8(colour);
    ellipse->setLocation(sensorInMap.x(), sensorInMap.y(), sensorInMap.z());
    marks.insert(ellipse);
}

}  // namespace

const core::ScanColumn* middleColumn(const core::OrganizedScan& scan) {
    const size_t columns = scan.columns.size();
    for (size_t i = 0; i < columns; ++i) {
        const core::ScanColumn& column = scan.columns[(columns / 2 + i) % columns];
        if (column.sensor) return &column;
    }
    return nullptr;
}

CSetOfObjects::Ptr poseMarksOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                               double size, const Palette& palette) {
    auto marks = CSetOfObjects::Create();
    marks->setName("poses");
    const core::ScanColumn* column = middleColumn(scan);
    if (!column) return marks;
    addMark(*marks, column->sensor->sensorInMap,
            column->sensor->groundCovariance.topLeftCorner<2, 2>(), size, palette.sensor);
    if (result.alignment) {
        const core::PoseCorrection& correction = result.alignment->correction;
        addMark(*marks, core::correctedSensor(correction, *column),
                correction.covariance.topLeftCorner<2, 2>(), size, palette.refined);
    }
    return marks;
}

}  // namespace offmap::view
