// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LevelledScan.h>

#include <cmath>

namespace offmap::core {

void level(const OrganizedScan& scan, LevelledScan& levelled) {
    levelled.ground.resize(scan.points.size());
    levelled.profile.resize(scan.points.size());
    for (const ScanColumn& column : scan.columns) {
        const mrpt::math::CMatrixDouble33 rotation =
            column.sensor ? column.sensor->sensorInMap.getRotationMatrix()
                          : mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix();
        for (uint32_t i = column.begin; i < column.end; ++i) {
            const auto& p = scan.points[i];
            const double x = rotation(0, 0) * p.x + rotation(0, 1) * p.y + rotation(0, 2) * p.z;
            const double y = rotation(1, 0) * p.x + rotation(1, 1) * p.y + rotation(1, 2) * p.z;
            const double z = rotation(2, 0) * p.x + rotation(2, 1) * p.y + rotation(2, 2) * p.z;
            levelled.ground[i] = {x, y};
            levelled.profile[i] = {std::sqrt(x * x + y * y), z};
        }
    }
}

}  // namespace offmap::core
