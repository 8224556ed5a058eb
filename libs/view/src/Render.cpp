// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/MrptCamera.h>
#include <offmap/view/Render.h>

#include <fmt/format.h>
#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace offmap::view {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<mrpt::opengl::CFBORender> offscreen(uint32_t width, uint32_t height) try {
    return std::make_unique<mrpt::opengl::CFBORender>(width, height);
} catch (const std::exception& e) {
    const std::string_view why = e.what();
    throw std::runtime_error(
        fmt::format("cannot draw without a screen: no EGL driver for OpenGL works (Debian: "
                    "libegl1, libgl1-mesa-dri): {}",
                    why.substr(0, why.find('\n'))));
}

/// OpenCV, which encodes the picture, does not tell of a disk that is full.
bool endsAsPng(const fs::path& file) {
    constexpr std::string_view end("IEND\xAE\x42\x60\x82", 8);
    std::array<char, end.size()> last{};
    std::ifstream in(file, std::ios::binary);
    in.seekg(-static_cast<std::streamoff>(last.size()), std::ios::end);
    return in.read(last.data(), last.size()) && std::string_view(last.data(), last.size()) == end;
}

}  // namespace

mrpt::img::CImage render(const mrpt::opengl::CSetOfObjects::Ptr& scene, const Camera& camera,
                         uint32_t width, uint32_t height, const mrpt::img::TColor& background) {
    mrpt::opengl::COpenGLScene stage;
    stage.insert(scene);
    const auto view = stage.getViewport();
    view->setCustomBackgroundColor(mrpt::img::TColorf(background));
    view->setViewportClipDistances(0.1F, 10'000.0F);
    // MRPT 2.5 reads the picture back in rows of whole 4-byte words and overruns its buffer
    // otherwise.
    const uint32_t wholeWords = (width + 3) / 4 * 4;
    const auto renderer = offscreen(wholeWords, height);
    renderer->setCamera(stage, mrptCameraOf(camera));
    mrpt::img::CImage wide(static_cast<int32_t>(wholeWords), static_cast<int32_t>(height),
                           mrpt::img::CH_RGB);
    renderer->render_RGB(stage, wide);
    mrpt::img::CImage image;
    wide.extract_patch(image, (wholeWords - width) / 2, 0, width, height);
    return image;
}

void writePng(const mrpt::img::CImage& image, const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder))
        throw std::runtime_error(fmt::format("{}: cannot write the picture: there is no folder {}",
                                             file.string(), folder.string()));
    const fs::path unfinished =
        folder / fmt::format(".{}.{}.png", file.filename().string(), getpid());
    bool written = false;
    try {
        written = image.saveToFile(unfinished.string()) && endsAsPng(unfinished);
        if (written) fs::rename(unfinished, file);
    } catch (const std::exception&) {
        written = false;
    }
    if (written) return;
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw std::runtime_error(
        fmt::format("{}: cannot write the picture: is the folder writable, and is there space?",
                    file.string()));
}

}  // namespace offmap::view
