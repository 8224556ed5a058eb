// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureClass.h"

#include "PrintableName.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace offmap::maps {

namespace {

std::string field(const OGRFeature& feature, const char* name) {
    const int index = feature.GetFieldIndex(name);
    return index < 0 ? "" : feature.GetFieldAsString(index);
}

/// GDAL gives what is not shown a colour without opacity: "PEN(c:#00000000)".
bool isTransparent(std::string_view style) {
    constexpr std::string_view colour = "c:#";
    constexpr size_t digits = 8;
    const size_t begin = style.find(colour);
    if (begin == std::string_view::npos) return false;
    const std::string_view value = style.substr(begin + colour.size(), digits);
    return value.size() == digits && value.ends_with("00") &&
           value.find_first_of(",)") == std::string_view::npos;
}

/// A tag that GDAL gives a field of its own, or one in "other_tags":
/// "height"=>"3","indoor"=>"wall".
std::string tag(const OGRFeature& feature, const std::string& key) {
    std::string own = field(feature, key.c_str());
    if (!own.empty()) return own;
    const std::string others = field(feature, "other_tags"), entry = "\"" + key + "\"=>\"";
    const size_t found = others.find(entry);
    if (found == std::string::npos) return "";
    const size_t begin = found + entry.size();
    return others.substr(begin, others.find('"', begin) - begin);
}

/// Which of its ways stand as high as a scanner looks; doc/formats.md has them too.
FeatureClass classifyStreetMap(const OGRFeature& feature) {
    constexpr std::array<std::string_view, 7> barriers{
        "wall", "city_wall", "retaining_wall", "fence", "hedge", "jersey_barrier", "guard_rail"};
    constexpr std::array<std::string_view, 3> open{"no", "roof", "carport"};
    const std::string building = tag(feature, "building"), barrier = tag(feature, "barrier"),
                      indoor = tag(feature, "indoor");
    if (indoor == "wall" || indoor == "room") return {"indoor-" + indoor};
    if (std::ranges::find(barriers, barrier) != barriers.end()) return {"barrier-" + barrier};
    if (!building.empty() && std::ranges::find(open, building) == open.end()) return {"building"};
    return {"others", "features that are neither building, barrier nor indoor wall"};
}

}  // namespace

FeatureClass classify(OGRFeature& feature, OGRLayer& layer, VectorKind kind) {
    if (kind == VectorKind::StreetMap) return classifyStreetMap(feature);
    const int own = feature.GetFieldIndex("Layer");
    const bool hasOwn = own >= 0 && feature.IsFieldSetAndNotNull(own);
    FeatureClass found{printableName(hasOwn ? feature.GetFieldAsString(own) : layer.GetName())};
    if (kind != VectorKind::Cad) return found;
    const int paper = feature.GetFieldIndex("PaperSpace");
    if (paper >= 0 && feature.GetFieldAsInteger(paper) == 1) {
        found.leftOut = "entities of the paper space";
    }
    const char* style = feature.GetStyleString();
    found.isHidden = style != nullptr && isTransparent(style);
    return found;
}

}  // namespace offmap::maps
