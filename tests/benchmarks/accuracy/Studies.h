// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pool.h"

#include <string>
#include <vector>

namespace offmap::accuracy {

/// Conditions that differ in one thing, and what the methods made of them.
struct Study {
    std::vector<Condition> conditions;
    std::vector<Pools> pools;  ///< one per condition, once run

    const Pools& at(const std::string& condition) const;  ///< \throw std::out_of_range
    Pools pooled() const { return poolOf(pools); }
};

/// All that is asked of one scanner, in random scenes.
struct ScannerStudies {
    std::string scanner;
    std::vector<int> distances;  ///< [cm] before a wall, those of the stand-off studies
    Study cells;                 ///< noise of the localisation, one level each
    Study standOffs;             ///< all objects at one distance before a wall, at the middle level
    Study standOffsMixed;        ///< the same, over all levels
    Study lies;       ///< stated standard deviations too small or too large, middle level
    Study liesMixed;  ///< the same, over all levels
    Study blunders;   ///< wrong poses with a small covariance stated
};

struct Studies {
    std::vector<ScannerStudies> scanners;
    Study corridors;  ///< the paper's, and a bare one
};

inline const std::string paperCorridor = "the paper's corridor", bareCorridor = "bare corridor";

/// How much is run.
struct Extent {
    size_t scans = 60;  ///< per condition; a multiple of the noise levels runs each equally often
    uint64_t seed = 1;
    bool quick = false;  ///< corner cells and the middle one, few other conditions
    unsigned threads = 1;
};

/// Runs everything. The instruments must outlive the result.
Studies runStudies(const std::vector<Instrument>& instruments, const Extent& extent);

/// A level of localisation noise, as "1 deg, 3 cm".
struct NoiseLevel {
    double headingDegrees;
    int positionCentimetres;

    std::string name() const;
    Localisation localisation() const;
};

/// The levels that are run, by heading, then by position.
std::vector<NoiseLevel> noiseLevels(bool quick);

inline constexpr NoiseLevel middleLevel{1, 3};

}  // namespace offmap::accuracy
