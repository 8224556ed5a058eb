// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoPoses.h"

#include <string>

namespace offmap::app {

/// The sources of poses, which of them is taken, and how the vehicle moved by it.
std::string poseSection(const PoseFacts& poses);

}  // namespace offmap::app
