// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/TColor.h>
#include <mrpt/math/TPoint2D.h>

#include <cairo.h>
#include <memory>
#include <span>
#include <string>

namespace offmap::view {

/// Cairo, as far as plans and figures need it. All lengths in [px] from the top left corner.
class PlanCanvas {
 public:
    enum class Align : uint8_t { Left, Middle, Right };

    /// Takes the surface over. \throw std::runtime_error if there is no memory for it
    explicit PlanCanvas(cairo_surface_t* surface);

    void colour(const mrpt::img::TColor& colour);
    void width(double pixels);
    void dashes(double on, double off);
    void solid();

    /// Adds to the path that stroke() draws.
    void path(std::span<const mrpt::math::TPoint2D> points);
    void stroke();
    void line(const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to);
    void fill(double x, double y, double width, double height);
    void frame(double x, double y, double width, double height);
    void disc(const mrpt::math::TPoint2D& centre, double radius);

    void letters(double size, bool bold = false);
    double widthOf(const std::string& text);
    /// Its letters stand on y.
    void text(const std::string& text, double x, double y, Align align = Align::Left);
    /// Turned to run upwards, its middle at y.
    void textUpwards(const std::string& words, double x, double y);

    cairo_surface_t* surface() { return surface_.get(); }
    /// \throw std::runtime_error if anything went wrong
    void finish();

 private:
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
    std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo_;
};

}  // namespace offmap::view
