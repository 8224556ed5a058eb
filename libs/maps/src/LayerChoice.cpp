// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/LayerChoice.h>
#include <offmap/maps/LowerCase.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace offmap::maps {

namespace {

bool fitsAny(std::string_view name, const std::vector<std::string>& patterns) {
    return std::ranges::any_of(patterns,
                               [&](const auto& pattern) { return fitsPattern(name, pattern); });
}

std::string listed(const std::vector<std::string>& layers) {
    constexpr size_t most = 12;
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min(most, layers.size()); ++i) {
        names.push_back(layers[i].empty() ? "(no name)" : layers[i]);
    }
    return fmt::format("{}{}", fmt::join(names, ", "), layers.size() > most ? ", ..." : "");
}

void requireFits(const Drawing& drawing, const std::vector<std::string>& patterns,
                 std::string_view option, const std::string& name) {
    for (const std::string& pattern : patterns) {
        const auto fits = [&](const auto& layer) { return fitsPattern(layer, pattern); };
        if (std::ranges::any_of(drawing.layers, fits)) continue;
        throw std::runtime_error(fmt::format("{}: no layer '{}', which {} names; there are: {}",
                                             name, pattern, option, listed(drawing.layers)));
    }
}

}  // namespace

bool fitsPattern(std::string_view name, std::string_view pattern) {
    size_t n = 0, p = 0, star = std::string_view::npos, starAt = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            starAt = n;
        } else if (p < pattern.size() &&
                   (pattern[p] == '?' || lowerCase(pattern[p]) == lowerCase(name[n]))) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;  // the star takes one more
            n = ++starAt;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<bool> chooseLayers(const Drawing& drawing, const MapOptions& options,
                               const std::string& name) {
    requireFits(drawing, options.layers, "--map-layer", name);
    requireFits(drawing, options.excludedLayers, "--map-exclude-layer", name);
    std::vector<bool> chosen;
    for (const std::string& layer : drawing.layers) {
        const LayerRule* rule = ruleOf(layer, options.rules);
        const bool present = rule == nullptr || rule->present;
        const bool named = options.layers.empty() || fitsAny(layer, options.layers);
        chosen.push_back(present && named && !fitsAny(layer, options.excludedLayers));
    }
    if (std::ranges::find(chosen, true) == chosen.end()) {
        throw std::runtime_error(
            fmt::format("{}: all of its layers are left out: {}", name, listed(drawing.layers)));
    }
    return chosen;
}

std::vector<std::string> warningsOfRules(const Drawing& drawing,
                                         const std::vector<LayerRule>& rules) {
    std::vector<std::string> warnings;
    for (const LayerRule& rule : rules) {
        const auto fits = [&](const auto& layer) { return fitsPattern(layer, rule.layer); };
        if (std::ranges::any_of(drawing.layers, fits)) continue;
        warnings.push_back(
            fmt::format("the configuration's layers.{} fits no layer of the map; there are: {}",
                        rule.layer, listed(drawing.layers)));
    }
    return warnings;
}

const LayerRule* ruleOf(std::string_view layer, const std::vector<LayerRule>& rules) {
    const auto fits = [&](const LayerRule& rule) { return fitsPattern(layer, rule.layer); };
    const auto found = std::ranges::find_if(rules, fits);
    return found == rules.end() ? nullptr : &*found;
}

}  // namespace offmap::maps
