// SPDX-License-Identifier: BSD-3-Clause
#include "ExternalFile.h"
#include "ShortReason.h"

#include <offmap/rawlog/ImagePoints.h>
#include <offmap/rawlog/RangeImageScan.h>

#include <fmt/format.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <stdexcept>
#include <vector>

namespace offmap::rawlog {

namespace {

namespace fs = std::filesystem;
using Scan = mrpt::obs::CObservation3DRangeScan;

/// The names of the files cannot be changed from outside.
struct Storage : Scan {
    static constexpr auto rangesFile = &Storage::m_rangeImage_external_file;
    static constexpr auto pointsFile = &Storage::m_points3D_external_file;
};

/// MRPT asks for memory before it looks whether the file holds as much.
void expectTrueSizes(const fs::path& file, size_t count) {
    if (file.extension() == ".txt") return;
    mrpt::io::CFileGZInputStream stream(file.string());
    auto archive = mrpt::serialization::archiveFrom(stream);
    constexpr uint64_t most = uint64_t{1} << 26;  // pixels or points
    constexpr uint32_t olderFormat = 0x4D4388;    // "\x88CM", the head of a CMatrixF
    const uint64_t first = archive.ReadAs<uint32_t>();
    if ((first & 0xFFFFFF) == olderFormat) return;
    const uint64_t second = count > 1 ? archive.ReadAs<uint32_t>() : 1;
    if (first * second > most) throw std::runtime_error("a size in it cannot be true");
}

/// Reads one of the two. \param sizes that the file begins with
void read(Scan& loader, const fs::path& file, size_t sizes, const std::string& what) {
    try {
        expectTrueSizes(file, sizes);
        loader.load();
    } catch (const std::exception& e) {
        throw std::runtime_error(fmt::format("the {} of '{}' cannot be read from '{}': {}", what,
                                             loader.sensorLabel, file.string(), shortReason(e)));
    }
}

bool loadRanges(Scan& obs, const fs::path& rawlogFile) {
    if (!obs.hasRangeImage || !obs.rangeImage_isExternallyStored()) return false;
    const std::string what = "range image";
    const fs::path file =
        findExternalFile(what, obs.sensorLabel, obs.*Storage::rangesFile, rawlogFile);
    Scan loader = obs;
    loader.hasPoints3D = false;
    loader.rangeImage.setSize(0, 0);
    loader.rangeImageOtherLayers.clear();  // MRPT stores them in the log all the same
    loader.*Storage::rangesFile = file.string();
    read(loader, file, 2, what);
    obs.rangeImage = loader.rangeImage;
    obs.cameraParams = loader.cameraParams;  // its sizes are corrected in some old logs
    obs.rangeImage_forceResetExternalStorage();
    (obs.*Storage::rangesFile).clear();
    if (const auto fault = rangeImageFault(obs)) {
        throw std::runtime_error(fmt::format("the {} of '{}' in '{}' is of no use: {}", what,
                                             obs.sensorLabel, file.string(), *fault));
    }
    return true;
}

bool loadPoints(Scan& obs, const fs::path& rawlogFile) {
    if (!obs.hasPoints3D || !obs.points3D_isExternallyStored()) return false;
    const std::string what = "point cloud";
    const fs::path file =
        findExternalFile(what, obs.sensorLabel, obs.*Storage::pointsFile, rawlogFile);
    Scan loader = obs;
    loader.hasRangeImage = false;
    loader.*Storage::pointsFile = file.string();
    read(loader, file, 1, what);
    const size_t size = loader.points3D_x.size();
    if (loader.points3D_y.size() != size || loader.points3D_z.size() != size) {
        throw std::runtime_error(fmt::format("the {} of '{}' in '{}' is broken: {} x, {} y, {} z",
                                             what, obs.sensorLabel, file.string(), size,
                                             loader.points3D_y.size(), loader.points3D_z.size()));
    }
    obs.points3D_x.swap(loader.points3D_x);
    obs.points3D_y.swap(loader.points3D_y);
    obs.points3D_z.swap(loader.points3D_z);
    obs.points3D_overrideExternalStoredFlag(false);
    (obs.*Storage::pointsFile).clear();
    return true;
}

}  // namespace

bool RangeImageScan::loadExternal(mrpt::obs::CObservation& observation,
                                  const fs::path& rawlogFile) const {
    Scan obs = dynamic_cast<const Scan&>(observation);
    const bool ranges = loadRanges(obs, rawlogFile), points = loadPoints(obs, rawlogFile);
    if (!ranges && !points) return false;
    // The pixels of the points are stored in neither place; MRPT wants some to write.
    if (points) {
        if (hasRanges(obs)) {
            const RangeImage image(obs);
            storeIndices(obs, findImagePoints(obs, image), image);
        } else {
            obs.points3D_idxs_x.resize(obs.points3D_x.size());
            obs.points3D_idxs_y.resize(obs.points3D_x.size());
        }
    }
    dynamic_cast<Scan&>(observation) = obs;
    return true;
}

}  // namespace offmap::rawlog
