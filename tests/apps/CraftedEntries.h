// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/Scans.h"
#include "../support/SimulatedRobot.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <string>

namespace offmap::test {

/// Bytes that MRPT's deserialiser does not survive, though they begin like an entry of a rawlog.

/// A 2D scan of 2^31 - 1 rays.
inline std::string scanOfHugeLength() {
    std::string scan = bytesOf(*SimulatedRobot().horizontalScan());
    return scan.replace(scan.find(std::string("\xb5\0\0\0", 4)), 4, "\xff\xff\xff\x7f");  // 181
}

/// Sensory frames inside sensory frames, as MRPT's interface would not let one make them.
inline std::string framesNested(int depth) {
    const auto comment = SimulatedRobot().comment("deep");
    mrpt::obs::CSensoryFrame frame;
    frame.push_back(comment);
    const std::string inner = bytesOf(*comment), outer = bytesOf(frame);
    const size_t begin = outer.find(inner);
    std::string opening, closing;
    for (int i = 0; i < depth; ++i) {
        opening += outer.substr(0, begin);
        closing += outer.substr(begin + inner.size());
    }
    return opening + inner + closing;
}

inline std::string actionsHoldingAComment() {
    mrpt::obs::CActionCollection actions;
    mrpt::obs::CActionRobotMovement2D action;
    actions.insert(action);
    std::string collection = bytesOf(actions);
    const std::string inner = bytesOf(*actions.get(0));
    return collection.replace(collection.find(inner), inner.size(),
                              bytesOf(*SimulatedRobot().comment("no action")));
}

}  // namespace offmap::test
