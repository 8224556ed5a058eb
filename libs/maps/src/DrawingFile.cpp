// SPDX-License-Identifier: BSD-3-Clause
#include "GdalSession.h"
#include "MemoryFile.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/DrawingFile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <ogrsf_frmts.h>
#include <stdexcept>
#include <utility>
#include <vector>

namespace offmap::maps {

namespace {

using Names = std::span<const std::string>;

/// An arc as pieces that are off it by less than half a millimetre, enough of them to be known for
/// an arc.
OGRLineString lineAlong(const core::Wall& wall) {
    constexpr double offset = 0.0005, mostTurn = 0.2;  // [m], [rad]
    const double turn = core::lengthOf(wall) * std::abs(wall.curvature);
    // a piece that turns by t stands off the arc by r t^2 / 8
    const double step = std::min(mostTurn, std::sqrt(8 * offset * std::abs(wall.curvature)));
    const int pieces = turn > 0 ? std::max(4, static_cast<int>(std::ceil(turn / step))) : 1;
    OGRLineString line;
    line.addPoint(wall.line.point1.x, wall.line.point1.y);
    for (int i = 1; i < pieces; ++i) {
        const auto place = core::placeAt(wall, double(i) / pieces);
        line.addPoint(place.x, place.y);
    }
    line.addPoint(wall.line.point2.x, wall.line.point2.y);
    return line;
}

/// Without the signs that DXF forbids in names; 0 is its layer without a name.
std::string dxfName(const std::string& name) {
    std::string allowed = name.empty() ? "0" : name;
    for (char& c : allowed) {
        const bool isControl = static_cast<unsigned char>(c) < 0x20;
        if (isControl || std::string_view("<>/\\\":;?*|=,`'").find(c) != std::string_view::npos) {
            c = '_';
        }
    }
    return allowed;
}

/// GDAL's own header, which tells inches, with the units put right.
std::string dxfHeader() {
    const char* file = CPLFindFile("gdal", "header.dxf");
    std::ifstream in(file == nullptr ? "" : file, std::ios::binary);
    std::string header{std::istreambuf_iterator<char>(in), {}};
    for (const auto& [variable, value] : {std::pair{"$INSUNITS", "6"}, {"$MEASUREMENT", "1"}}) {
        size_t begin =
            header.find(variable);  // behind it: a line with its code, one with its value
        for (int i = 0; i < 2 && begin != std::string::npos; ++i)
            begin = header.find('\n', begin + 1);
        if (begin == std::string::npos) {
            throw std::runtime_error(
                "GDAL's file header.dxf is missing, or of a version not known; install the files "
                "of libgdal, or set GDAL_DATA to their folder");
        }
        const size_t end = header.find('\n', begin + 1);
        header.replace(begin + 1, end - begin - 1, value);
    }
    return header;
}

void setBounded(OGRFeature& feature, const char* field, double value) {
    if (std::isfinite(value)) feature.SetField(field, value);
}

void requireWritten(bool isWritten, const GdalSession& session) {
    if (isWritten) return;
    throw std::runtime_error("the drawing cannot be written: " +
                             session.why("GDAL does not say why"));
}

void writeWalls(OGRLayer& layer, std::span<const core::Wall> walls, Names layerOfEach,
                const GdalSession& session) {
    for (size_t i = 0; i < walls.size(); ++i) {
        OGRFeature feature(layer.GetLayerDefn());
        feature.SetField("Layer", layerOfEach[i].c_str());
        if (feature.GetFieldIndex("sigma_m") >= 0) {
            feature.SetField("sigma_m", walls[i].sigma);
            setBounded(feature, "z_min_m", walls[i].height.min());
            setBounded(feature, "z_max_m", walls[i].height.max());
        }
        const OGRLineString line = lineAlong(walls[i]);
        feature.SetGeometry(&line);
        requireWritten(layer.CreateFeature(&feature) == OGRERR_NONE, session);
    }
}

/// What GDAL's driver makes of the walls. \param fields beside Layer, which DXF has by itself
std::string written(const char* driverName, CPLStringList driverOptions, CPLStringList layerOptions,
                    std::span<const char* const> fields, std::span<const core::Wall> walls,
                    Names layerOfEach) {
    if (walls.size() != layerOfEach.size()) {
        throw std::invalid_argument("a drawing needs a layer's name for each wall");
    }
    const GdalSession session;
    const MemoryFile file;
    VSIUnlink(file.name());  // GeoJSON's driver replaces none
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driverName);
    GDALDatasetUniquePtr drawing(
        driver == nullptr
            ? nullptr
            : driver->Create(file.name(), 0, 0, 0, GDT_Unknown, driverOptions.List()));
    requireWritten(drawing != nullptr, session);
    OGRLayer* layer = drawing->CreateLayer("walls", nullptr, wkbLineString, layerOptions.List());
    requireWritten(layer != nullptr, session);
    for (const char* field : fields) {
        OGRFieldDefn definition(field, field == fields.front() ? OFTString : OFTReal);
        layer->CreateField(&definition);
    }
    writeWalls(*layer, walls, layerOfEach, session);
    CPLErrorReset();
    drawing.reset();
    requireWritten(CPLGetLastErrorType() < CE_Failure, session);
    return file.bytes();
}

}  // namespace

std::string dxfOf(std::span<const core::Wall> walls, Names layerOfEach) {
    RegisterOGRDXF();
    std::vector<std::string> names(layerOfEach.begin(), layerOfEach.end());
    std::ranges::transform(names, names.begin(), dxfName);
    const MemoryFile header(dxfHeader());
    CPLStringList options;
    options.SetNameValue("HEADER", header.name());
    return written("DXF", options, {}, {}, walls, names);
}

std::string geoJsonOf(std::span<const core::Wall> walls, Names layerOfEach) {
    RegisterOGRGeoJSON();
    CPLStringList options;
    options.SetNameValue("COORDINATE_PRECISION", "6");  // [digits] micrometres
    options.SetNameValue("WRITE_NAME", "NO");
    constexpr const char* fields[] = {"Layer", "sigma_m", "z_min_m", "z_max_m"};
    std::string text = written("GeoJSON", {}, options, fields, walls, layerOfEach);
    // GDAL writes those of its data base alone
    constexpr std::string_view planeInMetres =
        R"("crs": { "type": "name", "properties": { "name": )"
        R"("ENGCRS[\"local\",EDATUM[\"local\"],CS[Cartesian,2],AXIS[\"x\",east],)"
        R"(AXIS[\"y\",north],LENGTHUNIT[\"metre\",1]]" } },)"
        "\n";
    text.insert(text.find("\"features\""), planeInMetres);
    return text;
}

}  // namespace offmap::maps
