// SPDX-License-Identifier: BSD-3-Clause
#include "SvgValues.h"

#include <charconv>
#include <svgpp/parser/length.hpp>
#include <svgpp/parser/path_data.hpp>
#include <svgpp/parser/transform_list.hpp>
#include <svgpp/policy/error.hpp>

namespace offmap::maps::svg {

namespace {

using Eigen::Vector2d;
namespace attribute = svgpp::tag::attribute;
namespace type = svgpp::tag::type;
using Absolute = svgpp::tag::coordinate::absolute;

// The names of what svgpp calls are svgpp's.
// NOLINTBEGIN(readability-identifier-naming)

/// Hands on what svgpp finds in path data, quadratic curves as cubic ones.
struct PathEvents {
    PathFollower& follower;
    Vector2d start{0, 0}, here{0, 0};

    void path_move_to(double x, double y, Absolute) {
        start = here = {x, y};
        follower.moveTo(here);
    }
    void path_line_to(double x, double y, Absolute) {
        here = {x, y};
        follower.lineTo(here);
    }
    void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y,
                              Absolute) {
        here = {x, y};
        follower.curveTo({x1, y1}, {x2, y2}, here);
    }
    void path_quadratic_bezier_to(double x1, double y1, double x, double y, Absolute) {
        const Vector2d control(x1, y1), end(x, y);
        follower.curveTo(here + 2.0 / 3.0 * (control - here), end + 2.0 / 3.0 * (control - end),
                         end);
        here = end;
    }
    void path_elliptical_arc_to(double rx, double ry, double rotation, bool isLarge, bool isSweep,
                                double x, double y, Absolute) {
        here = {x, y};
        follower.arcTo({{rx, ry}, rotation, isLarge, isSweep, here});
    }
    void path_close_subpath() {
        here = start;
        follower.close();
    }
    void path_exit() {}
};

struct TransformEvents {
    Eigen::Affine2d transform = Eigen::Affine2d::Identity();

    void transform_matrix(const boost::array<double, 6>& m) {
        transform.matrix() << m[0], m[2], m[4], m[1], m[3], m[5], 0, 0, 1;
    }
};

struct LengthEvents {
    std::optional<double> value{};

    void set(attribute::width, double length) { value = length; }
};

// NOLINTEND(readability-identifier-naming)

template <class Type, class Attribute, class Events>
bool parses(std::string_view text, Events& events) {
    try {
        return svgpp::value_parser<Type>::parse(Attribute(), events, text,
                                                svgpp::tag::source::attribute());
    } catch (const svgpp::exception_base&) {
        return false;
    }
}

constexpr std::string_view blanks = " \t\r\n,";

}  // namespace

bool followPath(std::string_view text, PathFollower& follower) {
    PathEvents events{follower};
    return parses<type::path_data, attribute::d>(text, events);
}

std::optional<Eigen::Affine2d> transformOf(std::string_view text) {
    TransformEvents events;
    if (!parses<type::transform_list, attribute::transform>(text, events)) return std::nullopt;
    return events.transform;
}

std::optional<double> lengthOf(std::string_view text, double whole) {
    if (text.ends_with('%')) {
        const auto percents = numbersOf(text.substr(0, text.size() - 1));
        if (!percents || percents->size() != 1) return std::nullopt;
        return whole * percents->front() / 100;
    }
    LengthEvents events;
    if (!parses<type::length, attribute::width>(text, events)) return std::nullopt;
    return events.value;
}

std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::vector<double> numbers;
    for (size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = text.find_first_not_of(blanks, begin)) {
        if (text[begin] == '+') ++begin;  // which std::from_chars does not know
        double& number = numbers.emplace_back();
        const char* const end = text.data() + text.size();
        const auto [past, error] = std::from_chars(text.data() + begin, end, number);
        if (error != std::errc{}) return std::nullopt;
        if (past != end && blanks.find(*past) == std::string_view::npos) return std::nullopt;
        begin = static_cast<size_t>(past - text.data());
    }
    return numbers;
}

}  // namespace offmap::maps::svg
