// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "WxText.h"

#include <offmap/rawlog/OutputFile.h>

#include <stdexcept>
#include <wx/mstream.h>

namespace offmap::window {

void writePicture(const wxImage& picture, const std::filesystem::path& file) {
    wxMemoryOutputStream png;
    if (!picture.IsOk() || !picture.SaveFile(png, wxBITMAP_TYPE_PNG)) {
        throw std::runtime_error(file.string() + ": there is no picture to be written");
    }
    const auto* buffer = png.GetOutputStreamBuffer();
    rawlog::OutputFile out(file, {});
    out.write({static_cast<const char*>(buffer->GetBufferStart()), png.GetSize()});
    out.publish();
}

}  // namespace offmap::window
