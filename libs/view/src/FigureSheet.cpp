// SPDX-License-Identifier: BSD-3-Clause
#include "FigureSheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace offmap::view {

namespace {

using Mark = LegendEntry::Mark;
using mrpt::img::TColor;

// [px] of a figure of 1800 x 900
constexpr double letters = 15, margin = 16, rowHeight = 26, swatch = 13, lineMark = 22,
                 scaleMark = 130, beside = 8, between = 26;

/// A length of 1, 2 or 5 times a power of ten that is at most `length`. [m]
double roundLength(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= length) return factor * power;
    return power;
}

double markWidth(const LegendEntry& entry) {
    return entry.mark == Mark::Square ? swatch : entry.mark == Mark::Line ? lineMark : scaleMark;
}

uint32_t packed(const uint8_t* bgr) {
    return uint32_t{bgr[2]} << 16U | uint32_t{bgr[1]} << 8U | uint32_t{bgr[0]};
}

}  // namespace

FigureSheet::FigureSheet(uint32_t width, uint32_t height, const Palette& palette)
    : width_(width),
      height_(height),
      palette_(palette),
      unit_(std::clamp(std::sqrt(double(width) * height / (1800.0 * 900.0)), 0.8, 3.0)),
      canvas_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                         static_cast<int>(height))) {
    fill(palette.background, 0, 0, width, height);
}

void FigureSheet::fill(const TColor& colour, uint32_t x, uint32_t y, uint32_t width,
                       uint32_t height) {
    canvas_.colour(colour);
    canvas_.fill(x, y, width, height);
}

double FigureSheet::widthOf(const LegendEntry& entry) {
    double width = unit_ * (markWidth(entry) + beside) + canvas_.widthOf(entry.text);
    if (!entry.before.empty()) width += canvas_.widthOf(entry.before) + unit_ * beside;
    return width;
}

void FigureSheet::paint(const LegendEntry& entry, double x, double baseline) {
    if (!entry.before.empty()) {
        canvas_.colour(palette_.text);
        canvas_.text(entry.before, x, baseline);
        x += canvas_.widthOf(entry.before) + unit_ * beside;
    }
    const double width = std::round(unit_ * markWidth(entry)), left = std::round(x);
    const double height = std::round(unit_ * swatch), top = std::round(baseline + unit_ - height);
    if (entry.mark == Mark::Scale) {
        for (double at = 0; at < width; ++at) {
            canvas_.colour(entry.colourAt(at / (width - 1)));
            canvas_.fill(left + at, top, 1, height);
        }
    } else {
        const double thick = entry.mark == Mark::Line ? std::round(3 * unit_) : height;
        canvas_.colour(entry.colour);
        canvas_.fill(left, std::round(top + 0.5 * (height - thick)), width, thick);
    }
    canvas_.colour(palette_.text);
    canvas_.text(entry.text, left + width + unit_ * beside, baseline);
}

void FigureSheet::paintRow(std::span<const LegendEntry> entries, double x, double baseline) {
    for (const LegendEntry& entry : entries) {
        paint(entry, x, baseline);
        x += widthOf(entry) + unit_ * between;
    }
}

uint32_t FigureSheet::heading(const std::string& title, const std::vector<LegendEntry>& legend) {
    const double right = width_ - unit_ * margin, left = unit_ * margin;
    double baseline = std::round(28 * unit_);
    canvas_.letters(unit_ * letters, true);
    canvas_.colour(palette_.text);
    canvas_.text(title, left, baseline);
    const double titleEnd = title.empty() ? left : left + canvas_.widthOf(title) + unit_ * between;
    canvas_.letters(unit_ * letters);
    double whole = -unit_ * between;
    for (const LegendEntry& entry : legend) whole += widthOf(entry) + unit_ * between;
    if (titleEnd + whole <= right) {
        paintRow(legend, right - whole, baseline);
    } else {
        double x = right;  // none fits there: the first begins a row
        for (const LegendEntry& entry : legend) {
            if (x + widthOf(entry) > right) {
                x = left;
                baseline += std::round(rowHeight * unit_);
            }
            paint(entry, x, baseline);
            x += widthOf(entry) + unit_ * between;
        }
    }
    return static_cast<uint32_t>(baseline + std::round(16 * unit_));
}

void FigureSheet::scale(uint32_t left, uint32_t bottom, double pixelsPerMetre) {
    const double length = roundLength(160 * unit_ / pixelsPerMetre);
    const std::string text = fmt::format("{:g} m", length);
    const double width = std::round(length * pixelsPerMetre), x = left + std::round(margin * unit_),
                 y = bottom - std::round(margin * unit_), thick = std::round(3 * unit_);
    canvas_.letters(unit_ * letters);
    canvas_.colour(palette_.background);
    canvas_.fill(x - 8 * unit_, y - 28 * unit_, std::max(width, canvas_.widthOf(text)) + 16 * unit_,
                 36 * unit_);
    canvas_.colour(palette_.text);
    canvas_.fill(x, y - thick, width, thick);
    canvas_.text(text, x, y - thick - 6 * unit_);
}

void FigureSheet::paste(const mrpt::img::CImage& picture, uint32_t x, uint32_t y) {
    cairo_surface_t* surface = canvas_.surface();
    cairo_surface_flush(surface);
    const auto stride = static_cast<size_t>(cairo_image_surface_get_stride(surface));
    const auto columns = static_cast<uint32_t>(picture.getWidth());
    std::vector<uint32_t> line(columns);
    for (uint32_t row = 0; row < picture.getHeight(); ++row) {
        const auto* bgr = picture.ptr<uint8_t>(0, row);
        for (uint32_t column = 0; column < columns; ++column)
            line[column] = packed(bgr + 3 * size_t{column});
        std::memcpy(cairo_image_surface_get_data(surface) + (y + row) * stride + 4 * size_t{x},
                    line.data(), 4 * size_t{columns});
    }
    cairo_surface_mark_dirty(surface);
}

mrpt::img::CImage FigureSheet::image() {
    try {
        canvas_.finish();
    } catch (const std::runtime_error& e) {
        throw std::invalid_argument(e.what());
    }
    mrpt::img::CImage out(static_cast<int32_t>(width_), static_cast<int32_t>(height_),
                          mrpt::img::CH_RGB);
    const auto stride = static_cast<size_t>(cairo_image_surface_get_stride(canvas_.surface()));
    std::vector<uint32_t> line(width_);
    for (uint32_t row = 0; row < height_; ++row) {
        std::memcpy(line.data(), cairo_image_surface_get_data(canvas_.surface()) + row * stride,
                    4 * size_t{width_});
        auto* bgr = out.ptr<uint8_t>(0, row);
        for (const uint32_t pixel : line) {
            *bgr++ = static_cast<uint8_t>(pixel);
            *bgr++ = static_cast<uint8_t>(pixel >> 8U);
            *bgr++ = static_cast<uint8_t>(pixel >> 16U);
        }
    }
    return out;
}

}  // namespace offmap::view
