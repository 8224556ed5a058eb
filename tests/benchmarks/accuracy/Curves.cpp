// SPDX-License-Identifier: BSD-3-Clause
#include "Curves.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace offmap::accuracy {

namespace {

double percent(std::optional<double> share) { return 100 * share.value_or(NAN); }

/// Levels of one heading follow each other; an empty line, where a curve breaks, before the next.
std::string removalOverNoise(const Study& cells) {
    std::string rows;
    double heading = -1;
    for (size_t c = 0; c < cells.conditions.size(); ++c) {
        const Localisation& noise = cells.conditions[c].localisations.front();
        if (c > 0 && noise.sigmaHeading != heading) rows += '\n';
        heading = noise.sigmaHeading;
        rows += fmt::format("{}\t{}", c, cells.conditions[c].name);
        for (const Pool& pool : cells.pools[c]) {
            const evaluation::Score& score = pool.score.total();
            rows += fmt::format("\t{:.4f}\t{:.4f}", percent(score.mapped.removedShare()),
                                percent(score.unmapped.removedShare()));
        }
        rows += '\n';
    }
    return rows;
}

std::string keptOverStandOff(const ScannerStudies& of) {
    std::string rows;
    for (size_t c = 0; c < of.distances.size(); ++c) {
        rows += fmt::format("{}", of.distances[c]);
        for (const Study* study : {&of.standOffs, &of.standOffsMixed}) {
            for (const Pool& pool : study->pools[c]) {
                const auto count = pool.score.total().standingOff(of.distances[c], of.distances[c]);
                rows += fmt::format("\t{:.4f}", percent(count.keptShare()));
            }
        }
        rows += '\n';
    }
    return rows;
}

void write(const std::filesystem::path& path, const std::string& rows) {
    std::ofstream file(path);
    file << rows;
    if (!file.flush()) throw std::runtime_error("cannot write to " + path.string());
}

}  // namespace

void writeCurves(const Studies& studies, const std::filesystem::path& folder) {
    for (size_t i = 0; i < studies.scanners.size(); ++i) {
        write(folder / fmt::format("removal-{}.tsv", i),
              removalOverNoise(studies.scanners[i].cells));
        write(folder / fmt::format("stand_off-{}.tsv", i), keptOverStandOff(studies.scanners[i]));
    }
}

}  // namespace offmap::accuracy
