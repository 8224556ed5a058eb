// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/TrajectoryFile.h>

#include <fmt/format.h>
#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace offmap::rawlog {
namespace {

constexpr std::string_view lineForm =
    "a pose is: t x y z qx qy qz qw, or t x y z yaw pitch roll; seconds, metres, radians";
constexpr size_t tumColumns = 8, mrptColumns = 7;

struct Place {
    const std::filesystem::path& file;
    size_t line = 0;  ///< from 1

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(fmt::format("{}:{}: {}; {}", file.string(), line, what, lineForm));
    }
};

/// A field as it may be printed: in quotes, short, without control bytes.
std::string quoted(std::string_view field) {
    constexpr size_t maxShown = 40;
    std::string shown(field.substr(0, maxShown));
    std::ranges::replace_if(
        shown, [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return fmt::format("'{}{}'", shown, field.size() > maxShown ? "..." : "");
}

struct Row {
    std::array<double, tumColumns> values{};
    size_t count = 0;
};

double parseNumber(std::string_view field, const Place& place) {
    const std::string_view digits = field.starts_with('+') ? field.substr(1) : field;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size()) {
        place.fail(quoted(field) + " is not a number");
    }
    if (!std::isfinite(value)) place.fail(quoted(field) + " is not finite");
    return value;
}

Row parseRow(std::string_view line, const Place& place) {
    constexpr std::string_view separators = " \t\r\v\f,;";
    Row row;
    size_t begin = line.find_first_not_of(separators);
    while (begin != std::string_view::npos) {
        const size_t end = std::min(line.find_first_of(separators, begin), line.size());
        if (row.count == tumColumns) place.fail("more than 8 numbers");
        row.values[row.count++] = parseNumber(line.substr(begin, end - begin), place);
        begin = line.find_first_not_of(separators, end);
    }
    return row;
}

mrpt::Clock::time_point timeOf(double seconds, const Place& place) {
    constexpr double latest = 1e11;  // [s] year 5138; nanoseconds of any year are later
    if (seconds < 0 || seconds > latest) {
        place.fail(fmt::format("{:.10g} is no time in seconds since 1970", seconds));
    }
    return mrpt::Clock::fromDouble(seconds);
}

mrpt::math::TPose3D fromQuaternion(const Row& row, const Place& place) {
    const auto& [t, x, y, z, qx, qy, qz, qw] = row.values;
    const double norm = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
    // Written with two decimals, each component is off by up to 0.005, the norm by up to 0.01.
    if (std::abs(norm - 1) > 0.02) {
        place.fail(fmt::format("qx qy qz qw has a length of {:.4g}, not 1", norm));
    }
    const mrpt::math::CQuaternionDouble q(qw / norm, qx / norm, qy / norm, qz / norm);
    return mrpt::poses::CPose3D(q, x, y, z).asTPose();
}

mrpt::math::TPose3D fromAngles(const Row& row, const Place& place) {
    constexpr double fullTurn = 2 * std::numbers::pi;
    const auto& [t, x, y, z, yaw, pitch, roll, unused] = row.values;
    for (const double angle : {yaw, pitch, roll}) {
        if (std::abs(angle) > fullTurn) {
            place.fail(fmt::format("{:.6g} is more than a full turn in radians", angle));
        }
    }
    return mrpt::poses::CPose3D(x, y, z, yaw, pitch, roll).asTPose();
}

std::ifstream opened(const std::filesystem::path& file) {
    std::error_code ignored;
    const bool isFolder = std::filesystem::is_directory(file, ignored);
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (in && !isFolder) return in;
    const std::string why = std::generic_category().message(isFolder     ? EISDIR
                                                            : errno != 0 ? errno
                                                                         : EIO);
    throw std::runtime_error(fmt::format("{}: cannot read the trajectory: {}", file.string(), why));
}

}  // namespace

std::vector<StampedPose> readTrajectory(const std::filesystem::path& file, double sigmaPosition,
                                        double sigmaHeading) {
    const double variance = sigmaPosition * sigmaPosition;
    const GroundTriangle covariance{variance, 0, 0, variance, 0, sigmaHeading * sigmaHeading};
    std::ifstream in = opened(file);
    std::vector<StampedPose> poses;
    std::string line;
    size_t columns = 0;
    for (Place place{file, 1}; std::getline(in, line); ++place.line) {
        const Row row = parseRow(line.substr(0, line.find('#')), place);
        if (row.count == 0) continue;
        if (row.count != tumColumns && row.count != mrptColumns) {
            place.fail(fmt::format("{} numbers, but it takes 7 or 8", row.count));
        }
        if (columns == 0) columns = row.count;
        if (row.count != columns) {
            place.fail(fmt::format("{} numbers, but {} before", row.count, columns));
        }
        const auto pose =
            row.count == tumColumns ? fromQuaternion(row, place) : fromAngles(row, place);
        poses.push_back({timeOf(row.values[0], place), pose, covariance, {}});
    }
    if (in.bad())
        throw std::runtime_error(file.string() + ": cannot read the trajectory to its end");
    if (poses.empty()) {
        throw std::runtime_error(fmt::format("{} holds no pose; {}", file.string(), lineForm));
    }
    std::ranges::stable_sort(poses, {}, &StampedPose::time);
    return poses;
}

}  // namespace offmap::rawlog
