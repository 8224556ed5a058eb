// SPDX-License-Identifier: BSD-3-Clause
#include "SvgWalk.h"

#include "SvgAttributes.h"
#include "SvgPen.h"
#include "SvgShapes.h"
#include "SvgValues.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace offmap::maps::svg {

using Eigen::Vector2d;

namespace {

constexpr size_t deepest = 200;            // elements inside each other
constexpr size_t mostVisited = 5'000'000;  // also elements that are used many times

/// Elements that no line is taken from, although they show something.
constexpr std::array<std::string_view, 7> notRead{"text", "image",   "foreignObject", "clipPath",
                                                  "mask", "pattern", "marker"};

/// "svg:path" is a path.
std::string_view localName(const pugi::xml_node& element) {
    const std::string_view name = element.name();
    return name.substr(name.find(':') + 1);
}

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

std::optional<double> ownNumber(const pugi::xml_node& element, const char* attribute) {
    const char* const text = element.attribute(attribute).value();
    if (*text == '\0') return std::nullopt;
    const auto numbers = numbersOf(text);
    if (!numbers || numbers->size() != 1 || !std::isfinite(numbers->front()))
        throw std::runtime_error(fmt::format("{} is '{:.40}', not a number", attribute, text));
    return numbers->front();
}

/// Sigma and height that an element states itself.
core::Wall wallOf(const pugi::xml_node& element, core::Wall like) {
    like.sigma = ownNumber(element, sigma).value_or(like.sigma);
    const double low = ownNumber(element, zMin).value_or(like.height.min());
    const double high = ownNumber(element, zMax).value_or(like.height.max());
    if (like.sigma < 0) throw std::runtime_error(fmt::format("{} is below 0", sigma));
    if (low > high)
        throw std::runtime_error(fmt::format("{} {} is above {} {}", zMin, low, zMax, high));
    like.height = {low, high};
    return like;
}

/// The layer that a group is or lies in.
void nameLayer(const pugi::xml_node& group, std::string& layer, bool& isInkscapeLayer) {
    const std::string_view id = group.attribute("id").value();
    if (std::string_view(group.attribute(groupMode).value()) == "layer") {
        const auto label = group.attribute(svg::label);
        const std::string own(label ? std::string_view(label.value()) : id);
        layer = isInkscapeLayer ? layer + '/' + own : own;
        isInkscapeLayer = true;
    } else if (layer.empty()) {
        layer = id;
    }
}

}  // namespace

Walk::Walk(const pugi::xml_node& root, const MapOptions& options, Drawing& drawing)
    : root_(root), last_(root), options_(options), drawing_(drawing) {}

void Walk::run() {
    indexTree(root_);
    sheet_ = sheetOf(root_, options_);
    drawing_.notes.push_back(sheet_.note);
    State state{sheet_.userToMap, sheet_.size, Style{}.of(root_, styles_), "", false, {}, 0};
    state.like.sigma = options_.sigma;
    visitChildren(root_, state);
    addNotes();
}

void Walk::indexTree(const pugi::xml_node& root) {
    struct Walker : pugi::xml_tree_walker {
        explicit Walker(Walk& owner) : walk(owner) {}
        Walk& walk;
        bool for_each(pugi::xml_node& node) override {
            const std::string_view name = localName(node);
            if (const auto id = node.attribute("id")) walk.byId_.try_emplace(id.value(), node);
            if (name == "style") walk.styles_.add(node.text().get());
            if (std::ranges::find(notRead, name) != notRead.end())
                ++walk.leftOut_[std::string(name)];
            return true;
        }
    } walker(*this);
    pugi::xml_node(root).traverse(walker);
}

void Walk::visitChildren(const pugi::xml_node& element, const State& state) {
    for (const pugi::xml_node& child : element.children()) {
        if (child.type() == pugi::node_element) visit(child, state);
    }
}

Walk::State Walk::entered(const pugi::xml_node& element, std::string_view name,
                          const State& outer) const {
    State state = outer;
    if (++state.depth > deepest)
        throw std::runtime_error(fmt::format("more than {} elements inside each other", deepest));
    state.style = outer.style.of(element, styles_);
    if (!state.style.isDisplayed) return state;
    state.like = wallOf(element, outer.like);
    if (const auto text = element.attribute("transform")) {
        const auto own = transformOf(text.value());
        if (!own) {
            throw std::runtime_error(
                fmt::format("transform is '{:.60}', no list of transforms", text.value()));
        }
        state.userToMap = outer.userToMap * *own;
    }
    if (name == "g") nameLayer(element, state.layer, state.isInkscapeLayer);
    if (name == "svg") {
        const Viewport inner = innerViewport(element, element, state.viewport);
        state.userToMap = state.userToMap * inner.toOuter;
        state.viewport = inner.size;
    }
    return state;
}

void Walk::visit(const pugi::xml_node& element, const State& outer) {
    const std::string_view name = localName(element);
    const bool isGroup = isOneOf(name, {"g", "a", "svg", "switch"});
    if (!isGroup && name != "use" && !isShape(name)) return;
    last_ = element;
    if (++visited_ > mostVisited)
        throw std::runtime_error("far too many elements are shown; uses that use uses?");
    const State state = entered(element, name, outer);
    if (!state.style.isDisplayed) {
        ++hidden_;
        return;
    }
    clipped_ += !element.attribute("clip-path").empty();
    if (isGroup) return visitChildren(element, state);
    if (name == "use") return visitUse(element, state);
    draw(element, name, state);
}

void Walk::visitUse(const pugi::xml_node& use, const State& outer) {
    std::string_view link = use.attribute("href").value();
    if (link.empty()) link = use.attribute("xlink:href").value();
    const auto target =
        link.starts_with('#') ? byId_.find(std::string(link.substr(1))) : byId_.end();
    if (target == byId_.end()) {
        ++deadUses_;
        return;
    }
    // cairo, and what is built on it, draws the letters of a text so
    if (link.starts_with("#glyph")) {
        ++glyphs_;
        return;
    }
    State state = outer;
    if (localName(target->second) != "symbol") {
        state.userToMap.translate(Vector2d(lengthIn(use, "x", state.viewport.x(), 0),
                                           lengthIn(use, "y", state.viewport.y(), 0)));
        return visit(target->second, state);
    }
    const Viewport inner = innerViewport(target->second, use, state.viewport);
    state.userToMap = state.userToMap * inner.toOuter;
    state.viewport = inner.size;
    last_ = target->second;
    state = entered(target->second, "symbol", state);
    if (state.style.isDisplayed) visitChildren(target->second, state);
}

void Walk::draw(const pugi::xml_node& element, std::string_view name, const State& state) {
    if (!state.style.isSeen()) {
        ++hidden_;
        return;
    }
    const size_t before = drawing_.walls.size();
    Pen pen(state.userToMap, options_.scale, state.like, drawing_.walls);
    drawShape(element, name, state.viewport, pen);
    if (drawing_.walls.size() == before) return;
    if (isBackground(before, state.style)) {
        drawing_.walls.resize(before);
        ++backgrounds_;
        return;
    }
    drawing_.layerOf.resize(drawing_.walls.size(), layerIndex(state.layer));
}

/// Whether the last walls are a filled area without an outline that is the whole sheet.
bool Walk::isBackground(size_t firstWall, const Style& style) const {
    if (style.isStroked || !sheet_.extent || drawing_.walls.size() - firstWall != 4) return false;
    const Vector2d low = sheet_.lowerLeft, high = low + *sheet_.extent;
    const double slack = 0.002 * sheet_.extent->maxCoeff();
    const auto isCorner = [&](const mrpt::math::TPoint2D& p) {
        const auto isOne = [&](double a, double b, double c) {
            return std::min(std::abs(a - b), std::abs(a - c)) <= slack;
        };
        return isOne(p.x, low.x(), high.x()) && isOne(p.y, low.y(), high.y());
    };
    return std::all_of(drawing_.walls.begin() + static_cast<ptrdiff_t>(firstWall),
                       drawing_.walls.end(),
                       [&](const core::Wall& wall) { return isCorner(wall.line.point1); });
}

uint32_t Walk::layerIndex(const std::string& name) {
    const auto [found, isNew] =
        layers_.try_emplace(name, static_cast<uint32_t>(drawing_.layers.size()));
    if (isNew) drawing_.layers.push_back(name);
    return found->second;
}

void Walk::addNotes() {
    std::vector<std::string> parts;
    const auto part = [&](size_t count, std::string_view what) {
        if (count > 0) parts.push_back(fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"));
    };
    for (const std::string_view name : notRead) part(leftOut_[std::string(name)], name);
    part(glyphs_, "letter");
    part(hidden_, "hidden element");
    part(backgrounds_, "background");
    part(deadUses_, "use without its target");
    if (!parts.empty())
        drawing_.notes.push_back(fmt::format("left out: {}", fmt::join(parts, ", ")));
    if (clipped_ > 0) {
        drawing_.notes.push_back(
            fmt::format("{} clipped element{} taken whole", clipped_, clipped_ == 1 ? "" : "s"));
    }
}

}  // namespace offmap::maps::svg
