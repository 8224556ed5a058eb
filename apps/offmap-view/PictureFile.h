// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <wx/image.h>

namespace offmap::window {

/// Writes a PNG; it appears under its name when complete.
/// \throw std::runtime_error naming the file if it cannot be written
void writePicture(const wxImage& picture, const std::filesystem::path& file);

}  // namespace offmap::window
