// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Reducer.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>
#include <offmap/evaluation/WallTracer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offmap::evaluation {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;

namespace {

constexpr double sensorHeight = 1.1;  // [m]
constexpr double near = 0.05;         // [m] within which a wall is found

core::SensorPose sensorAt(const TPoint2D& place) {
    constexpr double sigma = 0.01, heading = 0.2 * std::numbers::pi / 180;  // [m], [rad]
    core::SensorPose pose;
    pose.sensorInMap.setFromValues(place.x, place.y, sensorHeight);
    pose.groundCovariance =
        Eigen::Vector3d(sigma * sigma, sigma * sigma, heading * heading).asDiagonal();
    return pose;
}

/// Traces what a scanner shows from these places, its poses as wrong as they say.
std::vector<TracedWall> traced(const World& world, const Scanner& scanner,
                               const std::vector<TPoint2D>& places) {
    const core::LineMap nothing({});
    const core::ReductionConfig config;
    core::Reducer reducer(nothing, config);
    WallTracer tracer({});
    GaussianNoise noise(5);
    for (size_t i = 0; i < places.size(); ++i) {
        const core::SensorPose truth = sensorAt(places[i]);
        SimulatedScan simulated = simulate(world, scanner, truth, {.range = 0.02}, i + 1);
        setSensor(simulated.scan, drawEstimate(truth, noise));
        tracer.add(seenSegments(simulated.scan, reducer.reduce(simulated.scan), config));
    }
    return tracer.walls();
}

std::vector<TPoint2D> samplesOf(const TSegment2D& line) {
    constexpr double spacing = 0.05;  // [m]
    const int count = std::max(1, static_cast<int>(line.length() / spacing));
    std::vector<TPoint2D> samples;
    for (int i = 0; i < count; ++i) {
        samples.push_back(line.point1 + (line.point2 - line.point1) * ((i + 0.5) / count));
    }
    return samples;
}

double nearest(const TPoint2D& place, const std::vector<TSegment2D>& lines) {
    double least = 1e9;
    for (const TSegment2D& line : lines) least = std::min(least, line.distance(place));
    return least;
}

/// Walls, and doors, which nothing tells from walls: all panels as tall as a door.
std::vector<TSegment2D> wallsIn(const World& world) {
    constexpr double tall = 1.9;  // [m]
    std::vector<TSegment2D> lines;
    for (const Surface& surface : world.surfaces()) {
        const auto* panel = std::get_if<Panel>(&surface.shape);
        if (panel && panel->height.width() >= tall) lines.push_back(panel->line);
    }
    return lines;
}

/// Whether a beam from a place shows it, and the columns beside show what is near enough to it to
/// be known for the same wall. \param columnAngle [rad] between columns
bool isVisible(const World& world, const TPoint2D& from, const TPoint2D& place,
               const TSegment2D& wall, double columnAngle) {
    const TPoint2D beam = place - from;
    const double range = beam.norm();
    const TPoint2D way = (wall.point2 - wall.point1) * (1 / wall.length());
    const double sine = std::abs(way.x * beam.y - way.y * beam.x) / range;
    if (columnAngle * range > WallTracerConfig().maxGap * sine) return false;
    const auto hit = world.castRay({from.x, from.y, sensorHeight},
                                   {beam.x / range, beam.y / range, 0}, range + 1);
    return hit && std::abs(hit->range - range) < 1e-3;
}

struct Judgement {
    double visible = 0, found = 0;  ///< samples of walls
    double drawn = 0, wrong = 0;    ///< samples of what was traced
};

Judgement judge(const World& world, const std::vector<TracedWall>& walls,
                const std::vector<TPoint2D>& places, double columnAngle) {
    std::vector<TSegment2D> lines;
    for (const TracedWall& one : walls) lines.push_back(one.wall.line);
    const std::vector<TSegment2D> truth = wallsIn(world);
    Judgement judgement;
    for (const core::Wall& wall : mapOf(world)) {
        for (const TPoint2D& sample : samplesOf(wall.line)) {
            const bool visible = std::ranges::any_of(places, [&](const TPoint2D& from) {
                return isVisible(world, from, sample, wall.line, columnAngle);
            });
            judgement.visible += visible;
            judgement.found += visible && nearest(sample, lines) <= near;
        }
    }
    for (const TSegment2D& line : lines) {
        for (const TPoint2D& sample : samplesOf(line)) {
            ++judgement.drawn;
            judgement.wrong += nearest(sample, truth) > near;
        }
    }
    return judgement;
}

constexpr double paperColumns = 2 * std::numbers::pi / 180;    // [rad]
constexpr double vlp16Columns = 0.4 * std::numbers::pi / 180;  // [rad]

void expectWellTraced(const World& world, const Scanner& scanner, double columnAngle,
                      const std::vector<TPoint2D>& places) {
    const auto walls = traced(world, scanner, places);
    const Judgement judgement = judge(world, walls, places, columnAngle);
    EXPECT_GT(judgement.visible, 200);
    EXPECT_GE(judgement.found, 0.9 * judgement.visible);
    EXPECT_LE(judgement.wrong, 0.05 * judgement.drawn);
}

const std::vector<TPoint2D> inOffice{{2, 2.5}, {4, 2.5}, {6, 3}, {3, 1.5}};
const std::vector<TPoint2D> inCorridor{{2, 0}, {4, 0}, {7, 0.2}, {11, 0}, {14, -0.2}, {17, 0}};

}  // namespace

TEST(WallTracer, officeIsTracedWithoutItsThings) {
    expectWellTraced(officeRoom(), paperScanner(), paperColumns, inOffice);
    expectWellTraced(officeRoom(), vlp16(), vlp16Columns, inOffice);
}

TEST(WallTracer, corridorIsTraced) {
    expectWellTraced(corridor(), paperScanner(), paperColumns, inCorridor);
    expectWellTraced(corridor(), vlp16(), vlp16Columns, inCorridor);
}

TEST(WallTracer, bareRoomBecomesFourWallsThatMeet) {
    World room;
    const std::vector<TPoint2D> corners{{0, 0}, {6, 0}, {6, 4}, {0, 4}};
    for (size_t i = 0; i < 4; ++i) {
        room.addMappedPanel({{corners[i], corners[(i + 1) % 4]}, core::Interval(0, 2.8)});
    }
    const auto walls = traced(room, paperScanner(), {{2, 2}, {4, 2}});
    ASSERT_EQ(walls.size(), 4U);
    for (const TracedWall& one : walls) {
        EXPECT_EQ(one.scans, 2U);
        for (const TPoint2D& end : {one.wall.line.point1, one.wall.line.point2}) {
            const auto distance = [&](const TPoint2D& corner) { return (corner - end).norm(); };
            // Three sigmas of the mean of two poses, 1 cm and 0.2 degrees over 4 m, across both
            // walls: 3 sqrt(2) hypot(0.01, 0.014) / sqrt(2) = 0.05 m.
            EXPECT_LT(distance(*std::ranges::min_element(corners, {}, distance)), 0.05);
            const auto meets = std::ranges::count_if(walls, [&](const TracedWall& other) {
                return other.wall.line.point1 == end || other.wall.line.point2 == end;
            });
            EXPECT_GE(meets, 1);
        }
        EXPECT_EQ(std::ranges::count_if(walls,
                                        [&](const TracedWall& other) {
                                            return other.wall.line.distance(one.wall.line.point1) <
                                                   1e-9;
                                        }),
                  2)
            << "itself and one more";
    }
}

namespace {

/// What a scan shows of a line, in columns of 4 cm.
std::vector<SeenSegment> seenLine(const TPoint2D& sensor, const TPoint2D& a, const TPoint2D& b,
                                  bool seenOver = false) {
    const auto count = static_cast<uint32_t>((b - a).norm() / 0.04);
    std::vector<SeenSegment> segments;
    for (uint32_t i = 0; i <= count; ++i) {
        segments.push_back({i, sensor, a + (b - a) * (static_cast<double>(i) / count),
                            Eigen::Matrix2d::Identity() * 1e-4, core::Interval(0, 2.5), 20,
                            seenOver});
    }
    return segments;
}

}  // namespace

TEST(WallTracer, whatIsSeenOverIsNoWall) {
    WallTracer tracer({});
    tracer.add(seenLine({0, 0}, {2, -1}, {2, 1}, true));
    EXPECT_TRUE(tracer.walls().empty());
    tracer.add(seenLine({0, 0}, {2, -1}, {2, 1}));
    EXPECT_EQ(tracer.walls().size(), 1U);
}

TEST(WallTracer, shortAndSeldomSeenLinesAreDropped) {
    WallTracer tracer({.minLength = 0.5, .minScans = 2});
    tracer.add(seenLine({0, 0}, {2, -1}, {2, 1}));
    tracer.add(seenLine({0, 0}, {-2, -0.2}, {-2, 0.2}));
    tracer.add(seenLine({0, 0}, {-2, -0.2}, {-2, 0.2}));
    EXPECT_TRUE(tracer.walls().empty());
    tracer.add(seenLine({0, 0}, {2, -1}, {2, 1}));
    ASSERT_EQ(tracer.walls().size(), 1U);
    EXPECT_EQ(tracer.walls()[0].scans, 2U);
    EXPECT_NEAR(tracer.walls()[0].wall.line.length(), 2, 1e-9);
}

TEST(WallTracer, facesOfAThinWallStayApart) {
    WallTracer tracer({});
    tracer.add(seenLine({0, 0}, {2, -1}, {2, 1}));
    tracer.add(seenLine({4, 0}, {2.04, -1}, {2.04, 1}));
    EXPECT_EQ(tracer.walls().size(), 2U);
}

TEST(WallTracer, piecesWithADoorwayBetweenStayApartUntilOneSpansThem) {
    WallTracer tracer({});
    tracer.add(seenLine({0, 0}, {2, -2}, {2, -0.5}));
    tracer.add(seenLine({0, 0}, {2, 0.5}, {2, 2}));
    EXPECT_EQ(tracer.walls().size(), 2U);
    tracer.add(seenLine({0, 0}, {2.01, -0.8}, {2.01, 0.8}));
    ASSERT_EQ(tracer.walls().size(), 1U);
    EXPECT_NEAR(tracer.walls()[0].wall.line.length(), 4, 0.01);
    EXPECT_EQ(tracer.walls()[0].scans, 3U);
}

TEST(ClosedCorners, endsThatNearlyMeetDoAndOthersStay) {
    std::vector<core::Wall> walls{{.line = {{0, 0}, {3.9, 0}}},      // stops short of the corner
                                  {.line = {{4, -0.2}, {4, 3}}},     // runs past it
                                  {.line = {{1.5, 0.1}, {1.5, 2}}},  // a T
                                  {.line = {{4.1, 3.5}, {8, 3.5}}}};
    closeCorners(walls, 0.3);
    EXPECT_EQ(walls[0].line.point2, TPoint2D(4, 0));
    EXPECT_EQ(walls[1].line.point1, TPoint2D(4, 0));
    EXPECT_EQ(walls[2].line.point1, TPoint2D(1.5, 0));
    EXPECT_EQ(walls[0].line.point1, TPoint2D(0, 0));
    EXPECT_EQ(walls[1].line.point2, TPoint2D(4, 3)) << "half a metre off is no corner";
    EXPECT_EQ(walls[3].line.point1, TPoint2D(4.1, 3.5));
}

}  // namespace offmap::evaluation
