// SPDX-License-Identifier: BSD-3-Clause
// What the next stage gains if it is given reduced scans: Euclidean clustering of full and of
// reduced clouds, its time and its clusters, as Markdown.
#include "Trial.h"

#include <offmap/evaluation/NamedScenes.h>
#include <offmap/rawlog/ConfigFile.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <string>
#include <string_view>

namespace offmap::profit {

namespace {

constexpr uint64_t randomScenes = 20, firstSeed = 9000;

std::vector<Instrument> instruments() {
    rawlog::Config vlp16;
    rawlog::applyYaml(vlp16, OFFMAP_SOURCE_DIR "/config/vlp16.yaml");
    std::vector<Instrument> all{{"paper", evaluation::paperScanner(), {}, 0.2F},
                                {"VLP-16", evaluation::vlp16(), vlp16.reduction, 0.3F},
                                {"128 x 2048", evaluation::dense(), {}, 0.1F}};
    for (Instrument& one : all) one.config.matching.method = core::MatchingMethod::Aligned;
    return all;
}

std::string ratio(double part, double whole) {
    return whole > 0 ? fmt::format("{:.0f} %", 100 * part / whole) : "-";
}

void print(const std::string& scanner, const std::string& scene, const Profit& sum) {
    const auto scans = static_cast<double>(sum.scans);
    const auto mean = [&](auto total) { return static_cast<double>(total) / scans; };
    const double after = sum.reduced.milliseconds + sum.reductionMilliseconds;
    fmt::print(
        "| {} | {} | {:.0f} | {:.0f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f}"
        " | {:.1f} | {} |\n",
        scanner, scene, mean(sum.full.points), mean(sum.reduced.points), mean(sum.objects),
        mean(sum.full.objectsFound), mean(sum.reduced.objectsFound), mean(sum.full.clusters),
        mean(sum.reduced.clusters), mean(sum.full.milliseconds), mean(sum.reduced.milliseconds),
        mean(sum.reductionMilliseconds),
        ratio(sum.full.milliseconds - after, sum.full.milliseconds));
    static_cast<void>(std::fflush(stdout));
}

void printIntroduction() {
    fmt::print(
        "# Profit for the next stage, {:%Y-%m-%d}\n\n"
        "`./dev bench profit` made this table. Object detection often begins with Euclidean\n"
        "clustering. Here it is given whole scans, and what method `aligned` leaves of them.\n"
        "Range noise {} m; the pose is off by, and stated with, sigmas of {} m and {} degrees.\n"
        "All figures are means of the scans, those of the random scenes of {}; times are of one\n"
        "processor core, the fastest of three runs.\n\n"
        "- Clustering: points nearer than 0.2 m (paper), 0.3 m (VLP-16), 0.1 m (128 x 2048)\n"
        "  belong together, {} are a cluster. Points within {} m of floor and ceiling are\n"
        "  dropped first, of both clouds.\n"
        "- Objects: surfaces that are not on the map, with points enough for a cluster. Each\n"
        "  counts by itself: the posts of a fence, the twigs of a bush.\n"
        "- Found: one cluster has most of the object's points, and they are most of its points.\n"
        "- Saved: of the time of clustering whole scans, what reduction and clustering together\n"
        "  take less; negative: they take more.\n\n",
        fmt::localtime(std::time(nullptr)), sigmaRange, sigmaPosition, sigmaHeadingDegrees,
        randomScenes, minPoints, floorMargin);
    fmt::print(
        "| scanner | scene | points | reduced | objects | found | found, reduced | clusters "
        "| clusters, reduced | ms | ms, reduced | ms to reduce | saved |\n"
        "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
}

void run() {
    printIntroduction();
    for (const Instrument& instrument : instruments()) {
        for (const std::string_view name : evaluation::sceneNames()) {
            if (name.starts_with("random_")) continue;
            print(instrument.name, std::string(name),
                  profitOf(*evaluation::sceneNamed(name, 0), instrument, firstSeed));
        }
        Profit sum;
        for (uint64_t seed = firstSeed; seed < firstSeed + randomScenes; ++seed) {
            sum.add(profitOf(evaluation::randomScene(seed), instrument, seed));
        }
        print(instrument.name, "random scenes", sum);
    }
}

}  // namespace

}  // namespace offmap::profit

int main() {
    try {
        offmap::profit::run();
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "offmap_profit: {}\n", error.what());
        return 1;
    }
}
