// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Camera.h>

#include <mrpt/opengl/CCamera.h>

namespace offmap::view {

/// The camera as MRPT's scenes take it.
mrpt::opengl::CCamera mrptCameraOf(const Camera& camera);

}  // namespace offmap::view
