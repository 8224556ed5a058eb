// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>
#include <offmap/maps/SvgMap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

namespace offmap::maps::test {

inline Drawing parsed(const std::string& text, const MapOptions& options = {}) {
    return parseSvgMap(text, "plan.svg", options);
}

/// A sheet of 10 m x 10 m, a user unit of 1 m; y counts from its upper edge.
inline std::string inSvg(const std::string& content) {
    return "<svg width='10000mm' height='10000mm' viewBox='0 0 10 10'>" + content + "</svg>";
}

inline std::string errorOf(const std::string& text, const MapOptions& options = {}) {
    try {
        parsed(text, options);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

inline std::array<double, 4> ends(const core::Wall& wall) {
    return {wall.line.point1.x, wall.line.point1.y, wall.line.point2.x, wall.line.point2.y};
}

/// Four coordinates, each within a tolerance.
inline auto near(const std::array<double, 4>& expected, double tolerance) {
    return testing::ElementsAre(
        testing::DoubleNear(expected[0], tolerance), testing::DoubleNear(expected[1], tolerance),
        testing::DoubleNear(expected[2], tolerance), testing::DoubleNear(expected[3], tolerance));
}

}  // namespace offmap::maps::test
