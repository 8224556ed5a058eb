// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Tables.h"

#include <fmt/format.h>

namespace offmap::accuracy {

namespace {

constexpr auto opening = R"(# Accuracy, {date}

Made by `./dev bench accuracy {quick}--scans {scans} --seed {seed}`, compiled with GCC {compiler}: {scans} scans
of fresh scenes per noise level and per other condition, seed {seed}. The scenes are random rooms,
corridors and corners with people and boxes before the walls, open doors and small rooms behind
them. Ranges are noisy by 2 cm, the map's walls are drawn 1 cm off, the scanner leans by up to 2 degrees
in any direction; the pose's error is drawn from the stated covariance unless said otherwise. Scores are
by the truth of every point, pooled by points, in percent. A point is *mapped* if the map shows the
surface that it truly comes from; *on segments* if it lies on a vertical segment, what the paper counts.
The scanners are the paper's (181 x 181 beams, default parameters) and a VLP-16 (parameters of
`config/vlp16.yaml`).
)";

std::string scannerSections(const ScannerStudies& of, size_t index, const std::string& figures) {
    std::string text = fmt::format("\n## {}\n\nAll noise levels:\n\n", of.scanner);
    text += overallTable(of);
    text += fmt::format(
        "\n![removal over the noise of the localisation]({0}/removal-{1}.svg)\n\n"
        "Each level of localisation noise (heading, position), as mapped on segments / all mapped "
        "/ "
        "unmapped removed:\n\n",
        figures, index);
    text += cellTable(of.cells);
    text += "\nUnmapped points removed, by what they come from, all levels:\n\n";
    text += surfaceTable(of.cells.pooled());
    text += fmt::format(
        "\nPoints kept of objects that stand so far before a wall:\n\n"
        "![points kept over the distance before a wall]({}/stand_off-{}.svg)\n\n",
        figures, index);
    text += standOffTable(of);
    text += "\nStated standard deviations that are not the true ones, at 1 deg, 3 cm:\n\n";
    text += conditionTable(of.lies);
    text +=
        "\nThe same over all levels. `paper` makes no use of what exceeds "
        "`matching.max_heading_error_deg` "
        "or `matching.max_position_radius_m`:\n\n";
    text += conditionTable(of.liesMixed);
    text += "\nPoses that are wrong by far more than the 0.5 deg and 3 cm that they state:\n\n";
    text += conditionTable(of.blunders);
    text +=
        "\nThe pose after it was conditioned on the scan, RMS. The squared error of the pose, "
        "normalised "
        "by its covariance, has a mean of 3 and exceeds 7.81 in 5 % of the scans if the covariance "
        "is "
        "honest:\n\n";
    return text + poseTable(of.cells);
}

}  // namespace

std::string tableOf(const std::vector<Bound>& bounds) {
    std::string table = "| figure | measured | bound | |\n|---|---|---|---|\n";
    for (const Bound& bound : bounds) {
        table += fmt::format("| {} | {:.2f}{} | {} {:.2f} | {} |\n", bound.what, bound.measured,
                             bound.unit, bound.atMost ? "<=" : ">=", bound.limit,
                             bound.met() ? "met" : "**missed**");
    }
    return table;
}

std::string reportOf(const Studies& studies, const Extent& extent, const std::string& date) {
    std::string text = fmt::format(opening, fmt::arg("date", date),
                                   fmt::arg("quick", extent.quick ? "--quick " : ""),
                                   fmt::arg("scans", extent.scans), fmt::arg("seed", extent.seed),
                                   fmt::arg("compiler", __VERSION__));
    for (size_t i = 0; i < studies.scanners.size(); ++i) {
        text += scannerSections(studies.scanners[i], i, "accuracy-" + date);
    }
    text +=
        "\n## The paper's corridor\n\nA corridor like that of the paper's section 4.1, mean per "
        "scan:\n\n";
    text += paperCorridorTable(studies.corridors.at(paperCorridor));
    const Pool& bare = studies.corridors.at(bareCorridor)[alignedMethod];
    text +=
        "\n## A bare corridor\n\nLonger than the scanner sees: nothing tells where along it the "
        "scan "
        "was taken. Method `aligned`:\n\n";
    text += bareCorridorTable(bare);
    const evaluation::Score& score = bare.score.total();
    text += fmt::format(
        "\nMapped removed: {} % on segments, {} % of all; unmapped removed: {} %.\n",
        percentOf(score.mappedOnSegments.removedShare()), percentOf(score.mapped.removedShare()),
        percentOf(score.unmapped.removedShare()));
    return text + "\n## Bounds\n\n" + tableOf(boundsOf(studies, extent));
}

}  // namespace offmap::accuracy
