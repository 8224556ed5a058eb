// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/TextMapWriter.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;

std::string straightText(const mrpt::math::TSegment2D& line) {
    return fmt::format("{:.4f} {:.4f}  {:.4f} {:.4f}", line.point1.x, line.point1.y, line.point2.x,
                       line.point2.y);
}

/// Counter-clockwise from start to end, as the file has it.
std::string arcText(const core::Wall& wall) {
    const TPoint2D from = wall.curvature > 0 ? wall.line.point1 : wall.line.point2;
    const TPoint2D to = wall.curvature > 0 ? wall.line.point2 : wall.line.point1;
    const double radius = 1 / std::abs(wall.curvature), half = 0.5 * wall.line.length();
    // from the middle of the chord to the left, where the centre is
    const double height = std::sqrt(std::max(0.0, radius * radius - half * half)) / (2 * half);
    const TPoint2D chord = to - from;
    const TPoint2D centre{0.5 * (from.x + to.x) - height * chord.y,
                          0.5 * (from.y + to.y) + height * chord.x};
    const auto degrees = [&](const TPoint2D& end) {
        return mrpt::RAD2DEG(std::atan2(end.y - centre.y, end.x - centre.x));
    };
    return fmt::format("arc {:.4f} {:.4f}  {:.4f}  {:.6f} {:.6f}", centre.x, centre.y, radius,
                       degrees(from), degrees(to));
}

}  // namespace

std::string textMapOf(std::span<const core::Wall> walls) {
    std::string text = "# x1 y1 x2 y2 sigma [z_min z_max], in metres\n";
    for (const core::Wall& wall : walls) {
        text += wall.curvature == 0 ? straightText(wall.line) : arcText(wall);
        text += fmt::format("  {:.4f}", wall.sigma);
        if (std::isfinite(wall.height.min()) || std::isfinite(wall.height.max())) {
            text += fmt::format("  {:.4f} {:.4f}", wall.height.min(), wall.height.max());
        }
        text += '\n';
    }
    return text;
}

}  // namespace offmap::maps
