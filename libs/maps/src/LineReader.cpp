// SPDX-License-Identifier: BSD-3-Clause
#include "LineReader.h"

#include "CommonSystem.h"
#include "FeatureClass.h"
#include "LineGatherer.h"

#include <offmap/maps/LayerChoice.h>

#include <fmt/format.h>

#include <algorithm>
#include <ogrsf_frmts.h>
#include <stdexcept>
#include <system_error>

namespace offmap::maps {

namespace {

namespace fs = std::filesystem;

/// What GDAL would not tell, or would tell of another file.
void requireFile(const fs::path& file, const VectorFormat& format) {
    std::error_code error;
    const auto status = fs::status(file, error);
    if (!fs::exists(status)) {
        throw std::runtime_error("cannot read the map: No such file or directory");
    }
    if (fs::is_directory(status)) {
        throw std::runtime_error(fmt::format("is a folder; name a {} file", format.name));
    }
    if (fs::file_size(file, error) == 0 && !error) throw std::runtime_error("is empty");
    if (format.name != "Shapefile") return;
    for (const char* extension : {".shx", ".SHX"}) {
        if (fs::exists(fs::path(file).replace_extension(extension), error)) return;
    }
    throw std::runtime_error(
        fmt::format("its companion {} is missing; copy .shp, .shx, .dbf and .prj together",
                    fs::path(file).replace_extension(".shx").filename().string()));
}

std::vector<const char*> openOptions(const fs::path& file, const VectorFormat& format) {
    std::vector<const char*> options = format.options;
    // a data base that nobody writes to is read without making files beside it
    if (format.name == "GeoPackage" && !fs::exists(file.string() + "-wal")) {
        options.push_back("IMMUTABLE=YES");
    }
    options.push_back(nullptr);
    return options;
}

GDALDatasetUniquePtr open(const fs::path& file, const VectorFormat& format,
                          const GdalSession& session) {
    format.enroll();
    const char* const drivers[] = {format.driver, nullptr};
    const auto options = openOptions(file, format);
    GDALDatasetUniquePtr opened(GDALDataset::Open(fs::absolute(file).c_str(),
                                                  GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers,
                                                  options.data(), nullptr));
    if (opened) return opened;
    throw std::runtime_error(fmt::format("is not a {} file that GDAL can read: {}", format.name,
                                         session.lastMessage("it does not say why")));
}

bool isAskedFor(const std::string& layer, const MapOptions& options) {
    return std::ranges::any_of(options.layers,
                               [&](const auto& name) { return fitsPattern(layer, name); });
}

void addFeature(OGRFeature& feature, OGRLayer& layer, VectorKind kind, const MapOptions& options,
                LineGatherer& gatherer, DrawnLines& drawn) {
    const FeatureClass found = classify(feature, layer, kind);
    const uint32_t index = gatherer.layerIndex(found.layer);
    if (found.leftOut != nullptr) {
        ++drawn.leftOut[found.leftOut];
    } else if (found.isHidden && !isAskedFor(found.layer, options)) {
        ++drawn.leftOut["entities that are hidden, or whose layer is off or frozen"];
    } else {
        gatherer.add(feature, index);
    }
}

DrawnLines linesOf(GDALDataset& opened, VectorKind kind, const MapOptions& options) {
    DrawnLines drawn;
    LineGatherer gatherer(drawn);
    CommonSystem common(drawn);
    while (true) {
        CPLErrorReset();
        OGRLayer* layer = nullptr;
        const OGRFeatureUniquePtr feature(opened.GetNextFeature(&layer, nullptr, nullptr, nullptr));
        if (!feature) break;
        const size_t before = drawn.points.size();
        addFeature(*feature, *layer, kind, options, gatherer, drawn);
        common.take(*layer, before);
    }
    if (CPLGetLastErrorType() >= CE_Failure) {
        throw std::runtime_error(
            fmt::format("is broken or incomplete behind its first {} lines: {}; export it anew",
                        drawn.lines.size(), CPLGetLastErrorMsg()));
    }
    return drawn;
}

}  // namespace

DrawnLines readLines(const fs::path& file, const VectorFormat& format, const MapOptions& options,
                     const GdalSession& session) {
    requireFile(file, format);
    const auto opened = open(file, format, session);
    DrawnLines drawn = linesOf(*opened, format.kind, options);
    constexpr size_t most = 5;
    const auto& messages = session.messages();
    for (size_t i = 0; i < std::min(most, messages.size()); ++i) {
        drawn.warnings.push_back("GDAL, which reads the drawing, says: " + messages[i]);
    }
    return drawn;
}

}  // namespace offmap::maps
