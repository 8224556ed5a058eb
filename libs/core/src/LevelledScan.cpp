// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/core/LevelledScan.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::CMatrixDouble33;
using mrpt::math::TPoint3Df;

namespace {

struct Rotation {
    explicit Rotation(const CMatrixDouble33& matrix) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                r[row][column] = static_cast<float>(matrix(row, column));
            }
        }
    }
    float r[3][3];
};

/// Turns points of the sensor upright.
OFFMAP_BY_PROCESSOR void turn(const Rotation& rotation, const TPoint3Df* points, uint32_t count,
                              float* __restrict x, float* __restrict y, float* __restrict range,
                              float* __restrict z) {
    const auto [r] = rotation;
    for (uint32_t i = 0; i < count; ++i) {
        const TPoint3Df p = points[i];
        const float east = r[0][0] * p.x + r[0][1] * p.y + r[0][2] * p.z;
        const float north = r[1][0] * p.x + r[1][1] * p.y + r[1][2] * p.z;
        x[i] = east;
        y[i] = north;
        range[i] = std::sqrt(east * east + north * north);
        z[i] = r[2][0] * p.x + r[2][1] * p.y + r[2][2] * p.z;
    }
}

Rotation uprightFrom(const ScanColumn& column) {
    if (column.sensor) return Rotation(column.sensor->sensorInMap.getRotationMatrix());
    return Rotation(mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix());
}

}  // namespace

void levelColumn(const OrganizedScan& scan, uint32_t column, LevelledScan& levelled) {
    const uint32_t begin = scan.columns[column].begin, end = scan.columns[column].end;
    const uint32_t at = begin - levelled.first;
    turn(uprightFrom(scan.columns[column]), scan.points.data() + begin, end - begin,
         levelled.x.data() + at, levelled.y.data() + at, levelled.range.data() + at,
         levelled.z.data() + at);
}

void level(const OrganizedScan& scan, LevelledScan& levelled) {
    levelled.resize(scan.points.size());
    for (uint32_t c = 0; c < scan.columns.size(); ++c) levelColumn(scan, c, levelled);
}

}  // namespace offmap::core
