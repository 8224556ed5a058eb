// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// Whether a layer's name fits a pattern, in which * stands for any text and ? for any byte;
/// ASCII letters fit in either case.
bool fitsPattern(std::string_view name, std::string_view pattern);

/// Of each layer of the drawing, whether its lines are walls. \param name stands for the file
/// \throw std::runtime_error naming the layers there are, if none fits a pattern of
/// MapOptions::layers or excludedLayers, or if none is left
std::vector<bool> chooseLayers(const Drawing& drawing, const MapOptions& options,
                               const std::string& name);

/// What there is to warn of: rules that fit no layer.
std::vector<std::string> warningsOfRules(const Drawing& drawing,
                                         const std::vector<LayerRule>& rules);

/// The first rule that fits; null without one.
const LayerRule* ruleOf(std::string_view layer, const std::vector<LayerRule>& rules);

}  // namespace offmap::maps
