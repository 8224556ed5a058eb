// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Figure.h>
#include <offmap/view/Render.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace offmap::view {
namespace {

using core::PointLabel;
using mrpt::img::CImage;

constexpr uint32_t barHeight = 44;  // [px] the line of text on top
constexpr int gap = 2;              // [px] between the panels
constexpr uint32_t samples = 2;     // of a pixel, each way: smooth points and lines

/// A picture of the scene, drawn larger and scaled down.
CImage panel(const mrpt::opengl::CSetOfObjects::Ptr& scene, const Camera& camera, uint32_t width,
             uint32_t height, const Palette& palette) {
    const CImage large =
        render(scene, camera, samples * width, samples * height, palette.background);
    CImage image;
    large.scaleImage(image, width, height, mrpt::img::IMG_INTERP_AREA);
    return image;
}

/// A length of 1, 2 or 5 times a power of ten that is at most `length`. [m]
double roundLength(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= length) return factor * power;
    return power;
}

void drawScale(CImage& image, int left, int bottom, double pixelsPerMetre, const Palette& palette) {
    constexpr double wanted = 160;  // [px]
    const double length = roundLength(wanted / pixelsPerMetre);
    const int right = left + static_cast<int>(std::lround(length * pixelsPerMetre));
    image.filledRectangle(left, bottom - 2, right, bottom, palette.text);
    image.textOut(left, bottom - 22, fmt::format("{:g} m", length), palette.text);
}

struct Entry {
    PointLabel label;
    const char* meaning;
};

void drawLegend(CImage& image, const PlacedReturns& returns, const Palette& palette) {
    constexpr int glyph = 9, swatch = 12, top = 15;  // [px]
    int right = static_cast<int>(image.getWidth()) - 16;
    for (const auto& [label, meaning] :
         {Entry{PointLabel::NotOnVerticalSegment, "not on a vertical segment"},
          Entry{PointLabel::Orphan, "orphan, removed"}, Entry{PointLabel::Kept, "kept segment"},
          Entry{PointLabel::Mapped, "mapped, removed"}}) {
        const auto count = std::count(returns.labels.begin(), returns.labels.end(), label);
        if (label == PointLabel::Orphan && count == 0) continue;
        const std::string text = fmt::format("{} {}", meaning, count);
        const int left = right - glyph * static_cast<int>(text.size());
        image.textOut(left, top, text, palette.text);
        image.filledRectangle(left - 8 - swatch, top + 2, left - 8, top + 2 + swatch,
                              palette.of(label));
        right = left - 8 - swatch - 24;
    }
}

}  // namespace

CImage figureOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                const core::LineMap& map, const FigureOptions& options) {
    if (options.width < 4 * barHeight || options.height < 4 * barHeight)
        throw std::invalid_argument(
            fmt::format("figureOf: a figure takes at least {0} x {0} pixels", 4 * barHeight));
    const Palette& palette = options.scene.palette;
    const PlacedReturns returns = placedReturns(scan, result.labels, options.fallbackSensorInMap);
    const auto extent = extentOf(returns);
    SceneOptions large = options.scene;
    large.pointSize *= samples;
    large.wallLineWidth *= samples;
    const auto scene = [&] { return sceneOf(returns, map, extent, large); };

    const uint32_t height = options.height - barHeight;
    const uint32_t leftWidth = options.width * 11 / 20,
                   rightWidth = options.width - leftWidth - gap;
    const auto aspect = [&](uint32_t width) { return double(width) / height; };
    const Camera aside =
        Camera::perspective(extent, aspect(leftWidth), options.azimuth, options.elevation);
    const Camera above = Camera::top(extent, aspect(rightWidth));

    CImage figure(static_cast<int32_t>(options.width), static_cast<int32_t>(options.height),
                  mrpt::img::CH_RGB);
    figure.filledRectangle(0, 0, static_cast<int>(options.width), static_cast<int>(options.height),
                           palette.background);
    const int right = static_cast<int>(leftWidth) + gap;
    figure.drawImage(0, barHeight, panel(scene(), aside, leftWidth, height, palette));
    figure.drawImage(right, barHeight, panel(scene(), above, rightWidth, height, palette));
    figure.filledRectangle(right - gap, barHeight, right - 1, static_cast<int>(options.height),
                           palette.rest);
    figure.selectTextFont("9x15");
    figure.textOut(16, 15, options.title, palette.text);
    drawLegend(figure, returns, palette);
    drawScale(figure, right + 16, static_cast<int>(options.height) - 16,
              std::min(rightWidth, height) / above.shorterSide, palette);
    return figure;
}

}  // namespace offmap::view
