// SPDX-License-Identifier: BSD-3-Clause
#include "FrameIntensities.h"

#include <offmap/rawlog/Intensities.h>
#include <offmap/rawlog/ScanClasses.h>

namespace offmap::window {

std::vector<float> intensitiesOf(const live::LiveFrame& frame) {
    const auto& turn = frame.arrived.turn;
    // Settings of the sensor tell where returns are, not how bright.
    const auto* scanClass = rawlog::scanClassOf(*turn.front(), rawlog::SensorConfig());
    if (!scanClass) return {};
    return rawlog::pointIntensitiesOf(turn, *scanClass, frame.reduced.organized.scan);
}

}  // namespace offmap::window
