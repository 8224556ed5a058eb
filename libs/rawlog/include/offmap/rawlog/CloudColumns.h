// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// The azimuths of a cloud's columns, and which column each point belongs to.
struct CloudColumns {
    std::vector<double> azimuths;    ///< [rad] sensor frame, (-pi, pi], increasing
    std::vector<uint32_t> columnOf;  ///< per point: index into azimuths
};

/// Columns of a cloud by azimuth; they do not depend on the order of the points.
///
/// With width > 0 [rad]: fixed bins of about that width that close around the circle.
///
/// With width == 0: if the azimuths stand in clear clusters, as those of a scanner with exact
/// columns do, the clusters are the columns. Else fixed bins of a width that lets a full circle of
/// evenly spread points have 32 per column, within [0.2, 2] degrees.
///
/// Points within 0.5 m of the vertical axis have an azimuth of rounding noise; they take no part in
/// finding clusters and join the nearest. \param points finite
CloudColumns findCloudColumns(std::span<const mrpt::math::TPoint3Df> points, double width);

}  // namespace offmap::rawlog
