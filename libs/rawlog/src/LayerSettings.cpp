// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/EditDistance.h>
#include <offmap/rawlog/LayerSettings.h>
#include <offmap/rawlog/Parameter.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

/// One that a rule may leave open. It stands in the first rule of a configuration.
Parameter optionalLength(std::string_view name, double min, double max,
                         std::optional<double> LayerConfig::*field, std::string_view meaning) {
    return {name,
            "m",
            meaning,
            ParameterKind::Number,
            min,
            max,
            {},
            {},
            [field](const Config& c) {
                const auto& value = c.map.layers.at(0).*field;
                return value ? std::vector{*value} : std::vector<double>{};
            },
            [field](Config& c, const std::vector<double>& values) {
                c.map.layers.at(0).*field = values.at(0);
            }};
}

Parameter presence() {
    return {"present",
            "-",
            "whether the layer's lines are walls",
            ParameterKind::Switch,
            0,
            1,
            {"false", "true"},
            {},
            [](const Config& c) { return std::vector{c.map.layers.at(0).present ? 1.0 : 0.0}; },
            [](Config& c, const std::vector<double>& values) {
                c.map.layers.at(0).present = values.at(0) != 0;
            }};
}

std::span<const Parameter> layerParameters() {
    static const std::array<Parameter, 4> all{
        optionalLength("sigma_m", 0, 10, &LayerConfig::sigma,
                       "standard deviation of a wall's position"),
        optionalLength("z_min_m", -10000, 10000, &LayerConfig::zMin, "where its walls begin"),
        optionalLength("z_max_m", -10000, 10000, &LayerConfig::zMax, "where its walls end"),
        presence()};
    return all;
}

const Parameter& findLayerParameter(std::string_view name) {
    const auto all = layerParameters();
    const auto edits = [&](const Parameter& p) { return editDistance(name, p.key); };
    const Parameter& nearest = *std::ranges::min_element(all, {}, edits);
    if (edits(nearest) == 0) return nearest;
    throw std::invalid_argument(fmt::format("a layer has no key \"{}\"; {}", name,
                                            edits(nearest) <= name.size() / 2
                                                ? fmt::format("did you mean {}?", nearest.key)
                                                : "it has sigma_m, z_min_m, z_max_m and present"));
}

}  // namespace

std::optional<LayerKey> layerKey(std::string_view key) {
    constexpr std::string_view section = "layers.";
    if (!key.starts_with(section)) return std::nullopt;
    const std::string_view own = key.substr(section.size());
    const size_t dot = own.rfind('.');
    if (dot == std::string_view::npos) {
        throw std::invalid_argument(
            fmt::format("\"{}\" names no layer; write layers.LAYER.{}", key, own));
    }
    return LayerKey{std::string(own.substr(0, dot)), std::string(own.substr(dot + 1))};
}

void setForLayer(Config& config, const LayerKey& key, std::string_view text) {
    auto& layers = config.map.layers;
    const auto found = std::ranges::find(layers, key.layer, &LayerConfig::layer);
    Config alone;
    alone.map.layers = {found == layers.end() ? LayerConfig{.layer = key.layer} : *found};
    findLayerParameter(key.name).setText(alone, text);
    if (found == layers.end()) {
        layers.push_back(alone.map.layers[0]);
    } else {
        *found = alone.map.layers[0];
    }
}

std::vector<std::pair<LayerKey, std::string>> layerSettings(const Config& config) {
    std::vector<std::pair<LayerKey, std::string>> settings;
    for (const LayerConfig& layer : config.map.layers) {
        Config alone;
        alone.map.layers = {layer};
        for (const Parameter& p : layerParameters()) {
            const bool isSet = !p.read(alone).empty() && (p.key != "present" || !layer.present);
            if (isSet) settings.push_back({{layer.layer, std::string(p.key)}, p.text(alone)});
        }
    }
    return settings;
}

void validateLayers(const Config& config) {
    for (const LayerConfig& layer : config.map.layers) {
        if (layer.zMin && layer.zMax && *layer.zMin > *layer.zMax) {
            throw std::invalid_argument(fmt::format("layers.{}: z_min_m {} is above z_max_m {}",
                                                    layer.layer, *layer.zMin, *layer.zMax));
        }
    }
}

}  // namespace offmap::rawlog
