// SPDX-License-Identifier: BSD-3-Clause
#include "Office.h"

#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/TurnReducer.h>

#include <benchmark/benchmark.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace offmap::rawlog {

namespace {

enum class Order : uint8_t { ByColumn, ByRing, Shuffled };

/// The rings from top to bottom, as drivers of some scanners store a turn. \pre all columns have as
/// many returns
std::vector<mrpt::math::TPoint3Df> byRing(const core::OrganizedScan& scan) {
    std::vector<mrpt::math::TPoint3Df> points;
    for (size_t ring = scan.column(0).size(); ring-- > 0;) {
        for (size_t c = 0; c < scan.columns.size(); ++c) points.push_back(scan.column(c)[ring]);
    }
    return points;
}

/// The office as a cloud of 262,144 points.
struct OfficeCloud {
    explicit OfficeCloud(Order order) : office(evaluation::dense()) {
        auto points = office.scan.points;
        if (order == Order::ByRing) points = byRing(office.scan);
        if (order == Order::Shuffled) std::shuffle(points.begin(), points.end(), std::mt19937(1));
        auto map = std::make_shared<mrpt::maps::CPointsMapXYZI>();
        for (const auto& p : points) map->insertPointFast(p.x, p.y, p.z);
        auto observation = std::make_shared<mrpt::obs::CObservationPointCloud>();
        observation->pointcloud = map;
        turn = {observation};
    }
    /// The sensor's own.
    FixedPose pose() const {
        mrpt::poses::CPose3DPDFGaussian sensorInMap(office.pose.sensorInMap);
        const Eigen::Matrix3d& ground = office.pose.groundCovariance;  // x, y, yaw
        for (int row = 0; row < 3; ++row) {
            const int at[] = {0, 1, 3};
            sensorInMap.cov(at[row], at[row]) = ground(row, row);
        }
        return FixedPose(sensorInMap);
    }
    test::Office office;
    Turn turn;
};

/// What totals.reduce_ms_median counts: from observation to observation.
void reduceCloud(benchmark::State& state, Order order, core::MatchingMethod method) {
    const OfficeCloud cloud(order);
    const FixedPose pose = cloud.pose();
    Config config;
    config.reduction.matching.method = method;
    TurnReducer reducer(cloud.office.map, pose, config, OutputClass::Same);
    const PointCloudScan scanClass;
    for (auto _ : state) {
        benchmark::DoNotOptimize(reducer.reduce(cloud.turn, scanClass).reduced.data());
    }
}

void organizeCloud(benchmark::State& state, Order order) {
    const OfficeCloud cloud(order);
    const FixedPose pose = cloud.pose();
    const PointCloudScan scanClass;
    for (auto _ : state) {
        benchmark::DoNotOptimize(scanClass.organize(cloud.turn, pose, {}).scan.points.data());
    }
}

/// A copy without every second stretch of 64 points.
void takeOutOfCloud(benchmark::State& state) {
    const OfficeCloud cloud(Order::ByColumn);
    std::vector<uint8_t> keep(cloud.office.scan.points.size());
    for (size_t i = 0; i < keep.size(); ++i) keep[i] = i / 64 % 2;
    const PointCloudScan scanClass;
    for (auto _ : state) benchmark::DoNotOptimize(scanClass.withOnly(*cloud.turn.front(), keep));
}

const bool registered = [] {
    const auto add = [](const std::string& name, auto&& run, auto... with) {
        benchmark::RegisterBenchmark((name + "/128x2048").c_str(), run, with...)
            ->Unit(benchmark::kMicrosecond);
    };
    for (const auto& [order, called] :
         {std::pair(Order::ByColumn, ""), std::pair(Order::ByRing, "rings/"),
          std::pair(Order::Shuffled, "shuffled/")}) {
        add(std::string("cloud/") + called + "paper", reduceCloud, order,
            core::MatchingMethod::Paper);
        add(std::string("cloud/") + called + "aligned", reduceCloud, order,
            core::MatchingMethod::Aligned);
        add(std::string("cloud/") + called + "organize", organizeCloud, order);
    }
    add("cloud/takeOut", takeOutOfCloud);
    return true;
}();

}  // namespace

}  // namespace offmap::rawlog
