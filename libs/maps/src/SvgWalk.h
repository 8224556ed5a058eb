// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SvgStyle.h"
#include "SvgViewport.h"

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <Eigen/Geometry>

#include <pugixml.hpp>
#include <string>
#include <unordered_map>

namespace offmap::maps::svg {

/// Goes through the tree of a drawing and collects what it shows.
class Walk {
 public:
    /// \param drawing gets walls, layers, notes and warnings
    Walk(const pugi::xml_node& root, const MapOptions& options, Drawing& drawing);

    /// \throw std::runtime_error telling what is wrong with the element last()
    void run();

    /// The element that it came to last.
    const pugi::xml_node& last() const { return last_; }

 private:
    /// What an element has from those around it.
    struct State {
        Eigen::Affine2d userToMap;
        Eigen::Vector2d viewport;  ///< [user units] size
        Style style;
        std::string layer;  ///< name; empty: none yet
        bool isInkscapeLayer = false;
        core::Wall like;  ///< sigma and height
        size_t depth = 0;
    };

    void indexTree(const pugi::xml_node& root);
    void visit(const pugi::xml_node& element, const State& outer);
    State entered(const pugi::xml_node& element, std::string_view name, const State& outer) const;
    void visitChildren(const pugi::xml_node& element, const State& state);
    void visitUse(const pugi::xml_node& use, const State& outer);
    void draw(const pugi::xml_node& element, std::string_view name, const State& state);
    bool isBackground(size_t firstWall, const Style& style) const;
    uint32_t layerIndex(const std::string& name);
    void addNotes();

    pugi::xml_node root_, last_;
    const MapOptions& options_;
    Drawing& drawing_;
    Sheet sheet_;
    StyleSheet styles_;
    std::unordered_map<std::string, pugi::xml_node> byId_;
    std::unordered_map<std::string, uint32_t> layers_;
    std::unordered_map<std::string, size_t> leftOut_;  ///< elements, by name
    size_t visited_ = 0, hidden_ = 0, backgrounds_ = 0, glyphs_ = 0, deadUses_ = 0, clipped_ = 0;
};

}  // namespace offmap::maps::svg
