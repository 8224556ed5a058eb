// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace offmap;
using namespace offmap::test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class EarthCoordinates : public DrawingFixture {
 protected:
    maps::Drawing lineOf(const std::string& coordinates, const maps::MapOptions& options = {},
                         const std::string& crs = "") const {
        return read("plan.geojson", geoJson(line(coordinates), crs), options);
    }

    static std::string named(const std::string& crs) {
        return R"("crs":{"type":"name","properties":{"name":")" + crs + R"("}},)";
    }
};

const std::string utm32 = "urn:ogc:def:crs:EPSG::32632";

/// Lengths of geodesics by Vincenty's inverse formula, WGS 84: (48.137, 11.575) to
/// (48.137, 11.5884) to (48.146, 11.575) to (48.1415, 11.5817).
TEST_F(EarthCoordinates, degreesBecomeTrueMetres) {
    const auto drawing =
        lineOf("[11.575,48.137],[11.5884,48.137],[11.575,48.146],[11.5817,48.1415]");
    ASSERT_EQ(drawing.walls.size(), 3U);
    EXPECT_NEAR(drawing.walls[0].line.length(), 997.329313, 0.001);
    EXPECT_NEAR(drawing.walls[1].line.length(), 1412.787244, 0.001);
    EXPECT_NEAR(drawing.walls[2].line.length(), 706.378382, 0.001);
    EXPECT_LT(drawing.walls[0].line.point1.x, drawing.walls[0].line.point2.x) << "x is east";
    EXPECT_LT(drawing.walls[1].line.point1.y, drawing.walls[1].line.point2.y) << "y is north";
    EXPECT_THAT(drawing.notes, ElementsAre(AllOf(HasSubstr("degrees, projected"),
                                                 HasSubstr("its middle 48.1415000,11.5817000"),
                                                 HasSubstr("--map-anchor"))));
}

TEST_F(EarthCoordinates, anchorIsTheOrigin) {
    maps::MapOptions options;
    options.anchor = maps::GeographicPlace{48.137, 11.575};
    const auto drawing = lineOf("[11.575,48.137],[11.5884,48.137]", options);
    EXPECT_NEAR(drawing.walls.at(0).line.point1.norm(), 0, 1e-6);
    EXPECT_NEAR(drawing.walls.at(0).line.point2.norm(), 997.329313, 0.001);
    EXPECT_THAT(drawing.notes, ElementsAre(HasSubstr("around 48.1370000,11.5750000")));
}

TEST_F(EarthCoordinates, localTakesDegreesForMetres) {
    maps::MapOptions options;
    options.coordinates = maps::MapCoordinates::Local;
    const auto drawing = lineOf("[-2.57,-1.46],[8.04,-1.46]", options);
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(-2.57, -1.46, 8.04, -1.46)));
    EXPECT_THAT(drawing.notes, ElementsAre("coordinates: local metres"));
    EXPECT_THAT(drawing.warnings, IsEmpty());
}

TEST_F(EarthCoordinates, metresThatClaimDegreesAreWarnedOf) {
    EXPECT_THAT(lineOf("[-2.57,-1.46],[8.04,-1.46]").warnings,
                ElementsAre(AllOf(HasSubstr("1181 km"), HasSubstr("--map-crs local"))));
}

TEST_F(EarthCoordinates, numbersBeyondDegreesAreMetres) {
    const auto drawing = lineOf("[0,0],[250,0]");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(0, 0, 250, 0)));
    EXPECT_THAT(drawing.notes, ElementsAre("coordinates: local metres"));
}

TEST_F(EarthCoordinates, unitMakesThemLengths) {
    maps::MapOptions options;
    options.units = maps::LengthUnit::Foot;
    EXPECT_THAT(lineOf("[0,0],[50,0]", options).walls, ElementsAre(IsLine(0, 0, 15.24, 0)));
}

TEST_F(EarthCoordinates, projectedMetresStayWithTheirMillimetres) {
    const auto drawing =
        lineOf("[691607.123,5334763.456],[691617.124,5334763.456]", {}, named(utm32));
    EXPECT_THAT(drawing.walls,
                ElementsAre(IsLine(691607.123, 5334763.456, 691617.124, 5334763.456)));
    EXPECT_THAT(drawing.notes, AllOf(Contains(HasSubstr("UTM zone 32N")),
                                     Contains(HasSubstr("up to 5335 km from its origin"))));
}

TEST_F(EarthCoordinates, anchorShiftsProjectedMetres) {
    maps::MapOptions options;
    // on the middle meridian of the zone, where its x is 500 km exactly
    options.anchor = maps::GeographicPlace{0, 9};
    const auto drawing = lineOf("[500003,4],[500013,4]", options, named(utm32));
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(3, 4, 13, 4)));
}

TEST_F(EarthCoordinates, feetOfTheSystemBecomeMetres) {
    const auto drawing = lineOf("[1000,2000],[1100,2000]", {}, named("urn:ogc:def:crs:EPSG::2272"));
    EXPECT_NEAR(drawing.walls.at(0).line.length(), 100 * 1200.0 / 3937, 1e-9);
}

TEST_F(EarthCoordinates, anchorOfLengthsIsWarnedOf) {
    maps::MapOptions options;
    options.anchor = maps::GeographicPlace{48, 11};
    EXPECT_THAT(lineOf("[0,0],[250,0]", options).warnings,
                ElementsAre(HasSubstr("--map-anchor does nothing")));
}

TEST_F(EarthCoordinates, geocentricIsRefusedWithTheFix) {
    EXPECT_THAT(errorOf("plan.geojson", geoJson(line("[4000000,800000],[4000010,800000]"),
                                                named("urn:ogc:def:crs:EPSG::4978"))),
                AllOf(HasSubstr("neither degrees nor lengths"), HasSubstr("--map-crs local")));
}

TEST_F(EarthCoordinates, nothingIsFetchedFromTheNet) {
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    ASSERT_EQ(listen(listener, 1), 0);
    ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
    const std::string url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/crs";
    const auto drawing = lineOf("[0,0],[250,0]", {},
                                R"("crs":{"type":"url","properties":{"url":")" + url + R"("}},)");
    EXPECT_EQ(drawing.walls.size(), 1U);
    pollfd asked{listener, POLLIN, 0};
    EXPECT_EQ(poll(&asked, 1, 0), 0) << "somebody connected";
    close(listener);
}

}  // namespace
