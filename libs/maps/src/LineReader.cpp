// SPDX-License-Identifier: BSD-3-Clause
#include "LineReader.h"

#include "CommonSystem.h"
#include "FeatureClass.h"
#include "LineGatherer.h"
#include "MemoryFile.h"

#include <offmap/maps/LayerChoice.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
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

/// \param name for GDAL
GDALDatasetUniquePtr open(const std::string& name, const VectorFormat& format,
                          const GdalSession& session) {
    format.enroll();
    const char* const drivers[] = {format.driver, nullptr};
    const auto options = openOptions(name, format);
    GDALDatasetUniquePtr opened(GDALDataset::Open(
        name.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options.data(), nullptr));
    if (opened) return opened;
    const std::string why = session.why("it does not say why");
    if (why.find("not recognized") != std::string::npos) {
        throw std::runtime_error(fmt::format(
            "is no {} by its content; give it the extension of what it is", format.name));
    }
    throw std::runtime_error(
        fmt::format("is broken: GDAL cannot read it as {}: {}", format.name, why));
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

void gather(GDALDataset& opened, VectorKind kind, const MapOptions& options, DrawnLines& drawn) {
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
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(fs::file_size(file), '\0');
    if (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return bytes;
    throw std::runtime_error("cannot read the map: " + std::generic_category().message(errno));
}

/// \param rest of the file's content: what GDAL has not read
void addUnread(const DxfContent& rest, DrawnLines& drawn) {
    std::vector<std::string> unread;
    for (const auto& [type, count] : rest.unread)
        unread.push_back(fmt::format("{} {}", count, type));
    if (unread.empty()) return;
    unread.resize(std::min<size_t>(unread.size(), 8));
    drawn.warnings.push_back(fmt::format(
        "not read: {}; if these are walls, explode them to lines in the program that drew them",
        fmt::join(unread, ", ")));
}

DrawnLines readDxf(const fs::path& file, const VectorFormat& format, const MapOptions& options,
                   const GdalSession& session) {
    std::string bytes = contentOf(file);
    const DxfContent content = siftDxf(bytes);
    const MemoryFile sifted(std::move(bytes), ".dxf");
    DrawnLines drawn;
    drawn.unit = content.unit;
    gather(*open(sifted.name(), format, session), format.kind, options, drawn);
    for (const auto& [kind, count] : content.leftOut) drawn.leftOut[kind] += count;
    for (const std::string& layer : content.layers) {
        if (std::ranges::find(drawn.layers, layer) == drawn.layers.end()) {
            drawn.layers.push_back(layer);
        }
    }
    addUnread(content, drawn);
    return drawn;
}

void addMessages(const GdalSession& session, DrawnLines& drawn) {
    constexpr size_t most = 3;
    const auto& warnings = session.warnings();
    for (size_t i = 0; i < std::min(most, warnings.size()); ++i) {
        drawn.warnings.push_back("GDAL, which reads the drawing, says: " + warnings[i]);
    }
    if (session.failures().empty()) return;
    drawn.warnings.push_back(fmt::format(
        "the drawing is damaged, walls of it may be missing (errors: {}, the first: {}); export it "
        "anew",
        session.failures().size(), session.failures().front()));
}

}  // namespace

DrawnLines readLines(const fs::path& file, const VectorFormat& format, const MapOptions& options,
                     const GdalSession& session) {
    requireFile(file, format);
    DrawnLines drawn;
    if (format.name == "DXF") {
        drawn = readDxf(file, format, options, session);
    } else {
        gather(*open(fs::absolute(file).string(), format, session), format.kind, options, drawn);
    }
    addMessages(session, drawn);
    return drawn;
}

}  // namespace offmap::maps
