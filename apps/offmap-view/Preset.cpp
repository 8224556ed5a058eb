// SPDX-License-Identifier: BSD-3-Clause
#include "Preset.h"

#include "ParameterFacts.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/OutputFile.h>
#include <offmap/rawlog/ParameterTable.h>

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace offmap::window {

namespace {

/// "[1, 2]" of a List is written as a sequence, all else as it is.
void emitValue(YAML::Emitter& out, const std::string& text) {
    out << YAML::Value;
    if (text.starts_with('[')) {
        out << YAML::Load(text);
    } else {
        out << text;
    }
}

void emitEntry(YAML::Emitter& out, std::string_view name, const std::string& text) {
    out << YAML::Key << std::string(name);
    emitValue(out, text);
}

void emitParameters(YAML::Emitter& out, const rawlog::Config& config) {
    std::vector<std::pair<std::string_view, std::vector<const rawlog::Parameter*>>> sections;
    for (const rawlog::Parameter& p : rawlog::parameters()) {
        if (isDefault(p, config)) continue;
        if (sections.empty() || sections.back().first != sectionOf(p)) {
            sections.push_back({sectionOf(p), {}});
        }
        sections.back().second.push_back(&p);
    }
    for (const auto& [name, parameters] : sections) {
        out << YAML::Key << std::string(name) << YAML::Value << YAML::BeginMap;
        for (const auto* p : parameters) {
            emitEntry(out, p->key.substr(name.size() + 1), p->text(config));
        }
        out << YAML::EndMap;
    }
}

void emitSensors(YAML::Emitter& out, const rawlog::Config& config) {
    if (config.sensors.empty()) return;
    out << YAML::Key << "sensors" << YAML::Value << YAML::BeginMap;
    for (const auto& [label, settings] : config.sensors) {
        out << YAML::Key << YAML::DoubleQuoted << label << YAML::Value << YAML::BeginMap;
        for (const auto& [name, text] : settings) emitEntry(out, name, text);
        out << YAML::EndMap;
    }
    out << YAML::EndMap;
}

/// `present` always: a rule that says nothing else still comes before those behind it.
void emitLayers(YAML::Emitter& out, const rawlog::Config& config) {
    if (config.map.layers.empty()) return;
    out << YAML::Key << "layers" << YAML::Value << YAML::BeginMap;
    for (const rawlog::LayerConfig& layer : config.map.layers) {
        out << YAML::Key << YAML::DoubleQuoted << layer.layer << YAML::Value << YAML::BeginMap;
        if (layer.sigma) emitEntry(out, "sigma_m", fmt::format("{}", *layer.sigma));
        if (layer.zMin) emitEntry(out, "z_min_m", fmt::format("{}", *layer.zMin));
        if (layer.zMax) emitEntry(out, "z_max_m", fmt::format("{}", *layer.zMax));
        emitEntry(out, "present", layer.present ? "true" : "false");
        out << YAML::EndMap;
    }
    out << YAML::EndMap;
}

}  // namespace

std::string presetOf(const rawlog::Config& config) {
    YAML::Emitter out;
    out.SetSeqFormat(YAML::Flow);
    out << YAML::BeginMap;
    emitParameters(out, config);
    emitSensors(out, config);
    emitLayers(out, config);
    out << YAML::EndMap;
    return fmt::format("# What differs from the default.\n{}\n", out.c_str());
}

void savePreset(const std::filesystem::path& file, const rawlog::Config& config) {
    rawlog::OutputFile out(file, {.overwrite = true});
    out.write(std::string_view(presetOf(config)));
    out.publish();
}

rawlog::Config loadPreset(const std::filesystem::path& file, const rawlog::Config& config) {
    rawlog::Config preset;
    preset.mountings = config.mountings;
    rawlog::applyYaml(preset, file);
    return preset;
}

}  // namespace offmap::window
