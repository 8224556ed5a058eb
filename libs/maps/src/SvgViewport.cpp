// SPDX-License-Identifier: BSD-3-Clause
#include "SvgViewport.h"

#include "SvgAttributes.h"
#include "SvgValues.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace offmap::maps::svg {

namespace {

using Eigen::Vector2d;

constexpr double pixel = 0.0254 / 96;  // [m]

[[noreturn]] void refuse(const char* attribute, const char* text, std::string_view needed) {
    throw std::runtime_error(
        fmt::format("{} is '{:.40}', but has to be {}", attribute, std::string_view(text), needed));
}

struct ViewBox {
    Vector2d low, size;  // [user units]
};

std::optional<ViewBox> viewBoxOf(const pugi::xml_node& element) {
    const auto attribute = element.attribute("viewBox");
    if (!attribute) return std::nullopt;
    const auto numbers = numbersOf(attribute.value());
    const bool isBox = numbers && numbers->size() == 4 && (*numbers)[2] > 0 && (*numbers)[3] > 0 &&
                       std::ranges::all_of(*numbers, [](double x) { return std::isfinite(x); });
    if (!isBox) refuse("viewBox", attribute.value(), "x y width height, the last two above 0");
    return ViewBox{{(*numbers)[0], (*numbers)[1]}, {(*numbers)[2], (*numbers)[3]}};
}

/// [px] of the sheet; none if not given, or as a share of a page that is not known.
std::optional<double> physicalLength(const pugi::xml_node& root, const char* attribute) {
    const std::string_view text = root.attribute(attribute).value();
    if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
    const auto length = lengthOf(text, 0);
    if (!length || !(*length > 0) || !std::isfinite(*length))
        refuse(attribute, text.data(), "a length above 0, as 420mm");
    return length;
}

/// Of user units, in x and y, for a viewport of this size.
Vector2d fittedScale(const Vector2d& size, const ViewBox& box, const pugi::xml_node& element) {
    Vector2d scale = size.cwiseQuotient(box.size);
    const std::string_view aspect = element.attribute("preserveAspectRatio").value();
    if (aspect.find("none") != std::string_view::npos) return scale;
    return Vector2d::Constant(aspect.find("slice") == std::string_view::npos ? scale.minCoeff()
                                                                             : scale.maxCoeff());
}

struct UserUnit {
    Vector2d metres;  // of one, in x and y
    std::string note;
};

UserUnit userUnit(const pugi::xml_node& root, const std::optional<ViewBox>& box,
                  const MapOptions& options) {
    if (options.units) {
        return {Vector2d::Constant(inMetres(*options.units)),
                fmt::format("unit: 1 user unit is 1 {}, as asked for", toString(*options.units))};
    }
    const auto width = physicalLength(root, "width"), height = physicalLength(root, "height");
    if (!box || (!width && !height)) {
        return {Vector2d::Constant(pixel),
                "unit: the drawing states none; 1 user unit is taken as 1/96 inch"};
    }
    const double largest = std::numeric_limits<double>::max();
    Vector2d scale =
        pixel * fittedScale({width.value_or(largest), height.value_or(largest)}, *box, root);
    if (!width) scale.x() = scale.y();
    if (!height) scale.y() = scale.x();
    return {scale, fmt::format("unit: 1 user unit is {:.6g} mm, as the width and the height of the "
                               "drawing say",
                               1000 * scale.x())};
}

Vector2d lowerLeftOf(const pugi::xml_node& root) {
    const auto attribute = root.attribute(lowerLeft);
    if (!attribute) return {0, 0};
    const auto numbers = numbersOf(attribute.value());
    if (!numbers || numbers->size() != 2) refuse(lowerLeft, attribute.value(), "x y, in metres");
    return {(*numbers)[0], (*numbers)[1]};
}

}  // namespace

double lengthIn(const pugi::xml_node& element, const char* attribute, double whole,
                double otherwise) {
    const char* const text = element.attribute(attribute).value();
    if (*text == '\0' || std::string_view(text) == "auto") return otherwise;
    const auto length = lengthOf(text, whole);
    if (!length || !std::isfinite(*length)) refuse(attribute, text, "a length");
    return *length;
}

Viewport innerViewport(const pugi::xml_node& element, const pugi::xml_node& sized,
                       const Vector2d& outer) {
    const Vector2d corner(lengthIn(sized, "x", outer.x(), 0), lengthIn(sized, "y", outer.y(), 0));
    const Vector2d size(lengthIn(sized, "width", outer.x(), outer.x()),
                        lengthIn(sized, "height", outer.y(), outer.y()));
    Viewport inner{Eigen::Affine2d::Identity(), size};
    inner.toOuter.translate(corner);
    if (const auto box = viewBoxOf(element)) {
        const Vector2d scale = fittedScale(size, *box, element);
        // What does not fill the viewport stands in its middle.
        inner.toOuter.translate(0.5 * (size - scale.cwiseProduct(box->size)));
        inner.toOuter.scale(scale).translate(-box->low);
        inner.size = box->size;
    }
    return inner;
}

Sheet sheetOf(const pugi::xml_node& root, const MapOptions& options) {
    auto box = viewBoxOf(root);
    const UserUnit unit = userUnit(root, box, options);
    Sheet sheet;
    sheet.note = unit.note;
    sheet.lowerLeft = lowerLeftOf(root);
    if (!box) {
        const auto width = physicalLength(root, "width"), height = physicalLength(root, "height");
        if (width && height) box = ViewBox{{0, 0}, {*width, *height}};
    }
    if (box) sheet.extent = unit.metres.cwiseProduct(box->size);
    const Vector2d low = box ? box->low : Vector2d(0, 0);
    sheet.size = box ? box->size : Vector2d(100, 100);
    const double bottom = box ? low.y() + box->size.y() : 0;
    sheet.userToMap.setIdentity();
    sheet.userToMap.translate(sheet.lowerLeft)
        .scale(Vector2d(unit.metres.x(), -unit.metres.y()))
        .translate(Vector2d(-low.x(), -bottom));
    if (!box) sheet.note += "; without viewBox and height, y counts from its upper edge";
    return sheet;
}

}  // namespace offmap::maps::svg
