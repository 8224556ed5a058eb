// SPDX-License-Identifier: BSD-3-Clause
#include "Studies.h"

#include <offmap/evaluation/SampleWorlds.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <stdexcept>

namespace offmap::accuracy {

namespace {

using evaluation::Scene;

Scene anyScene(uint64_t seed) { return evaluation::randomScene(seed); }

std::vector<Localisation> allLevels(bool quick) {
    std::vector<Localisation> localisations;
    for (const NoiseLevel& level : noiseLevels(quick)) {
        localisations.push_back(level.localisation());
    }
    return localisations;
}

std::vector<int> distancesOf(bool quick) {
    if (quick) return {10, 20};
    return {3, 5, 7, 10, 15, 20, 30, 50};
}

Study cells(const Instrument& instrument, bool quick) {
    Study study;
    for (const NoiseLevel& level : noiseLevels(quick)) {
        study.conditions.push_back({level.name(), &instrument, anyScene, {level.localisation()}});
    }
    return study;
}

Study standOffs(const Instrument& instrument, const std::vector<int>& distances,
                const std::vector<Localisation>& localisations) {
    Study study;
    for (const int centimetres : distances) {
        const auto scene = [centimetres](uint64_t seed) {
            return evaluation::randomScene(seed, {.standOffs = {0.01 * centimetres}});
        };
        study.conditions.push_back(
            {fmt::format("{} cm", centimetres), &instrument, scene, localisations});
    }
    return study;
}

Study lies(const Instrument& instrument, const std::vector<Localisation>& honest) {
    Study study;
    for (const double stated : {0.25, 0.5, 2.0, 4.0}) {
        Condition condition{fmt::format("x{}", stated), &instrument, anyScene, honest};
        for (Localisation& localisation : condition.localisations) localisation.stated = stated;
        study.conditions.push_back(condition);
    }
    return study;
}

Study blunders(const Instrument& instrument) {
    const Localisation small{mrpt::DEG2RAD(0.5), 0.03};
    Study study;
    const auto add = [&](const std::string& name, const Localisation& localisation) {
        study.conditions.push_back({name, &instrument, anyScene, {localisation}});
    };
    const auto blunder = [&](double shift, double turn) {
        Localisation localisation = small;
        localisation.blunder = {shift, turn};
        return localisation;
    };
    add("right", small);
    add("0.5 m", blunder(0.5, 0));
    add("10 deg", blunder(0, mrpt::DEG2RAD(10.0)));
    add("2 m", blunder(2, 0));
    Localisation kidnapped = small;
    kidnapped.kidnapped = true;
    add("kidnapped", kidnapped);
    return study;
}

Scene paperCorridorScene() {
    Scene scene{evaluation::corridor(), {}};
    scene.sensor.sensorInMap.setFromValues(4, 0, 0.6);
    return scene;
}

/// With a person, so that there is something to be kept besides floor and ceiling.
Scene bareCorridorScene() {
    Scene scene{evaluation::bareCorridor(), {}};
    scene.world.addObject(evaluation::personAt({3, 0.4}));
    scene.sensor.sensorInMap.setFromValues(0, 0, 0.6);
    return scene;
}

Study corridors(const Instrument& instrument) {
    const std::vector localisations{middleLevel.localisation()};
    Study study;
    study.conditions = {
        {paperCorridor, &instrument, [](uint64_t) { return paperCorridorScene(); }, localisations},
        {bareCorridor, &instrument, [](uint64_t) { return bareCorridorScene(); }, localisations}};
    return study;
}

/// The studies of all scanners and the corridors.
std::vector<Study*> partsOf(Studies& studies) {
    std::vector<Study*> parts{&studies.corridors};
    for (ScannerStudies& of : studies.scanners) {
        for (Study* study : {&of.cells, &of.standOffs, &of.standOffsMixed, &of.lies, &of.liesMixed,
                             &of.blunders}) {
            parts.push_back(study);
        }
    }
    return parts;
}

}  // namespace

const Pools& Study::at(const std::string& condition) const {
    for (size_t c = 0; c < conditions.size(); ++c) {
        if (conditions[c].name == condition) return pools.at(c);
    }
    throw std::out_of_range("no condition '" + condition + "' was run");
}

Studies runStudies(const std::vector<Instrument>& instruments, const Extent& extent) {
    Studies studies;
    const std::vector middle{middleLevel.localisation()};
    const auto all = allLevels(extent.quick);
    const auto distances = distancesOf(extent.quick);
    for (const Instrument& instrument : instruments) {
        studies.scanners.push_back({instrument.name, distances, cells(instrument, extent.quick),
                                    standOffs(instrument, distances, middle),
                                    standOffs(instrument, distances, all), lies(instrument, middle),
                                    lies(instrument, all), blunders(instrument)});
    }
    studies.corridors = corridors(instruments.front());

    std::vector<const Condition*> conditions;
    for (const Study* study : partsOf(studies)) {
        for (const Condition& condition : study->conditions) conditions.push_back(&condition);
    }
    const auto pools = run(conditions, extent.scans, extent.seed, extent.threads);
    auto next = pools.begin();
    for (Study* study : partsOf(studies)) {
        const auto end = next + static_cast<std::ptrdiff_t>(study->conditions.size());
        study->pools.assign(next, end);
        next = end;
    }
    return studies;
}

std::string NoiseLevel::name() const {
    return fmt::format("{} deg, {} cm", headingDegrees, positionCentimetres);
}

Localisation NoiseLevel::localisation() const {
    return {mrpt::DEG2RAD(headingDegrees), 0.01 * positionCentimetres};
}

std::vector<NoiseLevel> noiseLevels(bool quick) {
    if (quick) return {{0.2, 1}, {0.2, 10}, middleLevel, {5, 1}, {5, 10}};
    std::vector<NoiseLevel> levels;
    for (const double heading : {0.2, 0.5, 1.0, 2.0, 5.0}) {
        for (const int position : {1, 3, 5, 10}) levels.push_back({heading, position});
    }
    return levels;
}

}  // namespace offmap::accuracy
