// SPDX-License-Identifier: BSD-3-Clause
#include "../PlainText.h"
#include "MapCheckResult.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/view/PlanFigure.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace offmap::app {

using evaluation::BinCheck;
using evaluation::BinState;
using evaluation::WallCheck;
using mrpt::img::TColor;
using mrpt::math::TPoint2D;
using view::PlanLegendEntry;

namespace {

constexpr double exaggeration = 10;  // of offsets in the profile
const TColor neverSeen(185, 188, 194), missing(190, 70, 190), profileColour(70, 70, 80),
    seenColour(190, 186, 200);

/// In front of the drawn wall blue, on it green, behind it red; both ends reached at the limit.
TColor offsetColour(double offset, double limit) {
    static const std::array<std::array<double, 3>, 5> colours{
        {{24, 60, 150}, {60, 150, 215}, {70, 165, 85}, {240, 140, 40}, {175, 20, 35}}};
    const double place = 2 + 2 * std::clamp(offset / limit, -1.0, 1.0);  // 0 ... 4
    const auto below = std::min(static_cast<size_t>(place), colours.size() - 2);
    const double above = place - static_cast<double>(below);
    const auto mixed = [&](size_t channel) {
        return static_cast<uint8_t>(std::lround((1 - above) * colours[below][channel] +
                                                above * colours[below + 1][channel]));
    };
    return {mixed(0), mixed(1), mixed(2)};
}

/// [m] What all but the furthest twentieth of the bins keeps within, rounded up to a centimetre.
double colourLimit(const MapCheckResult& result) {
    constexpr double least = 0.02, step = 0.01;  // [m]
    std::vector<double> offsets;
    for (const WallCheck& check : result.walls) {
        for (const BinCheck& bin : check.bins) {
            if (bin.state == BinState::Seen) offsets.push_back(std::abs(bin.offset.mean()));
        }
    }
    if (offsets.empty()) return least;
    const auto most = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() * 95 / 100);
    std::nth_element(offsets.begin(), most, offsets.end());
    return std::max(least, step * std::ceil(*most / step));
}

/// The part of a wall between two shares of its way.
core::Wall partOf(const core::Wall& wall, double from, double to) {
    core::Wall part = wall;
    part.line = {placeAt(wall, from), placeAt(wall, to)};
    return part;
}

TPoint2D leftNormalAt(const core::Wall& wall, double share) {
    constexpr double step = 1e-3;  // of the way
    const TPoint2D way = placeAt(wall, share + step) - placeAt(wall, share - step);
    return TPoint2D(-way.y, way.x) * (1 / way.norm());
}

class Picture {
 public:
    explicit Picture(const MapCheckResult& result) : result_(result), limit_(colourLimit(result)) {}

    view::PlanFigure figure() {
        for (const WallCheck& check : result_.walls) addWall(check);
        for (const WallCheck& check : result_.walls) {
            addProfile(check, &BinCheck::leftFace);
            addProfile(check, &BinCheck::rightFace);
        }
        for (const TPoint2D& place : result_.seen) {
            figure_.dots.push_back({place, seenColour, 1.2});
        }
        figure_.title = printable(result_.mapName);
        figure_.subtitle = fmt::format("{} scans; profile of offsets {} times as large",
                                       result_.scans, exaggeration);
        addLegend();
        return std::move(figure_);
    }

 private:
    void addWall(const WallCheck& check) {
        constexpr double width = 6, thin = 3;  // [px]
        const core::Wall& wall = result_.file.walls[check.wall];
        for (const BinCheck& bin : check.bins) {
            const core::Wall part = partOf(wall, bin.from / check.length, bin.to / check.length);
            const bool seen = bin.state == BinState::Seen;
            const TColor& unseen = bin.state == BinState::Missing ? missing : neverSeen;
            figure_.strokes.push_back(
                {.wall = part,
                 .colour = seen ? offsetColour(bin.offset.mean(), limit_) : unseen,
                 .width = seen ? width : thin});
        }
    }

    /// A line from bin to bin where the face was seen in both.
    void addProfile(const WallCheck& check, std::optional<double> BinCheck::*face) {
        constexpr double width = 1.6;  // [px]
        const core::Wall& wall = result_.file.walls[check.wall];
        std::optional<TPoint2D> last;
        for (const BinCheck& bin : check.bins) {
            std::optional<TPoint2D> place;
            if (bin.state == BinState::Seen && bin.*face) {
                const double share = 0.5 * (bin.from + bin.to) / check.length;
                place = placeAt(wall, share) +
                        leftNormalAt(wall, share) * (exaggeration * *(bin.*face));
            }
            if (last && place) {
                figure_.strokes.push_back(
                    {.wall = {{*last, *place}}, .colour = profileColour, .width = width});
            }
            last = place;
        }
    }

    void addLegend() {
        for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const double centimetres = 100 * share * limit_;
            const std::string text = share < 0   ? fmt::format("{:.3g} cm in front", -centimetres)
                                     : share > 0 ? fmt::format("{:.3g} cm behind", centimetres)
                                                 : std::string("as drawn");
            figure_.legend.push_back(
                {(std::abs(share) == 1 ? "≥ " : "") + text, offsetColour(share * limit_, limit_)});
        }
        figure_.legend.push_back({"hidden or out of view", neverSeen});
        figure_.legend.push_back({"missing: looked through", missing});
        figure_.legend.push_back({fmt::format("profile, x {}", exaggeration), profileColour});
        figure_.legend.push_back({"seen off the walls", seenColour, PlanLegendEntry::Mark::Dot});
    }

    const MapCheckResult& result_;
    double limit_;  // [m]
    view::PlanFigure figure_;
};

}  // namespace

std::string checkPicture(const MapCheckResult& result, const std::string& extension) {
    const view::PlanFigure figure = Picture(result).figure();
    return extension == ".png" ? view::pngOf(figure) : view::svgOf(figure);
}

}  // namespace offmap::app
