// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

#include <algorithm>
#include <filesystem>

namespace {

using namespace offmap;
using namespace offmap::test;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

using BadDrawing = DrawingFixture;

const std::string wall = "0 LINE 8 W 10 0 20 0 11 4 21 0 ";

TEST_F(BadDrawing, missingFileIsNamed) {
    for (const char* name : {"plan.dxf", "plan.geojson", "plan.shp", "plan.gpkg", "plan.osm"}) {
        EXPECT_THAT(errorOf(folder_ / name), AllOf(HasSubstr((folder_ / name).string() + ": "),
                                                   HasSubstr("No such file or directory")));
    }
}

TEST_F(BadDrawing, emptyFileIsNamed) {
    for (const char* name : {"plan.dxf", "plan.json", "plan.gml", "plan.kml", "plan.fgb"}) {
        EXPECT_THAT(errorOf(name, ""), AllOf(HasSubstr(name), HasSubstr("is empty")));
    }
}

TEST_F(BadDrawing, folderIsNamed) {
    for (const char* name : {"plan.dxf", "plan.geojson"}) {
        std::filesystem::create_directory(folder_ / name);
        EXPECT_THAT(errorOf(folder_ / name), HasSubstr("is a folder"));
    }
}

TEST_F(BadDrawing, contentOfAnotherFormatIsRefused) {
    EXPECT_THAT(errorOf("plan.dxf", geoJson(line("[0,0],[1,0]"))),
                HasSubstr("is no DXF by its content"));
    EXPECT_THAT(errorOf("plan.geojson", dxf(wall)), HasSubstr("is no GeoJSON by its content"));
    for (const char* name : {"a.dxf", "a.json", "a.gpkg", "a.gml", "a.kml", "a.fgb", "a.osm"}) {
        EXPECT_THAT(errorOf(name, "a picture"), HasSubstr("by its content")) << name;
    }
}

TEST_F(BadDrawing, virtualDatasetIsRefused) {
    const char* virtualFile =
        "<OGRVRTDataSource><OGRVRTLayer name=\"x\"><SrcDataSource>/etc/passwd</SrcDataSource>"
        "</OGRVRTLayer></OGRVRTDataSource>";
    for (const char* name : {"plan.dxf", "plan.json", "plan.gml", "plan.kml", "plan.gpkg"}) {
        EXPECT_THAT(errorOf(name, virtualFile), HasSubstr("plan.")) << name;
    }
}

TEST_F(BadDrawing, binaryDxfIsRefusedWithTheFix) {
    EXPECT_THAT(errorOf("plan.dxf", std::string("AutoCAD Binary DXF\r\n\x1a\0", 22)),
                HasSubstr("save it as ASCII DXF"));
}

TEST_F(BadDrawing, dxfCutOffAnywhereIsNoHalfMap) {
    const std::string whole = dxf(wall + "0 LINE 8 W 10 0 20 1 11 4 21 1");
    const size_t end = whole.rfind("ENDSEC");
    for (size_t size = 1; size < whole.size(); ++size) {
        writeFile(folder_ / "cut.dxf", whole.substr(0, size));
        try {
            const auto drawing = maps::readVectorDrawing(folder_ / "cut.dxf", {});
            EXPECT_EQ(drawing.walls.size(), 2U) << size;
            EXPECT_GE(size, end + 6) << "it was cut off before the end of its entities";
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("cut.dxf: ")) << size;
            EXPECT_LT(size, whole.size() - 5) << "only the end of the file is missing";
        }
    }
}

TEST_F(BadDrawing, dxfOutOfStepTellsTheLine) {
    std::string bytes = dxf(wall);
    const size_t layer = bytes.find("\n8\nW\n");
    const auto line = std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(layer), '\n') + 2;
    bytes.erase(layer, 2);  // the code of the layer's name, which becomes one itself
    EXPECT_THAT(errorOf("plan.dxf", bytes),
                HasSubstr("line " + std::to_string(line) + " is 'W', not a group code"));
}

TEST_F(BadDrawing, shapefileWithoutItsIndexTellsTheFix) {
    EXPECT_THAT(errorOf("plan.shp", "x"),
                AllOf(HasSubstr("its companion plan.shx is missing"), HasSubstr("copy")));
    EXPECT_THAT(folder_.names(), testing::ElementsAre("plan.shp")) << "nothing is made beside it";
}

TEST_F(BadDrawing, mapWithoutWallTellsWhatWasLeftOut) {
    EXPECT_THAT(errorOf("plan.dxf", dxf("0 TEXT 8 T 10 0 20 0 40 1 1 x")),
                AllOf(HasSubstr("holds no wall"), HasSubstr("points and texts (1)")));
    EXPECT_THAT(errorOf("plan.json", geoJson("")), HasSubstr("holds no wall"));
}

TEST_F(BadDrawing, placesThatAreNotFiniteAreLeftOut) {
    const auto drawing = read("plan.json", geoJson(line("[0,0],[1e999,1]") + "," +
                                                   line("[200,0],[210,0],[NaN,1],[220,2],[223,6]") +
                                                   "," + line("[200,5],[1e300,5]")));
    EXPECT_THAT(drawing.walls,
                testing::ElementsAre(IsLine(200, 0, 210, 0), IsLine(220, 2, 223, 6)));
    EXPECT_THAT(drawing.warnings,
                Contains(AllOf(HasSubstr("3 lines have places that are not finite"),
                               HasSubstr("feature 0 of layer plan"))));
}

TEST_F(BadDrawing, linesWithoutLengthAreLeftOut) {
    const auto drawing =
        readDxf(wall + "0 LINE 8 X 10 1 20 1 11 1 21 1 0 LINE 8 X 10 3 20 3 11 3 21 3");
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(drawing.warnings, Contains(AllOf(HasSubstr("2 lines without length"),
                                                 HasSubstr("feature 1 of layer X"))));
}

TEST_F(BadDrawing, repeatedPlacesDoNoHarm) {
    const auto drawing = read("plan.json", geoJson(line("[200,0],[200,0],[205,0],[205,0]")));
    EXPECT_THAT(drawing.walls, testing::ElementsAre(IsLine(200, 0, 205, 0)));
    EXPECT_THAT(drawing.warnings, testing::IsEmpty());
}

TEST_F(BadDrawing, blockOfItselfEnds) {
    const char* self =
        "0 BLOCK 8 0 2 A 70 0 10 0 20 0 0 LINE 8 W 10 0 20 0 11 4 21 0 "
        "0 INSERT 8 0 2 A 10 1 20 0 0 ENDBLK 8 0";
    try {
        EXPECT_FALSE(readDxf("0 INSERT 8 0 2 A 10 0 20 0", self).walls.empty());
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("plan.dxf"));
    }
}

TEST_F(BadDrawing, namesAreFitToPrint) {
    const auto drawing =
        read("plan.json", geoJson(line("[200,0],[205,0]", R"("Layer":"a\u001b[31m\nb")")));
    EXPECT_THAT(drawing.layers, testing::ElementsAre("a?[31m?b"));
}

}  // namespace
