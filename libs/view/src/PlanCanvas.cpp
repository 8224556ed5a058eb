// SPDX-License-Identifier: BSD-3-Clause
#include "PlanCanvas.h"

#include <array>
#include <numbers>
#include <stdexcept>

namespace offmap::view {

namespace {

void require(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw std::runtime_error(std::string("the picture cannot be drawn: ") +
                             cairo_status_to_string(status));
}

}  // namespace

PlanCanvas::PlanCanvas(cairo_surface_t* surface)
    : surface_(surface, cairo_surface_destroy), cairo_(cairo_create(surface), cairo_destroy) {
    require(cairo_surface_status(surface_.get()));
    require(cairo_status(cairo_.get()));
    cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

void PlanCanvas::colour(const mrpt::img::TColor& colour) {
    cairo_set_source_rgb(cairo_.get(), colour.R / 255.0, colour.G / 255.0, colour.B / 255.0);
}

void PlanCanvas::width(double pixels) { cairo_set_line_width(cairo_.get(), pixels); }

void PlanCanvas::dashes(double on, double off) {
    const std::array<double, 2> lengths{on, off};
    cairo_set_dash(cairo_.get(), lengths.data(), static_cast<int>(lengths.size()), 0);
}

void PlanCanvas::solid() { cairo_set_dash(cairo_.get(), nullptr, 0, 0); }

void PlanCanvas::path(std::span<const mrpt::math::TPoint2D> points) {
    cairo_new_sub_path(cairo_.get());
    for (const auto& point : points) cairo_line_to(cairo_.get(), point.x, point.y);
}

void PlanCanvas::stroke() { cairo_stroke(cairo_.get()); }

void PlanCanvas::line(const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to) {
    path(std::array{from, to});
    stroke();
}

void PlanCanvas::fill(double x, double y, double width, double height) {
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_fill(cairo_.get());
}

void PlanCanvas::frame(double x, double y, double width, double height) {
    cairo_rectangle(cairo_.get(), x, y, width, height);
    stroke();
}

void PlanCanvas::disc(const mrpt::math::TPoint2D& centre, double radius) {
    cairo_new_sub_path(cairo_.get());
    cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_fill(cairo_.get());
}

void PlanCanvas::letters(double size, bool bold) {
    cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), size);
}

double PlanCanvas::widthOf(const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void PlanCanvas::text(const std::string& text, double x, double y, Align align) {
    const double share = align == Align::Left ? 0 : align == Align::Middle ? 0.5 : 1;
    cairo_move_to(cairo_.get(), x - share * widthOf(text), y);
    cairo_show_text(cairo_.get(), text.c_str());
    cairo_new_path(cairo_.get());
}

void PlanCanvas::textUpwards(const std::string& words, double x, double y) {
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), x, y);
    cairo_rotate(cairo_.get(), -0.5 * std::numbers::pi);
    text(words, 0, 0, Align::Middle);
    cairo_restore(cairo_.get());
}

void PlanCanvas::finish() {
    cairo_surface_flush(surface_.get());
    require(cairo_status(cairo_.get()));
    require(cairo_surface_status(surface_.get()));
}

}  // namespace offmap::view
