// SPDX-License-Identifier: BSD-3-Clause
#include "ExternalFile.h"

#include <offmap/rawlog/ImagePoints.h>
#include <offmap/rawlog/RangeImageScan.h>
#include <offmap/rawlog/ShortReason.h>

#include <fmt/format.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/math/CMatrixF.h>
#include <mrpt/serialization/CArchive.h>

#include <stdexcept>
#include <vector>

namespace offmap::rawlog {

namespace {

namespace fs = std::filesystem;
using Scan = mrpt::obs::CObservation3DRangeScan;
using mrpt::serialization::CArchive;

/// The names of the files cannot be changed from outside.
struct Storage : Scan {
    static constexpr auto rangesFile = &Storage::m_rangeImage_external_file;
    static constexpr auto pointsFile = &Storage::m_points3D_external_file;
};

bool isText(const fs::path& file) { return file.extension() == ".txt"; }

/// MRPT asks for memory before it looks whether the file holds as much.
size_t trueSize(uint64_t size) {
    constexpr uint64_t most = uint64_t{1} << 26;  // pixels or points
    if (size > most) throw std::runtime_error("a size in it cannot be true");
    return static_cast<size_t>(size);
}

/// MRPT does not look either whether it got all that it asked for.
template <class T>
void readAll(CArchive& archive, T* values, size_t size) {
    if (size == 0) return;
    if (archive.ReadBufferFixEndianness(values, size) != size * sizeof(T)) {
        throw std::runtime_error("it ends too early");
    }
}

/// Logs before MRPT 2 have a CMatrixF of metres, and only MRPT itself knows that it read one.
bool isOfOlderFormat(const fs::path& file) {
    if (isText(file)) return false;
    mrpt::io::CFileGZInputStream stream(file.string());
    constexpr uint32_t head = 0x4D4388;  // "\x88CM"
    return (mrpt::serialization::archiveFrom(stream).ReadAs<uint32_t>() & 0xFFFFFF) == head;
}

void readRanges(Scan& obs, const fs::path& file) {
    auto& image = obs.rangeImage;
    if (isText(file)) return image.loadFromTextFile(file.string());
    if (isOfOlderFormat(file)) return obs.load();
    mrpt::io::CFileGZInputStream stream(file.string());
    auto archive = mrpt::serialization::archiveFrom(stream);
    const auto rows = archive.ReadAs<uint32_t>(), columns = archive.ReadAs<uint32_t>();
    const size_t pixels = trueSize(uint64_t{rows} * columns);
    image.setSize(static_cast<int>(rows), static_cast<int>(columns));
    readAll(archive, image.data(), pixels);
}

/// MRPT writes a point a row, and reads only a coordinate a row.
void readTextPoints(Scan& obs, const fs::path& file) {
    mrpt::math::CMatrixFloat points;
    points.loadFromTextFile(file.string());
    if (points.cols() != 3) throw std::runtime_error("it has not three numbers in a row");
    for (int i = 0; i < points.rows(); ++i) {
        obs.points3D_x.push_back(points(i, 0));
        obs.points3D_y.push_back(points(i, 1));
        obs.points3D_z.push_back(points(i, 2));
    }
}

void readPoints(Scan& obs, const fs::path& file) {
    for (auto* axis : {&obs.points3D_x, &obs.points3D_y, &obs.points3D_z}) axis->clear();
    if (isText(file)) return readTextPoints(obs, file);
    mrpt::io::CFileGZInputStream stream(file.string());
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (auto* axis : {&obs.points3D_x, &obs.points3D_y, &obs.points3D_z}) {
        axis->resize(trueSize(archive.ReadAs<uint32_t>()));
        readAll(archive, axis->data(), axis->size());
        if (axis->size() != obs.points3D_x.size()) {
            throw std::runtime_error("the coordinates of its points differ in number");
        }
    }
}

/// Finds the file and reads it. \param obs gets the absolute name for as long
void read(Scan& obs, const fs::path& rawlogFile, const std::string& what,
          std::string Scan::*fileName, void (*reader)(Scan&, const fs::path&)) {
    const fs::path file = findExternalFile(what, obs.sensorLabel, obs.*fileName, rawlogFile);
    obs.*fileName = file.string();
    try {
        reader(obs, file);
    } catch (const std::exception& e) {
        throw std::runtime_error(fmt::format("the {} of '{}' cannot be read from '{}': {}", what,
                                             obs.sensorLabel, file.string(), shortReason(e)));
    }
    (obs.*fileName).clear();
}

/// The pixels of the points are stored in neither place; MRPT wants some to write.
void restoreIndices(Scan& obs) {
    if (hasRanges(obs)) {
        const RangeImage image(obs);
        storeIndices(obs, findImagePoints(obs, image), image);
    } else {
        obs.points3D_idxs_x.resize(obs.points3D_x.size());
        obs.points3D_idxs_y.resize(obs.points3D_x.size());
    }
}

void readRangesAndReset(Scan& obs, const fs::path& file) {
    const bool points = obs.hasPoints3D;
    obs.hasPoints3D = false;  // of its own file: MRPT would look for it as well
    obs.rangeImage.setSize(0, 0);
    readRanges(obs, file);
    obs.hasPoints3D = points;
    obs.rangeImage_forceResetExternalStorage();
    if (obs.rangeImage.size() == 0) throw std::runtime_error("it is empty");
    if (const auto fault = rangeImageFault(obs)) throw std::runtime_error(*fault);
}

void readPointsAndReset(Scan& obs, const fs::path& file) {
    readPoints(obs, file);
    obs.points3D_overrideExternalStoredFlag(false);
}

}  // namespace

bool RangeImageScan::loadExternal(mrpt::obs::CObservation& observation,
                                  const fs::path& rawlogFile) const {
    auto& original = dynamic_cast<Scan&>(observation);
    const bool ranges = original.hasRangeImage && original.rangeImage_isExternallyStored();
    const bool points = original.hasPoints3D && original.points3D_isExternallyStored();
    if (!ranges && !points) return false;
    Scan obs = original;
    if (ranges) {
        read(obs, rawlogFile, "range image", Storage::rangesFile, readRangesAndReset);
    }
    if (points) {
        read(obs, rawlogFile, "point cloud", Storage::pointsFile, readPointsAndReset);
        restoreIndices(obs);
    }
    original = obs;
    return true;
}

}  // namespace offmap::rawlog
