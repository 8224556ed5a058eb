// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/TemporaryFolder.h"

#include <offmap/maps/VectorDrawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace offmap::test {

/// A DXF: each word is a line of it. \param header variables \param blocks, entities as they stand
inline std::string dxf(std::string_view entities, std::string_view blocks = "",
                       std::string_view header = "9 $ACADVER 1 AC1015") {
    std::stringstream words;
    words << "0 SECTION 2 HEADER " << header << " 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 2"
          << " 0 LAYER 2 OFF 70 0 62 -7 6 CONTINUOUS 0 LAYER 2 FROZEN 70 1 62 7 6 CONTINUOUS"
          << " 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS " << blocks << " 0 ENDSEC 0 SECTION 2 ENTITIES "
          << entities << " 0 ENDSEC 0 EOF";
    std::string lines, word;
    while (words >> word) lines += word + '\n';
    return lines;
}

/// GeoJSON of features. \param crs the member of that name, with a comma behind it
inline std::string geoJson(std::string_view features, std::string_view crs = "") {
    return R"({"type":"FeatureCollection",)" + std::string(crs) + R"("features":[)" +
           std::string(features) + "]}";
}

/// A feature of GeoJSON. \param coordinates "[0,0],[1,0]"
inline std::string line(std::string_view coordinates, std::string_view properties = "") {
    return R"({"type":"Feature","properties":{)" + std::string(properties) +
           R"(},"geometry":{"type":"LineString","coordinates":[)" + std::string(coordinates) +
           "]}}";
}

/// Reads drawings that a test has written.
class DrawingFixture : public testing::Test {
 protected:
    maps::Drawing read(const std::string& name, const std::string& bytes,
                       const maps::MapOptions& options = {}) const {
        writeFile(folder_ / name, bytes);
        return maps::readVectorDrawing(folder_ / name, options);
    }

    maps::Drawing readDxf(std::string_view entities, std::string_view blocks = "") const {
        return read("plan.dxf", dxf(entities, blocks));
    }

    std::string errorOf(const std::string& name, const std::string& bytes) const {
        writeFile(folder_ / name, bytes);
        return errorOf(folder_ / name);
    }

    static std::string errorOf(const std::filesystem::path& file) {
        try {
            maps::readVectorDrawing(file, {});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    }

    TemporaryFolder folder_;
};

/// A straight wall between these places, to a micrometre.
MATCHER_P4(IsLine, x1, y1, x2, y2, "") {
    constexpr double near = 1e-6;
    return arg.curvature == 0 && std::abs(arg.line.point1.x - x1) < near &&
           std::abs(arg.line.point1.y - y1) < near && std::abs(arg.line.point2.x - x2) < near &&
           std::abs(arg.line.point2.y - y2) < near;
}

}  // namespace offmap::test
