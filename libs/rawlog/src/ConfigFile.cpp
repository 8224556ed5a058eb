// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/LayerSettings.h>
#include <offmap/rawlog/ParameterTable.h>
#include <offmap/rawlog/SensorSettings.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <yaml-cpp/yaml.h>

// The parser is yaml-cpp: mrpt::containers::yaml reports only some syntax errors, and otherwise
// returns what stood before them; of a repeated key it silently takes the last.

namespace offmap::rawlog {

namespace {

/// Something wrong at a place of the file.
[[noreturn]] void refuse(const YAML::Mark& mark, const std::string& what) {
    throw YAML::Exception(mark, what);
}

YAML::Node parseOneMap(std::istream& file) {
    const std::vector<YAML::Node> documents = YAML::LoadAll(file);
    if (documents.empty() || documents.front().IsNull()) {
        throw std::invalid_argument("holds no settings; an intended lack of them is written {}");
    }
    if (documents.size() > 1) {
        refuse(documents[1].Mark(), "a second document; settings stand in one");
    }
    if (!documents.front().IsMap()) {
        refuse(documents.front().Mark(),
               "settings stand in sections, as in  vertical: {max_tilt_deg: 5}");
    }
    return documents.front();
}

/// \throw YAML::Exception if the key is no plain text or stands in the map before.
std::string keyText(const YAML::Node& key, std::vector<std::string>& seen) {
    if (!key.IsScalar()) refuse(key.Mark(), "a key must be plain text");
    if (std::ranges::find(seen, key.Scalar()) != seen.end()) {
        refuse(key.Mark(), fmt::format("\"{}\" stands here a second time", key.Scalar()));
    }
    return seen.emplace_back(key.Scalar());
}

/// "[-15, 1]" of a sequence of scalars. An entry with a comma would become two.
std::optional<std::string> listText(const YAML::Node& sequence) {
    std::vector<std::string> entries;
    for (const YAML::Node& entry : sequence) {
        if (!entry.IsScalar() || entry.Scalar().find(',') != std::string::npos) return std::nullopt;
        entries.push_back(entry.Scalar());
    }
    return fmt::format("[{}]", fmt::join(entries, ", "));
}

/// A value as --set would write it. \throw YAML::Exception if the parameter has none such
std::string valueText(const Parameter& parameter, const YAML::Node& key, const YAML::Node& value) {
    if (value.IsScalar()) return value.Scalar();
    const bool list = parameter.kind == ParameterKind::List;
    if (list && value.IsSequence()) {
        if (auto text = listText(value)) return *text;
    }
    refuse(value.IsNull() ? key.Mark() : value.Mark(),
           fmt::format("{} needs {}: allowed is {}", parameter.key,
                       list ? "a list of numbers" : "one value", parameter.allowed()));
}

/// What a map of settings is for.
struct Section {
    std::string name;                    ///< "vertical", "sensors.LABEL", "layers.PATTERN"
    std::optional<std::string> label{};  ///< of the single sensor that it sets
    std::optional<std::string> layer{};  ///< pattern of the layers that it sets
};

std::string layerText(const std::string& name, const YAML::Node& key, const YAML::Node& value) {
    if (value.IsScalar()) return value.Scalar();
    refuse(value.IsNull() ? key.Mark() : value.Mark(), fmt::format("{} needs one value", name));
}

/// \return the full key
std::string applyEntry(Config& config, const Section& section, const YAML::Node& key,
                       const YAML::Node& value) {
    const std::string& name = key.Scalar();
    std::string fullKey = section.name + '.' + name;
    try {
        if (section.label) {
            const std::string text = valueText(findSensorParameter(name), key, value);
            setForSensor(config, {*section.label, name}, text);
        } else if (section.layer) {
            setForLayer(config, {*section.layer, name}, layerText(name, key, value));
        } else {
            const Parameter& parameter = findParameter(fullKey);
            parameter.setText(config, valueText(parameter, key, value));
        }
        return fullKey;
    } catch (const std::invalid_argument& e) {
        refuse(key.Mark(), e.what());
    }
}

/// A section without entries is fine: all of them may have been commented out.
void applyEntries(Config& config, const Section& section, const YAML::Node& entries,
                  std::vector<std::string>& keysSet) {
    if (entries.IsNull()) return;
    if (!entries.IsMap()) {
        refuse(entries.Mark(),
               fmt::format("\"{}\" is a section and holds  key: value  pairs", section.name));
    }
    std::vector<std::string> seen;
    for (const auto& entry : entries) {
        keyText(entry.first, seen);
        keysSet.push_back(applyEntry(config, section, entry.first, entry.second));
    }
}

void requireMapOrNothing(const YAML::Node& node) {
    if (node.IsMap() || node.IsNull()) return;
    refuse(node.Mark(),
           "settings of single sensors stand under their labels, as in  sensors: {FRONT_LIDAR: "
           "{min_range_m: 0.5}}");
}

/// The section "sensors": a section for each label.
void applySensors(Config& config, const YAML::Node& sensors, std::vector<std::string>& keysSet) {
    requireMapOrNothing(sensors);
    std::vector<std::string> seen;
    for (const auto& sensor : sensors) {
        requireMapOrNothing(sensor.second);
        const std::string label = keyText(sensor.first, seen);
        applyEntries(config, {.name = "sensors." + label, .label = label}, sensor.second, keysSet);
    }
}

/// The section "layers": a section for each pattern, of which the first that fits counts.
void applyLayers(Config& config, const YAML::Node& layers, std::vector<std::string>& keysSet) {
    const auto require = [](const YAML::Node& node) {
        if (node.IsMap() || node.IsNull()) return;
        refuse(
            node.Mark(),
            "what holds for layers of the map stands under their names, as in  layers: {COUNTER: "
            "{z_max_m: 1}}");
    };
    require(layers);
    std::vector<std::string> seen;
    for (const auto& layer : layers) {
        require(layer.second);
        const std::string pattern = keyText(layer.first, seen);
        applyEntries(config, {.name = "layers." + pattern, .layer = pattern}, layer.second,
                     keysSet);
    }
}

void requireSection(const YAML::Node& key, const std::string& name) {
    const auto table = parameters();
    const bool known = std::ranges::any_of(
        table, [&](const Parameter& p) { return p.key.starts_with(name + '.'); });
    if (known) return;
    try {
        findParameter(name);
    } catch (const std::invalid_argument& e) {
        refuse(key.Mark(), e.what());
    }
    refuse(key.Mark(), fmt::format("\"{}\" must stand inside its section, as in  vertical: "
                                   "{{max_tilt_deg: 5}}",
                                   name));
}

std::vector<std::string> applyDocument(Config& config, const YAML::Node& document) {
    std::vector<std::string> keysSet;
    std::vector<std::string> seen;
    for (const auto& entry : document) {
        const std::string name = keyText(entry.first, seen);
        if (name == "sensors") {
            applySensors(config, entry.second, keysSet);
            continue;
        }
        if (name == "layers") {
            applyLayers(config, entry.second, keysSet);
            continue;
        }
        if (!entry.second.IsMap() || entry.second.size() == 0) requireSection(entry.first, name);
        applyEntries(config, {.name = name}, entry.second, keysSet);
    }
    return keysSet;
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::vector<std::string> applyYaml(Config& config, const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file)) {
        throw std::runtime_error(
            fmt::format("{}: cannot be read; is it there and a file?", file.string()));
    }
    try {
        Config changed = config;
        auto keysSet = applyDocument(changed, parseOneMap(stream));
        changed.validate();
        config = changed;
        return keysSet;
    } catch (const YAML::ParserException& e) {
        throw std::runtime_error(
            fmt::format("{}:{}: no valid YAML ({}); mind indentation and brackets", file.string(),
                        e.mark.line + 1, e.msg));
    } catch (const YAML::Exception& e) {
        throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), e.mark.line + 1, e.msg));
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(fmt::format("{}: {}", file.string(), e.what()));
    }
}

void applySetting(Config& config, std::string_view setting) {
    // labels and layers may hold an =
    const bool isNamed = setting.starts_with("sensors.") || setting.starts_with("layers.");
    const size_t equals = isNamed ? setting.rfind('=') : setting.find('=');
    if (equals == std::string_view::npos) {
        throw std::runtime_error(
            fmt::format("setting \"{}\" lacks its value; write key=value", setting));
    }
    const std::string_view key = trimmed(setting.substr(0, equals));
    const std::string_view text = trimmed(setting.substr(equals + 1));
    try {
        Config changed = config;
        if (const auto sensor = sensorKey(key)) {
            setForSensor(changed, *sensor, text);
        } else if (const auto layer = layerKey(key)) {
            setForLayer(changed, *layer, text);
        } else {
            findParameter(key).setText(changed, text);
        }
        changed.validate();
        config = changed;
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(fmt::format("setting \"{}\": {}", setting, e.what()));
    }
}

}  // namespace offmap::rawlog
