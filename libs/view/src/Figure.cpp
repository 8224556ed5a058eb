// SPDX-License-Identifier: BSD-3-Clause
#include "FigureSheet.h"

#include <offmap/view/CorrectedScan.h>
#include <offmap/view/Figure.h>
#include <offmap/view/PoseMarks.h>
#include <offmap/view/Render.h>

#include <fmt/format.h>
#include <mrpt/opengl/CEllipsoid2D.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace offmap::view {
namespace {

using mrpt::img::CImage;
using mrpt::opengl::CSetOfObjects;

constexpr uint32_t gap = 2;      // [px] between the pictures
constexpr uint32_t samples = 2;  // of a pixel, each way: smooth points and lines

/// What is to be seen, by every picture of it.
struct Subject {
    const core::OrganizedScan& scan;
    const core::ReductionResult& result;
    const core::LineMap& map;
    const PlacedReturns& returns;
    mrpt::math::TBoundingBox extent;
    SceneOptions options;

    CSetOfObjects::Ptr poses() const;
    CSetOfObjects::Ptr scene(const Camera& camera) const;
};

/// Without a pose, a ball where the scan stands.
CSetOfObjects::Ptr Subject::poses() const {
    const auto size = extent.max - extent.min;
    const double arrow = 0.06 * std::max(size.x, size.y);
    auto marks = poseMarksOf(scan, result, arrow, options.palette);
    for (const auto& mark : *marks) {
        const auto ellipse = std::dynamic_pointer_cast<mrpt::opengl::CEllipsoid2D>(mark);
        if (ellipse) ellipse->setLineWidth(2 * options.wallLineWidth);
    }
    return marks->empty() ? sensorOf(returns, extent, options) : marks;
}

/// From above, the poses stand over returns of the ceiling, as far as the camera is.
CSetOfObjects::Ptr Subject::scene(const Camera& camera) const {
    SceneOptions withoutPoses = options;
    withoutPoses.showPoses = false;
    auto scene = sceneOf(returns, map, extent, withoutPoses);
    if (!options.showPoses) return scene;
    const auto marks = poses();
    if (camera.shorterSide > 0 && !returns.sensorPath.empty()) {
        const double eye = camera.target.z + 2 * camera.shorterSide;
        const double z = returns.sensorPath[returns.sensorPath.size() / 2].z();
        marks->setLocation(mrpt::math::TPoint3D(marks->getPose().x, marks->getPose().y,
                                                marks->getPose().z + 0.8 * (eye - z)));
    }
    scene->insert(marks);
    return scene;
}

/// A picture of the scene, drawn larger and scaled down.
CImage picture(const Subject& subject, const Camera& camera, uint32_t width, uint32_t height) {
    const CImage large = render(subject.scene(camera), camera, samples * width, samples * height,
                                subject.options.palette.background);
    CImage image;
    large.scaleImage(image, width, height, mrpt::img::IMG_INTERP_AREA);
    return image;
}

SceneOptions enlarged(SceneOptions options, double unit) {
    options.pointSize *= static_cast<float>(samples * std::max(1.0, unit));
    options.wallLineWidth *= static_cast<float>(samples * std::max(1.0, unit));
    return options;
}

void requireSize(const FigureOptions& options) {
    constexpr uint32_t least = 176, most = 8000;
    if (std::min(options.width, options.height) < least ||
        std::max(options.width, options.height) > most) {
        throw std::invalid_argument(
            fmt::format("a figure takes {0} x {0} to {1} x {1} pixels", least, most));
    }
}

}  // namespace

CImage figureOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                const core::LineMap& map, const FigureOptions& options) {
    requireSize(options);
    const Palette& palette = options.scene.palette;
    PlacedReturns returns =
        placedReturns(correctedScan(scan, result), result.labels, options.fallbackSensorInMap);
    if (options.colourBy != ColourBy::Label) {
        returns.colours =
            coloursOf(returns, scan, result, options.colourBy, palette, options.intensities);
    }
    FigureSheet sheet(options.width, options.height, palette);
    const uint32_t top = sheet.heading(options.title, legendOf(returns, scan, result, options));
    if (top > options.height / 2) {
        throw std::invalid_argument(fmt::format(
            "a figure of {} x {} pixels is too small for its legend: it takes {} pixels of height "
            "at this width",
            options.width, options.height, 2 * top));
    }
    const auto extent = extentOf(returns);
    const Subject subject{scan,    result, map,
                          returns, extent, enlarged(options.scene, sheet.unit())};
    const uint32_t height = options.height - top;
    const bool both = options.view == FigureView::Both;
    const uint32_t left = both ? options.width * 11 / 20 : options.width;  // of the perspective
    const auto aspect = [&](uint32_t width) { return double(width) / height; };
    if (options.view != FigureView::Top) {
        const Camera aside =
            Camera::perspective(extent, aspect(left), options.azimuth, options.elevation);
        sheet.paste(picture(subject, aside, left, height), 0, top);
    }
    if (both) sheet.fill(palette.rest, left, top, gap, height);
    if (options.view != FigureView::Perspective) {
        const uint32_t x = both ? left + gap : 0, width = options.width - x;
        const Camera above = Camera::top(extent, aspect(width));
        sheet.paste(picture(subject, above, width, height), x, top);
        sheet.scale(x, options.height, std::min(width, height) / above.shorterSide);
    }
    return sheet.image();
}

}  // namespace offmap::view
