// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace offmap::accuracy {

namespace {

using evaluation::Score;

double rootMean(double squares, size_t count) {
    return count == 0 ? NAN : std::sqrt(squares / static_cast<double>(count));
}

/// Mapped on segments / all mapped / unmapped removed.
std::string threeFigures(const Pool& pool) {
    const Score& score = pool.score.total();
    return fmt::format("{} / {} / {}", percentOf(score.mappedOnSegments.removedShare()),
                       percentOf(score.mapped.removedShare()),
                       percentOf(score.unmapped.removedShare()));
}

std::string poseRow(const std::string& name, const PosePool& pose) {
    const auto centimetres = [&](const Eigen::Vector3d& squares) {
        return 100 * rootMean(squares[0] + squares[1], pose.scans);
    };
    const auto degrees = [&](const Eigen::Vector3d& squares) {
        return mrpt::RAD2DEG(rootMean(squares[2], pose.scans));
    };
    return fmt::format("| {} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.2f} | {:.1f} |\n", name,
                       centimetres(pose.squaresBefore), centimetres(pose.squaresAfter),
                       degrees(pose.squaresBefore), degrees(pose.squaresAfter),
                       pose.meanSquaredError(),
                       100.0 * double(pose.beyond95) / double(std::max<size_t>(pose.scans, 1)));
}

std::string thousands(double count) {
    const auto rounded = static_cast<long>(std::lround(count));
    return rounded < 1000 ? fmt::format("{}", rounded)
                          : fmt::format("{},{:03}", rounded / 1000, rounded % 1000);
}

}  // namespace

std::string percentOf(std::optional<double> share) {
    return share ? fmt::format("{:.2f}", 100 * *share) : "-";
}

std::string overallTable(const ScannerStudies& of) {
    const Pools pools = of.cells.pooled();
    std::string table =
        "| method | mapped on segments removed | all mapped removed (MR) | unmapped removed | "
        "unmapped kept (UP) | sqrt(MR UP) | unmapped removed, 95th percentile of scans | scans "
        "kept "
        "whole |\n|---|---|---|---|---|---|---|---|\n";
    for (size_t m = 0; m < methodCount; ++m) {
        const Score& score = pools[m].score.total();
        table += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} | {} |\n", nameOf(methods[m]),
            percentOf(score.mappedOnSegments.removedShare()),
            percentOf(score.mapped.removedShare()), percentOf(score.unmapped.removedShare()),
            percentOf(score.unmapped.keptShare()), percentOf(score.geometricMean()),
            percentOf(pools[m].score.unmappedRemoved(0.95)), percentOf(pools[m].keptWholeShare()));
    }
    return table;
}

std::string cellTable(const Study& cells) {
    std::string table = "| heading, position |";
    for (const auto method : methods) table += fmt::format(" {} |", nameOf(method));
    table += "\n|---|---|---|---|\n";
    for (size_t c = 0; c < cells.conditions.size(); ++c) {
        table += fmt::format("| {} |", cells.conditions[c].name);
        for (const Pool& pool : cells.pools[c]) table += fmt::format(" {} |", threeFigures(pool));
        table += '\n';
    }
    return table;
}

std::string standOffTable(const ScannerStudies& of) {
    std::string table = "| stand-off |";
    for (const char* levels : {"1 deg, 3 cm", "all levels"}) {
        for (const auto method : methods) table += fmt::format(" {}, {} |", nameOf(method), levels);
    }
    table += "\n|---|---|---|---|---|---|---|\n";
    for (size_t c = 0; c < of.distances.size(); ++c) {
        table += fmt::format("| {} cm |", of.distances[c]);
        for (const Study* study : {&of.standOffs, &of.standOffsMixed}) {
            for (const Pool& pool : study->pools[c]) {
                const auto count = pool.score.total().standingOff(of.distances[c], of.distances[c]);
                table += fmt::format(" {} |", percentOf(count.keptShare()));
            }
        }
        table += '\n';
    }
    return table;
}

std::string surfaceTable(const Pools& pools) {
    std::string table =
        "| method | walls not on the map | floor | ceiling | objects |\n|---|---|---|---|---|\n";
    for (size_t m = 0; m < methodCount; ++m) {
        table += fmt::format("| {} |", nameOf(methods[m]));
        for (const auto& count : pools[m].score.total().unmappedByKind) {
            table += fmt::format(" {} |", percentOf(count.removedShare()));
        }
        table += '\n';
    }
    return table;
}

std::string conditionTable(const Study& study) {
    std::string table =
        "| | aligned: mapped on segments / all mapped / unmapped removed | scans flagged | scans "
        "kept "
        "whole | paper |\n|---|---|---|---|---|\n";
    for (size_t c = 0; c < study.conditions.size(); ++c) {
        const Pool& aligned = study.pools[c][alignedMethod];
        table += fmt::format("| {} | {} | {} | {} | {} |\n", study.conditions[c].name,
                             threeFigures(aligned), percentOf(aligned.flaggedShare()),
                             percentOf(aligned.keptWholeShare()),
                             threeFigures(study.pools[c][paperMethod]));
    }
    return table;
}

std::string poseTable(const Study& cells) {
    std::string table =
        "| heading, position | position before [cm] | after [cm] | heading before [deg] | after "
        "[deg] "
        "| mean squared error, normalised | beyond 7.81 |\n|---|---|---|---|---|---|---|\n";
    for (size_t c = 0; c < cells.conditions.size(); ++c) {
        table += poseRow(cells.conditions[c].name, cells.pools[c][alignedMethod].pose);
    }
    return table + poseRow("all", cells.pooled()[alignedMethod].pose);
}

std::string paperCorridorTable(const Pools& pools) {
    std::string table =
        "| | points | on vertical segments | of these removed | unmapped removed |\n"
        "|---|---|---|---|---|\n| the paper | 32,761 | 12,300 | 11,700 (95.1 %) | not given |\n";
    for (size_t m = 0; m < methodCount; ++m) {
        const Pool& pool = pools[m];
        const auto scans = static_cast<double>(std::max<size_t>(pool.score.scans(), 1));
        const double onSegments = double(pool.onSegments), removed = double(pool.removedOnSegments);
        table += fmt::format("| {} | {} | {} | {} ({:.1f} %) | {} % |\n", nameOf(methods[m]),
                             thousands(double(pool.points) / scans), thousands(onSegments / scans),
                             thousands(removed / scans), 100 * removed / onSegments,
                             percentOf(pool.score.total().unmapped.removedShare()));
    }
    return table;
}

std::string bareCorridorTable(const Pool& aligned) {
    const PosePool& pose = aligned.pose;
    std::string table =
        "| | stated [cm] | error before [cm] | error after [cm] | deviation stated after [cm] |\n"
        "|---|---|---|---|---|\n";
    for (const auto& [name, axis] : {std::pair("along", 0), std::pair("across", 1)}) {
        table += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", name,
                             100 * rootMean(pose.statedVariances[axis], pose.scans),
                             100 * rootMean(pose.squaresBefore[axis], pose.scans),
                             100 * rootMean(pose.squaresAfter[axis], pose.scans),
                             100 * rootMean(pose.variances[axis], pose.scans));
    }
    return table;
}

std::string worstTable(const Pool& pool, size_t rows) {
    auto scans = pool.scans;
    rows = std::min(rows, scans.size());
    std::string table =
        "| | seed | mapped on segments removed | unmapped removed | squared error, normalised | "
        "flagged "
        "|\n|---|---|---|---|---|---|\n";
    const auto addFirst = [&](const auto& byBadness) {
        std::stable_sort(scans.begin(), scans.end(), byBadness);
        for (size_t i = 0; i < rows; ++i) {
            const ScanFigures& scan = scans[i];
            table += fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.1f} | {} |\n", scan.condition,
                                 scan.seed, 100 * scan.mappedRemoved, 100 * scan.unmappedRemoved,
                                 scan.squaredError, scan.flagged ? "yes" : "no");
        }
    };
    addFirst([](const ScanFigures& a, const ScanFigures& b) {
        return a.mappedRemoved < b.mappedRemoved;
    });
    addFirst([](const ScanFigures& a, const ScanFigures& b) {
        return a.unmappedRemoved > b.unmappedRemoved;
    });
    return table;
}

}  // namespace offmap::accuracy
