// SPDX-License-Identifier: BSD-3-Clause
#include "SimulationPlan.h"

#include "input/NumberList.h"
#include "input/UsageError.h"

#include <offmap/evaluation/Disturbances.h>
#include <offmap/evaluation/Drive.h>
#include <offmap/evaluation/NamedScenes.h>
#include <offmap/evaluation/UniformNumbers.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

#include <numbers>

namespace offmap::app {

namespace {

struct NamedClass {
    std::string_view name;
    Encoder encoder;
    bool timesColumns;  ///< tells the time of each column, which a pose is looked up for
};

constexpr NamedClass classes[] = {
    {"pointcloud", encodeCloud, false},      {"velodyne", encodeVelodyne, true},
    {"rotating", encodeRotating, true},      {"sweep", encodeSweep, true},
    {"rangeimage", encodeRangeImage, false},
};

const NamedClass& classNamed(std::string_view name) {
    for (const NamedClass& one : classes) {
        if (one.name == name) return one;
    }
    throw UsageError(fmt::format("there is no class '{}' of observations", name));
}

evaluation::Scanner scannerOf(const SimulateOptions& options) {
    const std::string &name = options.scanner, &scanClass = options.scanClass;
    if (scanClass == "velodyne") {
        if (name.empty() || name == "vlp16") return evaluation::vlp16Firings();
        throw UsageError("--class velodyne writes packets of a VLP-16: leave out --scanner " +
                         name);
    }
    if (scanClass == "rangeimage") {
        if (name.empty()) return evaluation::depthCamera();
        throw UsageError("--class rangeimage is of a depth camera: leave out --scanner " + name);
    }
    if (name == "vlp16") return evaluation::vlp16();
    if (name == "dense") return evaluation::dense();
    return evaluation::paperScanner();
}

evaluation::Scene sceneOf(const SimulateOptions& options) {
    auto scene = evaluation::sceneNamed(options.world, options.seed);
    if (scene) return *std::move(scene);
    throw UsageError(fmt::format("there is no world '{}', only: {}", options.world,
                                 fmt::join(evaluation::sceneNames(), ", ")));
}

evaluation::Motion motionOf(const SimulateOptions& options) {
    const evaluation::Motion motion{options.speed, mrpt::DEG2RAD(options.yawRateDegrees)};
    if (!options.noCompensation) return motion;
    if (motion.isNone()) {
        throw UsageError(
            "--no-compensation needs a robot that moves while it scans: add --speed or --yaw-rate");
    }
    if (options.scanClass == "rangeimage") {
        throw UsageError(
            "--no-compensation is not for --class rangeimage: an image is taken at once");
    }
    return motion;
}

void setPoseSigmas(SimulationPlan& plan, const SimulateOptions& options) {
    const auto sigmas = parseNumbers(options.poseSigma, "--pose-sigma", "m,deg");
    if (sigmas[0] < 0 || sigmas[0] > 10 || sigmas[1] < 0 || sigmas[1] > 90) {
        throw UsageError(fmt::format("--pose-sigma is '{}', but must be 0 to 10 m, 0 to 90 degrees",
                                     options.poseSigma));
    }
    plan.sigmaPosition = sigmas[0];
    plan.sigmaHeading = mrpt::DEG2RAD(sigmas[1]);
    plan.statedFactor = options.statedFactor;
}

void placeSensor(SimulationPlan& plan, const SimulateOptions& options) {
    plan.sensor.label = options.scanClass == "rangeimage" ? "CAMERA" : "LIDAR";
    plan.sensor.mounting = {0, 0, plan.scene.sensor.sensorInMap.z(), 0, 0, 0};
    const double towards = evaluation::UniformNumbers(seedOf(plan.seed, Draw::Tilt))
                               .between(-std::numbers::pi, std::numbers::pi);
    plan.mounting = evaluation::tilted({.sensorInMap = plan.sensor.mounting},
                                       mrpt::DEG2RAD(options.tiltDegrees), towards)
                        .sensorInMap;
}

void drive(SimulationPlan& plan, const SimulateOptions& options) {
    const auto& start = plan.scene.sensor.sensorInMap;
    evaluation::DrivePlan way{{start.x(), start.y(), start.yaw()}, options.scans};
    way.whileScanning = plan.motion;
    way.scanDuration = plan.sensor.scanner.turnDuration;
    try {
        plan.places =
            evaluation::placesOnDrive(plan.scene.world, way, seedOf(plan.seed, Draw::Drive));
    } catch (const std::runtime_error&) {
        throw UsageError(fmt::format(
            "{} has no room for a robot that drives {:.1f} m during a scan of {} s; lower --speed",
            options.world, plan.motion.speed * way.scanDuration, way.scanDuration));
    }
}

}  // namespace

uint64_t seedOf(uint64_t seed, Draw draw, uint64_t index) {
    // SplitMix64: neighbouring seeds give unrelated ones
    uint64_t state = seed;
    for (const uint64_t more : {static_cast<uint64_t>(draw) + 1, index + 1}) {
        state += more * 0x9e3779b97f4a7c15;
        state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9;
        state = (state ^ (state >> 27)) * 0x94d049bb133111eb;
        state ^= state >> 31;
    }
    return state;
}

SimulationPlan planOf(const SimulateOptions& options) {
    const NamedClass& scanClass = classNamed(options.scanClass);
    SimulationPlan plan;
    plan.seed = options.seed;
    plan.sensor.scanner = scannerOf(options);
    plan.encoder = scanClass.encoder;
    plan.motion = motionOf(options);
    plan.posesFollow = !options.noCompensation || !scanClass.timesColumns;
    plan.sensor.compensated = !options.noCompensation;
    plan.noise.range = options.rangeNoise;
    plan.noise.angle = mrpt::DEG2RAD(options.angleNoiseDegrees);
    if (options.mixedPixels) plan.noise.beamWidth = 3e-3;  // [rad] a Velodyne's
    setPoseSigmas(plan, options);
    plan.scene = sceneOf(options);
    evaluation::GaussianNoise mapNoise(seedOf(plan.seed, Draw::Map));
    plan.map = evaluation::withMapError(mapOf(plan.scene.world), options.mapError, mapNoise);
    placeSensor(plan, options);
    drive(plan, options);
    return plan;
}

}  // namespace offmap::app
