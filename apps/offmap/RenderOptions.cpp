// SPDX-License-Identifier: BSD-3-Clause
#include "RenderOptions.h"

#include "PlainText.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <charconv>
#include <map>

namespace offmap::app {

namespace {

const std::map<std::string, view::FigureView> views{{"both", view::FigureView::Both},
                                                    {"top", view::FigureView::Top},
                                                    {"perspective", view::FigureView::Perspective}};

const std::map<std::string, view::ColourBy> colourings{{"label", view::ColourBy::Label},
                                                       {"height", view::ColourBy::Height},
                                                       {"intensity", view::ColourBy::Intensity},
                                                       {"residual", view::ColourBy::Residual},
                                                       {"reason", view::ColourBy::Reason}};

constexpr uint32_t smallest = 200, largest = 4000;  // [px] of a picture's side

/// A number of pixels, all of the text.
std::optional<uint32_t> pixelsIn(std::string_view text) {
    uint32_t pixels = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (pixels < smallest || pixels > largest) return std::nullopt;
    return pixels;
}

}  // namespace

void RenderOptions::addTo(CLI::App& command) {
    command.add_option("IN", input, "Rawlog; it is only read")->required()->type_name("FILE");
    command.add_option("-o,--out", output, "Picture")->required()->type_name("F.png");
    shared.addTo(command);
    command.add_option("--entry", entry, "The first scan at or after this entry of the log (0)")
        ->type_name("N");
    command.add_option("--view", view, "Seen from aside, from above, or both (both)")
        ->check(CLI::IsMember(&views).description(""))
        ->type_name("both|top|perspective");
    command
        .add_option("--azimuth-deg", azimuthDeg,
                    "Where it is seen from aside, counter-clockwise from the map's x axis (-120)")
        ->check(CLI::Range(-360.0, 360.0).description(""))
        ->type_name("DEG");
    command
        .add_option("--elevation-deg", elevationDeg,
                    "How high it is seen from, above the horizon (32)")
        ->check(CLI::Range(-89.0, 89.0).description(""))
        ->type_name("DEG");
    command
        .add_option("--colour-by", colourBy,
                    "What colours tell: what became of a return, its height, its intensity, how "
                    "far its segment is off the wall, why it was kept (label)")
        ->check(CLI::IsMember(&colourings).description(""))
        ->type_name("label|height|intensity|residual|reason");
    command.add_option("--theme", theme, "The ground (dark)")
        ->check(CLI::IsMember({"dark", "light"}).description(""))
        ->type_name("dark|light");
    command.add_flag("--hide-mapped", hideMapped, "Leave out what is removed");
    command.add_option("--size", size, "Pixels of the picture (1800x900)")->type_name("WxH");
    command.add_flag("--force", force, "Replace an existing picture");
}

view::FigureOptions RenderOptions::figure() const {
    view::FigureOptions figure;
    figure.title = printable(input.filename().string());
    figure.fallbackSensorInMap = mrpt::poses::CPose3D();
    figure.view = views.at(view);
    figure.colourBy = colourings.at(colourBy);
    figure.scene.showMapped = !hideMapped;
    if (theme == "light") figure.scene.palette = view::Palette::light();
    if (figure.view == view::FigureView::Top && (azimuthDeg || elevationDeg)) {
        throw UsageError(
            "--azimuth-deg and --elevation-deg turn the picture from aside; --view top has none");
    }
    if (azimuthDeg) figure.azimuth = mrpt::DEG2RAD(*azimuthDeg);
    if (elevationDeg) figure.elevation = mrpt::DEG2RAD(*elevationDeg);
    if (size.empty()) return figure;
    const size_t cross = size.find('x');
    const auto width = pixelsIn(std::string_view(size).substr(0, cross));
    const auto height =
        cross == std::string::npos ? width : pixelsIn(std::string_view(size).substr(cross + 1));
    if (cross == std::string::npos || !width || !height) {
        throw UsageError(
            fmt::format("--size {}: give width x height in pixels, each from {} to "
                        "{}: --size 1800x900",
                        size, smallest, largest));
    }
    figure.width = *width;
    figure.height = *height;
    return figure;
}

}  // namespace offmap::app
