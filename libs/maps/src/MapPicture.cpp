// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/MapPicture.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::maps {

const std::vector<std::string_view>& pictureExtensions() {
    static const std::vector<std::string_view> all{".png", ".pgm",  ".ppm", ".pnm", ".bmp",
                                                   ".jpg", ".jpeg", ".tif", ".tiff"};
    return all;
}

Drawing readMapPicture(const std::filesystem::path& file, const MapOptions& options) {
    if (!options.resolution) {
        throw std::runtime_error(fmt::format(
            "{}: a picture does not say how large it is; add --map-resolution, the metres of a "
            "pixel, or name the map.yaml that belongs to the picture of a ROS map",
            file.string()));
    }
    PictureGrid picture = readPicture(file, *options.resolution, [](double brightness) {
        return brightness < 0.5 ? Cell::Occupied : Cell::Free;
    });
    Drawing drawing = drawingOf(std::move(picture.grid), options, "picture", file.string());
    drawing.warnings.insert(drawing.warnings.end(), picture.warnings.begin(),
                            picture.warnings.end());
    return drawing;
}

}  // namespace offmap::maps
