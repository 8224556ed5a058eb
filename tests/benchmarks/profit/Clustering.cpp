// SPDX-License-Identifier: BSD-3-Clause
#include "Clustering.h"

#include <algorithm>
#include <nanoflann.hpp>
#include <utility>

namespace offmap::profit {

namespace {

/// What nanoflann asks of a point cloud.
struct Points {
    std::span<const mrpt::math::TPoint3Df> points;

    // NOLINTBEGIN(readability-identifier-naming): nanoflann's names
    size_t kdtree_get_point_count() const { return points.size(); }
    float kdtree_get_pt(size_t i, size_t axis) const { return points[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
    // NOLINTEND(readability-identifier-naming)
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>,
                                                 Points, 3, uint32_t>;

}  // namespace

std::vector<Cluster> clustersOf(std::span<const mrpt::math::TPoint3Df> points, float tolerance,
                                size_t minPoints) {
    std::vector<Cluster> clusters;
    if (points.empty()) return clusters;
    const Points adapted{points};
    const Tree tree(3, adapted);
    const nanoflann::SearchParams unsorted(0, 0, false);
    std::vector<bool> taken(points.size());
    std::vector<std::pair<uint32_t, float>> neighbours;
    for (uint32_t seed = 0; seed < points.size(); ++seed) {
        if (taken[seed]) continue;
        taken[seed] = true;
        Cluster cluster{seed};
        for (size_t next = 0; next < cluster.size(); ++next) {
            const auto& at = points[cluster[next]];
            const float query[3] = {at.x, at.y, at.z};
            tree.radiusSearch(query, tolerance * tolerance, neighbours, unsorted);
            for (const auto& [index, squaredDistance] : neighbours) {
                if (taken[index]) continue;
                taken[index] = true;
                cluster.push_back(index);
            }
        }
        if (cluster.size() < minPoints) continue;
        std::sort(cluster.begin(), cluster.end());
        clusters.push_back(std::move(cluster));
    }
    return clusters;
}

}  // namespace offmap::profit
