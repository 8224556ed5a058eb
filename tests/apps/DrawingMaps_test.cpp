// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

/// The office's plan in formats that GDAL's ogr2ogr writes, which is another program than ours.
class DrawingMaps : public ReduceFixture {
 protected:
    void SetUp() override {
        OFFMAP_NEEDS_SHARED_DATA();
        in_ = sharedData("room/room1.rawlog");
        map_ = sharedData("room/room.lines");
        byText_ = removed(reduce());
        ASSERT_GT(byText_, 17'000) << "the office was reduced";
        writeGeoJson();
    }

    /// What the formats begin with: the lines of the text map, in GeoJSON.
    void writeGeoJson() {
        nlohmann::json features = nlohmann::json::array();
        std::istringstream text(readFile(map_));
        for (std::string row; std::getline(text, row);) {
            std::istringstream numbers(row);
            double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
            if (!(numbers >> x1 >> y1 >> x2 >> y2)) continue;
            const nlohmann::json places{{x1, y1}, {x2, y2}};
            features.push_back({{"type", "Feature"},
                                {"properties", {{"Layer", "walls"}}},
                                {"geometry", {{"type", "LineString"}, {"coordinates", places}}}});
        }
        const nlohmann::json all{{"type", "FeatureCollection"}, {"features", features}};
        writeFile(folder_ / "room.geojson", all.dump());
    }

    Path converted(const std::string& name, Arguments options = {}) const {
        options.insert(options.begin(), {"/usr/bin/ogr2ogr", folder_ / name});
        options.push_back(folder_ / "room.geojson");
        const RunResult run = runProgram(options);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return folder_ / name;
    }

    /// Points, by the summary.
    static int64_t removed(const RunResult& run) {
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        std::istringstream line(
            run.out.substr(std::min(run.out.size(), run.out.find("\nremoved "))));
        std::string word, digits;
        line >> word >> word;
        for (const char c : word) digits += c == ',' ? "" : std::string(1, c);
        return std::stoll("0" + digits);
    }

    void expectReducesAlike(const Path& file, const Arguments& options) {
        map_ = file;
        Arguments all = options;
        all.push_back("--force");
        // the requirement; only the order of the walls differs, and the last digits of a KML
        EXPECT_NEAR(double(removed(reduce(all))), double(byText_), 0.02 * double(byText_)) << file;
        EXPECT_EQ(readFile(in_), readFile(sharedData("room/room1.rawlog")));
    }

    int64_t byText_ = 0;
};

TEST_F(DrawingMaps, dxfOfOgr2ogrSaysInchesAndIsWarnedOf) {
    const Path file = converted("room.dxf");
    expectReducesAlike(file, {"--map-units", "m"});
    const RunResult inches = reduce({"--force"});
    EXPECT_EQ(removed(inches), 0) << "a map of 27 cm fits no scan";
    EXPECT_THAT(inches.out, HasSubstr("unit: inches, by the drawing's $INSUNITS"));
    EXPECT_THAT(inches.err, AllOf(HasSubstr("0.269 m"), HasSubstr("--map-units m")));
}

TEST_F(DrawingMaps, otherFormatsOfOgr2ogrReduceAlike) {
    for (const char* name : {"room.shp", "room.gpkg", "room.gml", "room.kml", "room.fgb"}) {
        expectReducesAlike(converted(name), {"--map-crs", "local"});
    }
    expectReducesAlike(folder_ / "room.geojson", {"--map-crs", "local"});
}

TEST_F(DrawingMaps, readingLeavesNothingBesideTheMap) {
    map_ = converted("room.gml");
    std::filesystem::remove(folder_ / "room.xsd");
    const auto before = folder_.names();  // the log reduced by the text map is among them
    EXPECT_EQ(removed(reduce({"--map-crs", "local", "--force"})), byText_);
    EXPECT_THAT(folder_.names(), testing::UnorderedElementsAreArray(before));
}

TEST_F(DrawingMaps, metresWithoutASystemNeedNoOption) {
    for (const char* name : {"room.shp", "room.gpkg"}) {
        expectReducesAlike(converted(name, {"-a_srs",
                                            "ENGCRS[\"building\",EDATUM[\"building\"],"
                                            "CS[Cartesian,2],AXIS[\"x\",east],"
                                            "AXIS[\"y\",north],LENGTHUNIT[\"metre\",1]]"}),
                           {});
    }
}

TEST_F(DrawingMaps, projectedMapIsShiftedByItsAnchor) {
    // metres of a transverse Mercator around 48 N 11 E are the office's own
    const Path file = converted(
        "room.gpkg", {"-a_srs", "+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=0 +y_0=0 +datum=WGS84"});
    expectReducesAlike(file, {"--map-anchor", "48,11"});
    expectReducesAlike(file, {});
}

TEST_F(DrawingMaps, degreesOfTheEarthReduceAlike) {
    // what a surveyor would give: the office near Munich, in degrees
    converted("projected.gpkg", {"-a_srs", "+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +datum=WGS84"});
    const RunResult run =
        runProgram({"/usr/bin/ogr2ogr", "-t_srs", "EPSG:4326", "-lco", "COORDINATE_PRECISION=10",
                    folder_ / "earth.geojson", folder_ / "projected.gpkg"});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    expectReducesAlike(folder_ / "earth.geojson", {"--map-anchor", "48,11"});
}

TEST_F(DrawingMaps, layersAreChosenByName) {
    map_ = converted("room.gpkg");
    expectReducesAlike(map_, {"--map-crs", "local", "--map-layer", "WALL*"});
    expectRefusal(reduceArguments({"--map-crs", "local", "--map-layer", "doors", "--force"}), 2,
                  AllOf(HasSubstr("no layer 'doors'"), HasSubstr("there are: walls")));
}

}  // namespace
