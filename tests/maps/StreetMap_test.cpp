// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

namespace {

using namespace offmap;
using namespace offmap::test;
using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// Extracts of OpenStreetMap: nodes 1 to 4 are the corners of a square of 20 m near the equator.
class StreetMap : public DrawingFixture {
 protected:
    maps::Drawing readWays(const std::string& ways, const maps::MapOptions& options = {}) const {
        std::string text = "<?xml version='1.0'?><osm version='0.6' generator='test'>";
        const char* const corners[][2] = {
            {"1", "0"}, {"1.00018", "0"}, {"1.00018", "0.00018"}, {"1", "0.00018"}};
        for (int i = 0; i < 4; ++i) {
            text += "<node id='" + std::to_string(i + 1) + "' lon='" + corners[i][0] + "' lat='" +
                    corners[i][1] + "' version='1'/>";
        }
        return read("town.osm", text + ways + "</osm>", options);
    }

    /// \param nodes "1 2 3"
    static std::string way(int id, const std::string& nodes, const std::string& key,
                           const std::string& value) {
        std::string text = "<way id='" + std::to_string(id) + "' version='1'>";
        for (const char node : nodes) {
            if (node != ' ') text += std::string("<nd ref='") + node + "'/>";
        }
        return text + "<tag k='" + key + "' v='" + value + "'/></way>";
    }

    static size_t wallsIn(const maps::Drawing& drawing, const std::string& layer) {
        size_t count = 0;
        for (const uint32_t index : drawing.layerOf) count += drawing.layers[index] == layer;
        return count;
    }
};

TEST_F(StreetMap, buildingsBarriersAndIndoorWallsAreLayers) {
    const auto drawing =
        readWays(way(1, "1 2 3 4 1", "building", "yes") + way(2, "1 3", "barrier", "wall") +
                 way(3, "2 4", "indoor", "wall") + way(4, "1 2 3 1", "indoor", "room"));
    EXPECT_THAT(drawing.layers,
                UnorderedElementsAre("building", "barrier-wall", "indoor-wall", "indoor-room"));
    EXPECT_EQ(wallsIn(drawing, "building"), 4U);
    EXPECT_EQ(wallsIn(drawing, "barrier-wall"), 1U);
    EXPECT_EQ(wallsIn(drawing, "indoor-wall"), 1U);
    EXPECT_EQ(wallsIn(drawing, "indoor-room"), 3U);
    EXPECT_EQ(drawing.format, "OpenStreetMap");
}

TEST_F(StreetMap, squareHasItsSize) {
    const auto drawing = readWays(way(1, "1 2 3 4 1", "building", "yes"));
    // along the equator a degree is 111319.49 m, across it 110574.28 m
    for (const core::Wall& wall : drawing.walls) {
        const auto side = wall.line.point2 - wall.line.point1;
        const bool isAlong = std::abs(side.x) > std::abs(side.y);
        EXPECT_NEAR(wall.line.length(), 0.00018 * (isAlong ? 111319.49 : 110574.28), 0.001);
    }
}

TEST_F(StreetMap, whatStandsNotIsLeftOut) {
    const auto drawing =
        readWays(way(1, "1 2", "barrier", "fence") + way(2, "1 3", "highway", "service") +
                 way(3, "1 2 3 4 1", "building", "roof") + way(4, "2 3", "barrier", "kerb"));
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_EQ(wallsIn(drawing, "barrier-fence"), 1U);
    EXPECT_THAT(drawing.notes,
                Contains(HasSubstr("neither building, barrier nor indoor wall (3)")));
}

}  // namespace
