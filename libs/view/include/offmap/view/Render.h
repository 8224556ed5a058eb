// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Camera.h>

#include <mrpt/img/CImage.h>
#include <mrpt/img/TColor.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <cstdint>
#include <filesystem>

namespace offmap::view {

/// Takes a picture; needs no screen. A scene can be drawn once only: MRPT ties its buffers to the
/// first context that draws it. \throw std::runtime_error if there is no OpenGL driver.
mrpt::img::CImage render(const mrpt::opengl::CSetOfObjects::Ptr& scene, const Camera& camera,
                         uint32_t width, uint32_t height, const mrpt::img::TColor& background);

/// Writes a picture as PNG whatever the file's extension; it appears under its name when complete.
/// \throw std::runtime_error naming the file if it cannot be written.
void writePng(const mrpt::img::CImage& image, const std::filesystem::path& file);

}  // namespace offmap::view
