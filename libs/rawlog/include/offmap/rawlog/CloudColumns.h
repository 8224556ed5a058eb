// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/CloudPoints.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// Points of a cloud that stand one behind the other and belong to one column.
struct ColumnRun {
    uint32_t column;      ///< index into CloudColumns::azimuths
    uint32_t begin, end;  ///< of the cloud's points, half-open
};

/// The azimuths of a cloud's columns, and which column each point belongs to.
struct CloudColumns {
    std::vector<double> azimuths;  ///< [rad] sensor frame, (-pi, pi], increasing
    std::vector<ColumnRun> runs;   ///< as the points stand; together they are all points
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
CloudColumns findCloudColumns(const CloudPoints& points, double width);

}  // namespace offmap::rawlog
