// SPDX-License-Identifier: BSD-3-Clause
#include "PlanCanvas.h"
#include "PlanLayout.h"
#include "PlanPainter.h"

#include <offmap/view/PlanFigure.h>

#include <array>
#include <cairo-svg.h>
#include <stdexcept>

namespace offmap::view {

namespace {

PlanLayout measuredLayout(const PlanFigure& figure) {
    PlanCanvas ruler(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    return layoutOf(figure, [&](const std::string& text, double letters) {
        ruler.letters(letters);
        return ruler.widthOf(text);
    });
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string pngOf(const PlanFigure& figure) {
    const PlanLayout layout = measuredLayout(figure);
    PlanCanvas canvas(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(layout.width),
                                                 static_cast<int>(layout.height)));
    PlanPainter(figure, layout, canvas).paint();
    std::string bytes;
    if (cairo_surface_write_to_png_stream(canvas.surface(), append, &bytes) !=
        CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error("there is no memory for the picture");
    }
    return bytes;
}

std::string svgOf(const PlanFigure& figure) {
    const PlanLayout layout = measuredLayout(figure);
    std::string text;  // before the surface, which writes to it to its end
    cairo_surface_t* surface =
        cairo_svg_surface_create_for_stream(append, &text, layout.width, layout.height);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    PlanCanvas canvas(surface);
    PlanPainter(figure, layout, canvas).paint();
    cairo_surface_finish(surface);
    return text;
}

mrpt::img::TColor planColour(size_t index) {
    static const std::array<mrpt::img::TColor, 10> colours{{{27, 73, 125},
                                                            {200, 55, 60},
                                                            {36, 135, 85},
                                                            {214, 130, 20},
                                                            {116, 75, 160},
                                                            {0, 130, 150},
                                                            {140, 85, 40},
                                                            {205, 85, 165},
                                                            {105, 112, 122},
                                                            {150, 155, 20}}};
    return colours.at(index % colours.size());
}

}  // namespace offmap::view
