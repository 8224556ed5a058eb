// SPDX-License-Identifier: BSD-3-Clause
#include "LiveRecorder.h"

#include <offmap/rawlog/RefinedPose.h>

namespace offmap::app {

void LiveRecorder::add(const live::LiveFrame& frame) {
    const auto& turn = frame.arrived.turn;
    for (size_t i = 0; i < turn.size(); ++i) {
        const auto& reduced = frame.reduced.reduced[i];
        writer_.write(reduced ? *reduced : *turn[i]);
    }
    // Without them, what was tracked or came from elsewhere would be lost.
    if (frame.reduced.vehicleInMap) {
        writer_.write(*rawlog::robotPose(*frame.reduced.vehicleInMap, frame.reduced.record.time,
                                         "OFFMAP_POSE"));
    }
}

}  // namespace offmap::app
