// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace offmap::rawlog {

/// Key of what holds for layers of a map: "layers.PATTERN.NAME". The pattern may hold dots.
struct LayerKey {
    std::string layer;
    std::string name;  ///< sigma_m, z_min_m, z_max_m or present
};

/// None if the key is not one of a layer. \throw std::invalid_argument if it does not name one
std::optional<LayerKey> layerKey(std::string_view key);

/// Changes the rule of that pattern, or adds one behind the others.
/// \throw std::invalid_argument for an unknown name or a value that is not allowed. The
/// configuration is then unchanged.
void setForLayer(Config& config, const LayerKey& key, std::string_view text);

/// Keys and texts of all that is set for layers, as setForLayer() takes them.
std::vector<std::pair<LayerKey, std::string>> layerSettings(const Config& config);

/// \throw std::invalid_argument naming a layer whose heights contradict each other
void validateLayers(const Config& config);

}  // namespace offmap::rawlog
