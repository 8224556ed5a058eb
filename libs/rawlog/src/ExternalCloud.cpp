// SPDX-License-Identifier: BSD-3-Clause
#include "ExternalFile.h"

#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/ShortReason.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <stdexcept>

namespace offmap::rawlog {

namespace {

namespace fs = std::filesystem;
using Cloud = mrpt::obs::CObservationPointCloud;

/// The name of the file cannot be changed from outside without knowing the format, nor the format
/// be asked for.
struct Storage : Cloud {
    static constexpr auto file = &Storage::m_external_file;
};

}  // namespace

bool PointCloudScan::loadExternal(mrpt::obs::CObservation& observation,
                                  const fs::path& rawlogFile) const {
    Cloud& obs = dynamic_cast<Cloud&>(observation);
    if (!obs.isExternallyStored()) return false;
    const fs::path file =
        findExternalFile("point cloud", obs.sensorLabel, obs.getExternalStorageFile(), rawlogFile);
    // By its absolute name: MRPT's folder for external files is one for all threads.
    Cloud loader = obs;
    loader.*Storage::file = file.string();
    loader.pointcloud.reset();
    try {
        loader.load();
    } catch (const std::exception& e) {
        throw std::runtime_error(fmt::format("the point cloud of '{}' cannot be read from '{}': {}",
                                             obs.sensorLabel, file.string(), shortReason(e)));
    }
    obs.pointcloud = loader.pointcloud;
    obs.overrideExternalStorageFormatFlag(Cloud::ExternalStorageFormat::None);
    obs.setAsExternalStorage("", Cloud::ExternalStorageFormat::None);
    return true;
}

}  // namespace offmap::rawlog
