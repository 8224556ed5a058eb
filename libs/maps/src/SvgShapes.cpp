// SPDX-License-Identifier: BSD-3-Clause
#include "SvgShapes.h"

#include "SvgViewport.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace offmap::maps::svg {

namespace {

using Eigen::Vector2d;

/// An element and the viewport that its percentages are of.
struct Shape {
    const pugi::xml_node& element;
    const Vector2d& viewport;

    double x(const char* attribute) const { return lengthIn(element, attribute, viewport.x(), 0); }
    double y(const char* attribute) const { return lengthIn(element, attribute, viewport.y(), 0); }
    Vector2d place(const char* xName, const char* yName) const { return {x(xName), y(yName)}; }

    /// A radius of -1 is one that is not given. \throw std::runtime_error if it is below 0
    double radius(const char* attribute) const {
        const double whole = viewport.norm() / std::sqrt(2.0);
        const double radius = lengthIn(element, attribute, whole, -1);
        if (radius < 0 && element.attribute(attribute) && radius != -1)
            throw std::runtime_error(fmt::format("{} is {:g}, below 0", attribute, radius));
        return radius;
    }
};

void drawPathData(const std::string& text, const char* attribute, Pen& pen) {
    if (followPath(text, pen)) return;
    throw std::runtime_error(fmt::format("{} holds no valid path: '{:.40}...'", attribute, text));
}

void drawPath(const Shape& shape, Pen& pen) {
    const std::string text = shape.element.attribute("d").value();
    if (text != "none") drawPathData(text, "d", pen);
}

/// Points are a path of lines without its letters.
void drawPoints(const Shape& shape, Pen& pen, bool isClosed) {
    const std::string points = shape.element.attribute("points").value();
    if (points.find_first_not_of(" \t\r\n,") == std::string::npos) return;
    drawPathData("M" + points + (isClosed ? "Z" : ""), "points", pen);
}

void drawLine(const Shape& shape, Pen& pen) {
    pen.moveTo(shape.place("x1", "y1"));
    pen.lineTo(shape.place("x2", "y2"));
}

void drawRect(const Shape& shape, Pen& pen) {
    const Vector2d low = shape.place("x", "y"), size = shape.place("width", "height");
    if (!(size.minCoeff() > 0)) return;
    double rx = shape.radius("rx"), ry = shape.radius("ry");
    if (rx < 0) rx = std::max(ry, 0.0);
    if (ry < 0) ry = rx;
    rx = std::min(rx, size.x() / 2);
    ry = std::min(ry, size.y() / 2);
    const Vector2d high = low + size;
    const auto cornerTo = [&](double x, double y) {
        pen.arcTo({{rx, ry}, 0, false, true, {x, y}});
    };
    pen.moveTo({low.x() + rx, low.y()});
    pen.lineTo({high.x() - rx, low.y()});
    cornerTo(high.x(), low.y() + ry);
    pen.lineTo({high.x(), high.y() - ry});
    cornerTo(high.x() - rx, high.y());
    pen.lineTo({low.x() + rx, high.y()});
    cornerTo(low.x(), high.y() - ry);
    pen.lineTo({low.x(), low.y() + ry});
    cornerTo(low.x() + rx, low.y());
}

void drawEllipse(const Shape& shape, Pen& pen, double rx, double ry) {
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    if (rx > 0 && ry > 0) pen.ellipse(shape.place("cx", "cy"), {rx, ry});
}

using Draw = std::function<void(const Shape&, Pen&)>;

const Draw* drawingOf(std::string_view name) {
    static const std::array<std::pair<std::string_view, Draw>, 7> all{{
        {"path", drawPath},
        {"line", drawLine},
        {"polyline", [](const Shape& shape, Pen& pen) { drawPoints(shape, pen, false); }},
        {"polygon", [](const Shape& shape, Pen& pen) { drawPoints(shape, pen, true); }},
        {"rect", drawRect},
        {"circle", [](const Shape& shape,
                      Pen& pen) { drawEllipse(shape, pen, shape.radius("r"), shape.radius("r")); }},
        {"ellipse",
         [](const Shape& shape, Pen& pen) {
             drawEllipse(shape, pen, shape.radius("rx"), shape.radius("ry"));
         }},
    }};
    const auto found = std::ranges::find(all, name, [](const auto& entry) { return entry.first; });
    return found == all.end() ? nullptr : &found->second;
}

}  // namespace

bool isShape(std::string_view element) { return drawingOf(element) != nullptr; }

void drawShape(const pugi::xml_node& element, std::string_view name, const Vector2d& viewport,
               Pen& pen) {
    (*drawingOf(name))({element, viewport}, pen);
}

}  // namespace offmap::maps::svg
