// SPDX-License-Identifier: BSD-3-Clause
// What else one would take to remove a known building from a scan, and that needs it as a cloud:
// the filters of PCL as map comparison is built from them. The least that any filter costs is one
// pass over the points.
#include "Office.h"

#include <offmap/core/WallGeometry.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/octree/octree_pointcloud_changedetector.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/segment_differences.h>
#include <string>
#include <utility>
#include <vector>

namespace offmap::core {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float reach = 0.2F;     // [m] from the map within which a return is mapped
constexpr double spacing = 0.05;  // [m] of the map's points
constexpr double ceiling = 2.8;   // [m]

/// Walls, floor and ceiling of the office.
Cloud::Ptr mapCloud(const LineMap& map) {
    auto cloud = std::make_shared<Cloud>();
    const auto add = [&](double x, double y, double z) {
        cloud->emplace_back(float(x), float(y), float(z));
    };
    mrpt::math::TPoint2D low{1e9, 1e9}, high{-1e9, -1e9};
    for (const Wall& wall : map.walls()) {
        const double length = lengthOf(wall);
        for (double s = 0; s <= length; s += spacing) {
            const auto place = placeAt(wall, s / length);
            for (double z = 0; z <= ceiling; z += spacing) add(place.x, place.y, z);
        }
        const auto [a, b] = boundsOf(wall);
        low = {std::min(low.x, a.x), std::min(low.y, a.y)};
        high = {std::max(high.x, b.x), std::max(high.y, b.y)};
    }
    for (double x = low.x; x <= high.x; x += spacing) {
        for (double y = low.y; y <= high.y; y += spacing) {
            add(x, y, 0);
            add(x, y, ceiling);
        }
    }
    return cloud;
}

/// The same scan as for offmap, in the map's frame.
struct Rivals {
    explicit Rivals(const evaluation::Scanner& scanner) : office(scanner) {
        for (const auto& p : office.scan.points) {
            const auto q = office.pose.sensorInMap.composePoint(mrpt::math::TPoint3D(p));
            scan->emplace_back(float(q.x), float(q.y), float(q.z));
        }
    }
    test::Office office;
    Cloud::Ptr map = mapCloud(office.map);
    Cloud::Ptr scan = std::make_shared<Cloud>();
};

void report(benchmark::State& state, const Rivals& rivals, size_t kept) {
    state.counters["points"] = double(rivals.scan->size());
    state.counters["mapped"] = double(rivals.scan->size() - kept);
}

void kdTreeDistance(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Rivals rivals(scanner);
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(rivals.map);
    std::vector<int> index(1);
    std::vector<float> squaredDistance(1);
    size_t kept = 0;
    for (auto _ : state) {
        kept = 0;
        for (const auto& point : *rivals.scan) {
            tree.nearestKSearch(point, 1, index, squaredDistance);
            kept += squaredDistance[0] > reach * reach;
        }
        benchmark::DoNotOptimize(kept);
    }
    report(state, rivals, kept);
}

void segmentDifferences(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Rivals rivals(scanner);
    auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
    tree->setInputCloud(rivals.map);
    pcl::SegmentDifferences<pcl::PointXYZ> differences;
    differences.setInputCloud(rivals.scan);
    differences.setTargetCloud(rivals.map);
    differences.setSearchMethod(tree);
    differences.setDistanceThreshold(reach * reach);
    Cloud kept;
    for (auto _ : state) differences.segment(kept);
    report(state, rivals, kept.size());
}

void octreeChangeDetection(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Rivals rivals(scanner);
    pcl::octree::OctreePointCloudChangeDetector<pcl::PointXYZ> octree(reach);
    octree.setInputCloud(rivals.map);
    octree.addPointsFromInputCloud();
    octree.switchBuffers();
    octree.setInputCloud(rivals.scan);
    pcl::Indices kept;
    for (auto _ : state) {
        kept.clear();
        octree.addPointsFromInputCloud();
        octree.getPointIndicesFromNewVoxels(kept);
        benchmark::DoNotOptimize(kept.data());
        octree.deleteCurrentBuffer();
    }
    report(state, rivals, kept.size());
}

void voxelLookUp(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Rivals rivals(scanner);
    pcl::VoxelGrid<pcl::PointXYZ> voxels;
    voxels.setLeafSize(reach, reach, reach);
    voxels.setSaveLeafLayout(true);
    voxels.setInputCloud(rivals.map);
    Cloud centres;
    voxels.filter(centres);
    size_t kept = 0;
    for (auto _ : state) {
        kept = 0;
        for (const auto& point : *rivals.scan) {
            const auto voxel = voxels.getGridCoordinates(point.x, point.y, point.z);
            kept += voxels.getCentroidIndexAt(voxel) == -1;
        }
        benchmark::DoNotOptimize(kept);
    }
    report(state, rivals, kept);
}

void streamingPass(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Rivals rivals(scanner);
    size_t kept = 0;
    for (auto _ : state) {
        kept = 0;
        for (const auto& p : rivals.office.scan.points) {
            kept += p.x * p.x + p.y * p.y + p.z * p.z > 4;
        }
        benchmark::DoNotOptimize(kept);
    }
    report(state, rivals, kept);
}

const bool registered = [] {
    for (const auto& [scanner, size] : {std::pair(evaluation::paperScanner(), "181x181"),
                                        std::pair(evaluation::dense(), "128x2048")}) {
        for (const auto& [rival, name] :
             {std::pair(&kdTreeDistance, "kdTreeDistance"),
              std::pair(&segmentDifferences, "segmentDifferences"),
              std::pair(&octreeChangeDetection, "octreeChangeDetection"),
              std::pair(&voxelLookUp, "voxelLookUp"), std::pair(&streamingPass, "streamingPass")}) {
            benchmark::RegisterBenchmark((std::string("rivals/") + name + "/" + size).c_str(),
                                         rival, scanner)
                ->Unit(benchmark::kMicrosecond);
        }
    }
    return true;
}();

}  // namespace

}  // namespace offmap::core
