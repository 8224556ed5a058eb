// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LidarModels.h>
#include <offmap/rawlog/RotatingGeometry.h>

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <numbers>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationRotatingScan;
using Reason = std::optional<std::string>;

/// A name out of a file, fit for a message.
std::string printable(const std::string& name) {
    constexpr size_t longest = 40;
    std::string text = name.substr(0, longest);
    for (char& c : text) {
        if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
    }
    return text;
}

Reason unsupportedImage(const Scan& obs, const mrpt::math::CMatrix_u16& image,
                        const std::string& name) {
    if (image.rows() == obs.rowCount && image.cols() == obs.columnCount) return {};
    return fmt::format("CObservationRotatingScan whose {} is {} x {}, not {} rows x {} columns",
                       name, image.rows(), image.cols(), obs.rowCount, obs.columnCount);
}

Reason unsupportedImages(const Scan& obs) {
    if (obs.rowCount == 0 || obs.columnCount == 0) {
        return "CObservationRotatingScan without rows or columns";
    }
    Reason reason = unsupportedImage(obs, obs.rangeImage, "range image");
    for (const auto& [name, layer] : obs.rangeOtherLayers) {
        if (!reason) reason = unsupportedImage(obs, layer, "layer " + printable(name));
    }
    return reason;
}

/// What no scanner has: a member that was never set, or a damaged file.
Reason unsupportedNumber(const Scan& obs) {
    const auto refuse = [](const char* what, double value, const char* unit) {
        return fmt::format("CObservationRotatingScan whose {} is {:g} {}", what, value, unit);
    };
    constexpr double widest = 4 * std::numbers::pi;  // [rad] two turns
    constexpr double longest = 3600;                 // [s]
    if (!std::isfinite(obs.rangeResolution) || obs.rangeResolution <= 0) {
        return refuse("rangeResolution", obs.rangeResolution, "m");
    }
    if (!(std::abs(obs.startAzimuth) <= widest)) {
        return refuse("startAzimuth", obs.startAzimuth, "rad");
    }
    if (!(std::abs(obs.azimuthSpan) <= widest)) {
        return refuse("azimuthSpan", obs.azimuthSpan, "rad");
    }
    if (!(0 <= obs.sweepDuration && obs.sweepDuration <= longest)) {
        return refuse("sweepDuration", obs.sweepDuration, "s");
    }
    return {};
}

Reason unsupportedRows(const Scan& obs, const SensorConfig& config) {
    const size_t given = config.elevations.size();
    if (given == obs.rowCount) return {};
    if (given > 0) {
        return fmt::format(
            "sensor.elevations_deg gives {} elevations, but the CObservationRotatingScan has {} "
            "rows",
            given, obs.rowCount);
    }
    if (elevationsOfModel(obs.lidarModel).size() == obs.rowCount) return {};
    return fmt::format(
        "CObservationRotatingScan of the model \"{}\": give the elevations of "
        "its {} rows with sensor.elevations_deg",
        printable(obs.lidarModel), obs.rowCount);
}

}  // namespace

std::optional<std::string> unsupportedRotatingScan(const Scan& obs, const SensorConfig& config) {
    Reason reason = unsupportedImages(obs);
    if (!reason) reason = unsupportedNumber(obs);
    if (!reason) reason = unsupportedRows(obs, config);
    return reason;
}

}  // namespace offmap::rawlog
