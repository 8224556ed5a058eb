// SPDX-License-Identifier: BSD-3-Clause
#include "Trial.h"

#include "Clustering.h"

#include <offmap/core/Reducer.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <map>
#include <variant>

namespace offmap::profit {

namespace {

using evaluation::SurfaceKind;

/// Runs the work three times. \return [ms] of the processor that the fastest took
template <class Work>
double shortestTime(Work&& work) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const std::clock_t begin = std::clock();
        work();
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        shortest = std::min(shortest, 1e3 * seconds);
    }
    return shortest;
}

double ceilingOf(const evaluation::World& world) {
    for (const evaluation::Surface& surface : world.surfaces()) {
        if (surface.kind != SurfaceKind::Ceiling) continue;
        return std::get<evaluation::Plane>(surface.shape).z;
    }
    return std::numeric_limits<double>::infinity();
}

/// Points to be clustered, and the surfaces that they come from.
struct Cloud {
    std::vector<mrpt::math::TPoint3Df> points;
    std::vector<uint32_t> surfaces;
};

using PointCounts = std::map<uint32_t, size_t>;  // by surface

/// An object has a cluster of its own if most of its points are in it, and most of the cluster's
/// points are its own.
uint64_t countFound(const Cloud& cloud, const std::vector<Cluster>& clusters,
                    const PointCounts& objects) {
    uint64_t found = 0;
    for (const Cluster& cluster : clusters) {
        PointCounts held;
        for (const uint32_t i : cluster) ++held[cloud.surfaces[i]];
        found += static_cast<uint64_t>(std::ranges::count_if(held, [&](const auto& part) {
            const auto object = objects.find(part.first);
            return object != objects.end() && 2 * part.second > object->second &&
                   2 * part.second > cluster.size();
        }));
    }
    return found;
}

Clustered clustered(const Cloud& cloud, float tolerance, const PointCounts& objects) {
    std::vector<Cluster> clusters;
    Clustered out;
    out.milliseconds =
        shortestTime([&] { clusters = clustersOf(cloud.points, tolerance, minPoints); });
    out.points = cloud.points.size();
    out.clusters = clusters.size();
    out.objectsFound = countFound(cloud, clusters, objects);
    return out;
}

/// The points between floor and ceiling. \param labels none: all of them, else those that are kept
Cloud standing(const evaluation::SimulatedScan& simulated, const evaluation::Scene& scene,
               const std::vector<core::PointLabel>* labels) {
    const double sensorHeight = scene.sensor.sensorInMap.z();
    const double top = ceilingOf(scene.world) - floorMargin;
    Cloud cloud;
    for (size_t i = 0; i < simulated.scan.points.size(); ++i) {
        const auto& point = simulated.scan.points[i];
        const double z = point.z + sensorHeight;
        if (z < floorMargin || z > top || (labels && core::isRemoved((*labels)[i]))) continue;
        cloud.points.push_back(point);
        cloud.surfaces.push_back(simulated.truth[i].surface);
    }
    return cloud;
}

/// The points of each object that has enough of them.
PointCounts objectsIn(const Cloud& cloud, const evaluation::World& world) {
    PointCounts objects;
    for (const uint32_t surface : cloud.surfaces) {
        if (world.surfaces()[surface].kind == SurfaceKind::Object) ++objects[surface];
    }
    std::erase_if(objects, [](const auto& object) { return object.second < minPoints; });
    return objects;
}

core::SensorPose estimateOf(const core::SensorPose& truth, uint64_t seed) {
    const double heading = mrpt::DEG2RAD(sigmaHeadingDegrees);
    core::SensorPose uncertain = truth;
    uncertain.groundCovariance = Eigen::Vector3d(sigmaPosition * sigmaPosition,
                                                 sigmaPosition * sigmaPosition, heading * heading)
                                     .asDiagonal();
    evaluation::GaussianNoise noise(seed);
    return evaluation::drawEstimate(uncertain, noise);
}

}  // namespace

void Clustered::add(const Clustered& more) {
    points += more.points;
    clusters += more.clusters;
    objectsFound += more.objectsFound;
    milliseconds += more.milliseconds;
}

void Profit::add(const Profit& more) {
    scans += more.scans;
    objects += more.objects;
    full.add(more.full);
    reduced.add(more.reduced);
    reductionMilliseconds += more.reductionMilliseconds;
}

Profit profitOf(const evaluation::Scene& scene, const Instrument& instrument, uint64_t seed) {
    auto simulated = evaluation::simulate(scene.world, instrument.scanner, scene.sensor,
                                          {.range = sigmaRange}, seed);
    evaluation::setSensor(simulated.scan, estimateOf(scene.sensor, seed + 1));
    const core::LineMap map(mapOf(scene.world));
    core::Reducer reducer(map, instrument.config);
    const core::ReductionResult* result = nullptr;
    Profit out;
    out.scans = 1;
    out.reductionMilliseconds = shortestTime([&] { result = &reducer.reduce(simulated.scan); });
    const Cloud all = standing(simulated, scene, nullptr);
    const Cloud rest = standing(simulated, scene, &result->labels);
    const PointCounts objects = objectsIn(all, scene.world);
    out.objects = objects.size();
    out.full = clustered(all, instrument.tolerance, objects);
    out.reduced = clustered(rest, instrument.tolerance, objects);
    return out;
}

}  // namespace offmap::profit
