// SPDX-License-Identifier: BSD-3-Clause
#include "ShortReason.h"

#include <offmap/rawlog/PointCloudScan.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <array>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {

namespace {

namespace fs = std::filesystem;
using Cloud = mrpt::obs::CObservationPointCloud;

fs::path findExternalFile(const Cloud& obs, const fs::path& rawlogFile) {
    const fs::path name = obs.getExternalStorageFile();
    const fs::path folder = rawlogFile.parent_path();
    const std::array<fs::path, 3> candidates = {
        folder / (rawlogFile.stem().string() + "_Images") / name, folder / "Images" / name,
        folder / name};
    for (const fs::path& file : candidates) {
        if (fs::is_regular_file(file)) return fs::absolute(file);
    }
    throw std::runtime_error(fmt::format(
        "the point cloud of '{}' is stored in '{}', which is neither in '{}' nor in '{}'; put it "
        "there or use a log made by rawlog-edit --de-externalize",
        obs.sensorLabel, name.string(), candidates[0].parent_path().string(),
        candidates[2].parent_path().string()));
}

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
    const fs::path file = findExternalFile(obs, rawlogFile);
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
