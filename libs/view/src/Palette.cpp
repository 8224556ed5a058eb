// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Palette.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace offmap::view {

namespace {

using mrpt::img::TColor;

uint8_t mixed(uint8_t a, uint8_t b, double share) {
    return static_cast<uint8_t>(std::lround((1 - share) * a + share * b));
}

TColor between(const TColor& a, const TColor& b, double share) {
    return {mixed(a.R, b.R, share), mixed(a.G, b.G, share), mixed(a.B, b.B, share)};
}

template <size_t N>
TColor along(const std::array<TColor, N>& stops, double share) {
    // What is no number goes to the first.
    const double place = (share > 0 ? std::min(share, 1.0) : 0.0) * static_cast<double>(N - 1);
    const auto low = std::min(static_cast<size_t>(place), N - 2);
    return between(stops[low], stops[low + 1], place - static_cast<double>(low));
}

}  // namespace

TColor Palette::of(core::PointLabel label) const {
    switch (label) {
        case core::PointLabel::Mapped:
            return mapped;
        case core::PointLabel::Kept:
            return kept;
        case core::PointLabel::Orphan:
            return orphan;
        case core::PointLabel::NotOnVerticalSegment:
            break;
    }
    return rest;
}

TColor Palette::of(core::KeepReason reason) const {
    const bool onLight = background.R > 128;
    switch (reason) {
        case core::KeepReason::None:
            break;
        case core::KeepReason::InFrontOfWall:
            return kept;
        case core::KeepReason::BehindWall:
            return onLight ? TColor{219, 39, 119} : TColor{244, 114, 182};  // pink
        case core::KeepReason::NoWallOnRay:
            return onLight ? TColor{147, 51, 234} : TColor{192, 132, 252};  // violet
        case core::KeepReason::AmbiguousCorner:
            return onLight ? TColor{161, 98, 7} : TColor{250, 204, 21};  // yellow
        case core::KeepReason::NoPose:
            return onLight ? TColor{234, 88, 12} : TColor{251, 146, 60};  // orange
    }
    return rest;
}

Palette Palette::light() {
    return {.background{250, 250, 249},
            .mapped{185, 28, 28},
            .kept{22, 130, 60},
            .rest{150, 155, 165},
            .orphan{180, 100, 20},
            .wall{37, 99, 235},
            .sensor{202, 138, 4},
            .refined{13, 148, 136},
            .text{30, 41, 59},
            .highlight{2, 6, 23}};
}

TColor sequential(double share) {
    static const std::array<TColor, 5> stops{TColor{98, 44, 138}, TColor{60, 82, 139},
                                             TColor{33, 145, 140}, TColor{94, 201, 98},
                                             TColor{245, 225, 60}};
    return along(stops, share);
}

TColor diverging(double share) {
    static const std::array<TColor, 5> stops{TColor{40, 90, 210}, TColor{110, 175, 225},
                                             TColor{232, 210, 125}, TColor{240, 135, 85},
                                             TColor{200, 30, 40}};
    return along(stops, 0.5 * (share + 1));
}

}  // namespace offmap::view
