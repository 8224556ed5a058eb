// SPDX-License-Identifier: BSD-3-Clause
#include "Clustering.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace offmap::profit {
namespace {

using mrpt::math::TPoint3Df;

/// The same by comparing every point with every other, and renaming clusters that meet.
std::vector<Cluster> byBruteForce(const std::vector<TPoint3Df>& points, float tolerance,
                                  size_t minPoints) {
    std::vector<size_t> name(points.size());
    std::iota(name.begin(), name.end(), 0U);
    for (size_t i = 0; i < points.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            const TPoint3Df d = points[i] - points[j];
            if (d.x * d.x + d.y * d.y + d.z * d.z >= tolerance * tolerance) continue;
            const size_t one = std::min(name[i], name[j]), other = std::max(name[i], name[j]);
            std::replace(name.begin(), name.end(), other, one);
        }
    }
    std::vector<Cluster> clusters;
    for (size_t n = 0; n < points.size(); ++n) {
        Cluster cluster;
        for (uint32_t i = 0; i < points.size(); ++i) {
            if (name[i] == n) cluster.push_back(i);
        }
        if (cluster.size() >= minPoints) clusters.push_back(cluster);
    }
    return clusters;
}

TEST(Clustering, isThatOfBruteForce) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> somewhere(0, 4);
    std::vector<TPoint3Df> points;
    for (int i = 0; i < 600; ++i) {
        points.emplace_back(somewhere(random), somewhere(random), somewhere(random));
    }
    for (const size_t minPoints : {1, 5}) {
        // 600 points in 64 m^3 have 2.5 neighbours within 0.4 m: clusters of all sizes
        const auto clusters = clustersOf(points, 0.4F, minPoints);
        EXPECT_GT(clusters.size(), 5U);
        EXPECT_EQ(clusters, byBruteForce(points, 0.4F, minPoints));
    }
}

TEST(Clustering, noPointsGiveNoClusters) { EXPECT_TRUE(clustersOf({}, 0.1F, 1).empty()); }

}  // namespace
}  // namespace offmap::profit
