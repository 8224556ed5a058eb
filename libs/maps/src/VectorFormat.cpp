// SPDX-License-Identifier: BSD-3-Clause
#include "VectorFormat.h"

#include <offmap/maps/LowerCase.h>

#include <ogrsf_frmts.h>
#include <stdexcept>

namespace offmap::maps {

const std::vector<VectorFormat>& vectorFormats() {
    using enum VectorKind;
    static const std::vector<VectorFormat> all{
        {"DXF", {".dxf"}, "DXF", RegisterOGRDXF, Cad, {}},
        {"GeoJSON", {".geojson", ".json"}, "GeoJSON", RegisterOGRGeoJSON, Geographic, {}},
        {"Shapefile", {".shp"}, "ESRI Shapefile", RegisterOGRShape, Geographic, {}},
        {"GeoPackage", {".gpkg"}, "GPKG", RegisterOGRGeoPackage, Geographic, {}},
        {"GML",
         {".gml"},
         "GML",
         RegisterOGRGML,
         Geographic,
         {"WRITE_GFS=NO", "DOWNLOAD_SCHEMA=NO"}},
        {"KML", {".kml"}, "KML", RegisterOGRKML, Geographic, {}},
        {"FlatGeobuf", {".fgb"}, "FlatGeobuf", RegisterOGRFlatGeobuf, Geographic, {}},
        {"OpenStreetMap", {".osm", ".pbf"}, "OSM", RegisterOGROSM, StreetMap, {}},
    };
    return all;
}

const VectorFormat& vectorFormatOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    for (const VectorFormat& format : vectorFormats()) {
        for (const std::string_view known : format.extensions) {
            if (extension == known) return format;
        }
    }
    throw std::invalid_argument(file.string() + ": is no drawing, by its extension");
}

}  // namespace offmap::maps
