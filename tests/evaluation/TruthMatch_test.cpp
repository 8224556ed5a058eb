// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/TruthMatch.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace offmap::evaluation {
namespace {

using mrpt::math::TPoint3Df;

std::vector<bool> removedIn(const TruthMatch& match) {
    std::vector<bool> removed;
    for (const ScoredPoint& point : match.points) removed.push_back(point.removed);
    return removed;
}

std::vector<TruePoint> pointsAt(const std::vector<TPoint3Df>& places) {
    std::vector<TruePoint> points;
    for (const TPoint3Df& place : places) points.push_back({place});
    return points;
}

TEST(TruthMatch, whatIsNotLeftWasRemoved) {
    const auto truth = pointsAt({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    const auto match = matchTruth(truth, std::vector<TPoint3Df>{{3, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(removedIn(match), (std::vector<bool>{false, true, false}));
    EXPECT_EQ(match.unknown, 0U);
}

TEST(TruthMatch, equalPointsAreCountedOneByOne) {
    const auto truth = pointsAt({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
    const auto match = matchTruth(truth, std::vector<TPoint3Df>{{1, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(removedIn(match), (std::vector<bool>{false, false, true}));
    const auto more = matchTruth(truth, std::vector<TPoint3Df>(5, {1, 0, 0}));
    EXPECT_EQ(removedIn(more), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(more.unknown, 2U);
}

TEST(TruthMatch, theLastBitCounts) {
    const float next = std::nextafter(1.0F, 2.0F);
    const auto match = matchTruth(pointsAt({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
                                  std::vector<TPoint3Df>{{next, 0, 0}, {0, next, 0}, {0, 0, next}});
    EXPECT_EQ(removedIn(match), (std::vector<bool>{true, true, true}));
    EXPECT_EQ(match.unknown, 3U);
}

TEST(TruthMatch, whatIsKnownOfAPointIsHandedOn) {
    const std::vector<TruePoint> truth{{{1, 2, 3}, true, SurfaceKind::Wall, {}, true},
                                       {{4, 5, 6}, false, SurfaceKind::Floor, 0.25F, false}};
    const auto match = matchTruth(truth, std::vector<TPoint3Df>{});
    ASSERT_EQ(match.points.size(), 2U);
    EXPECT_TRUE(match.points[0].mapped && match.points[0].onVerticalSegment);
    EXPECT_EQ(match.points[0].kind, SurfaceKind::Wall);
    EXPECT_FALSE(match.points[1].mapped || match.points[1].onVerticalSegment);
    EXPECT_EQ(match.points[1].kind, SurfaceKind::Floor);
    EXPECT_EQ(match.points[1].standOff, 0.25F);
}

TEST(TruthMatch, anyPartOfManyPointsIsFound) {
    std::mt19937 random(1);
    std::vector<TruePoint> truth;
    std::vector<TPoint3Df> left;
    std::vector<bool> removed;
    for (int i = 0; i < 5000; ++i) {
        // 20 x 20 x 20 places, so that many points are equal; those of a place share their fate.
        const TPoint3Df place(static_cast<float>(random() % 20), static_cast<float>(random() % 20),
                              static_cast<float>(random() % 20));
        truth.push_back({place});
        removed.push_back(std::fmod(place.x + place.y + place.z, 3) == 0);
        if (!removed.back()) left.push_back(place);
    }
    std::shuffle(left.begin(), left.end(), random);
    EXPECT_EQ(removedIn(matchTruth(truth, left)), removed);
}

}  // namespace
}  // namespace offmap::evaluation
