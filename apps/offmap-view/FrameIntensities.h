// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFrame.h>

#include <vector>

namespace offmap::window {

/// How bright each point of the frame's scan is; empty if the sensor does not tell.
std::vector<float> intensitiesOf(const live::LiveFrame& frame);

}  // namespace offmap::window
