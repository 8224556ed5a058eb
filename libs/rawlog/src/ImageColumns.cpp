// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ImageColumns.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3Df;

/// [rad] A wall met at 60 degrees from its normal seems to lean by up to tan(60 deg) times the
/// change of azimuth over 45 degrees of elevation: 1.7 degrees.
constexpr double maxAzimuthChange = mrpt::DEG2RAD(1.0);

/// The lines of the image that could be columns: its columns or its rows, bottom to top.
struct ImageLines {
    size_t count, length;
    size_t first;             ///< lowest pixel of line 0
    ptrdiff_t next, upwards;  ///< step from line to line, and along one [pixels]

    size_t pixel(size_t line, size_t place) const {
        return static_cast<size_t>(static_cast<ptrdiff_t>(first) +
                                   next * static_cast<ptrdiff_t>(line) +
                                   upwards * static_cast<ptrdiff_t>(place));
    }
};

/// Those nearer the vertical.
ImageLines uprightLines(const RangeImage& image, const mrpt::math::CMatrixDouble33& rotation) {
    const size_t rows = image.rows(), columns = image.columns();
    const auto width = static_cast<ptrdiff_t>(columns);
    const double left = rotation(2, 1), top = rotation(2, 2);  // heights of the camera's y, z axes
    if (std::abs(top) >= std::abs(left)) {
        if (top >= 0) return {columns, rows, (rows - 1) * columns, 1, -width};
        return {columns, rows, 0, 1, width};
    }
    if (left >= 0) return {rows, columns, columns - 1, width, -1};
    return {rows, columns, 0, width, 1};
}

class Azimuths {
 public:
    Azimuths(const RangeImage& image, const mrpt::math::CMatrixDouble33& rotation)
        : rays_(image.rays()), rotation_(rotation) {}

    TPoint3Df ray(size_t pixel) const {
        const TPoint3Df& v = rays_[pixel];
        const auto along = [&](int axis) {
            return static_cast<float>(rotation_(axis, 0) * v.x + rotation_(axis, 1) * v.y +
                                      rotation_(axis, 2) * v.z);
        };
        return {along(0), along(1), along(2)};
    }

    double operator()(size_t pixel) const {
        const TPoint3Df v = ray(pixel);
        return std::atan2(static_cast<double>(v.y), static_cast<double>(v.x));
    }

    double between(size_t a, size_t b) const {
        return std::abs(mrpt::math::wrapToPi((*this)(b) - (*this)(a)));
    }

 private:
    const std::vector<TPoint3Df>& rays_;
    const mrpt::math::CMatrixDouble33 rotation_;
};

bool keepTheirAzimuth(const ImageLines& lines, const Azimuths& azimuths) {
    for (size_t line = 0; line < lines.count; ++line) {
        const size_t middle = lines.pixel(line, lines.length / 2);
        const double change =
            std::max(azimuths.between(lines.pixel(line, 0), middle),
                     azimuths.between(middle, lines.pixel(line, lines.length - 1)));
        if (!(change <= maxAzimuthChange)) return false;
    }
    return true;
}

/// Pixels by azimuth.
std::vector<ImageColumn> gathered(const RangeImage& image, const ImageLines& lines,
                                  const Azimuths& azimuths, double width) {
    if (width == 0) {
        const size_t line = lines.count / 2, place = lines.length / 2;
        const double onePixel =
            azimuths.between(lines.pixel(line, place), lines.pixel(line ? line - 1 : 0, place));
        width = std::clamp(onePixel, mrpt::DEG2RAD(0.05), mrpt::DEG2RAD(2.0));
    }
    CloudArrays rays;
    rays.reserve(image.pixels());
    for (size_t pixel = 0; pixel < image.pixels(); ++pixel) rays.add(azimuths.ray(pixel));
    const CloudColumns bins = findCloudColumns(rays.points(), width);
    std::vector<ImageColumn> columns(bins.azimuths.size());
    for (size_t c = 0; c < columns.size(); ++c) columns[c].azimuth = bins.azimuths[c];
    // Bottom row first: nearly sorted, quickly so.
    for (size_t r = bins.runs.size(); r-- > 0;) {
        const ColumnRun& run = bins.runs[r];
        auto& pixels = columns[run.column].pixels;
        for (uint32_t pixel = run.end; pixel-- > run.begin;) pixels.push_back(pixel);
    }
    return columns;
}

}  // namespace

std::vector<ImageColumn> findImageColumns(const RangeImage& image,
                                          const mrpt::poses::CPose3D& cameraInVehicle,
                                          double width) {
    const auto& rotation = cameraInVehicle.getRotationMatrix();
    const ImageLines lines = uprightLines(image, rotation);
    const Azimuths azimuths(image, rotation);
    if (!keepTheirAzimuth(lines, azimuths)) return gathered(image, lines, azimuths, width);
    std::vector<ImageColumn> columns(lines.count);
    for (size_t line = 0; line < lines.count; ++line) {
        columns[line].azimuth = azimuths(lines.pixel(line, lines.length / 2));
        columns[line].pixels.reserve(lines.length);
        for (size_t place = 0; place < lines.length; ++place) {
            columns[line].pixels.push_back(static_cast<uint32_t>(lines.pixel(line, place)));
        }
    }
    return columns;
}

}  // namespace offmap::rawlog
