// SPDX-License-Identifier: BSD-3-Clause
// How accurate the methods are, in simulated scans: tables, the data of the figures, and a check.
#include "Curves.h"
#include "Report.h"
#include "Tables.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace {

using namespace offmap::accuracy;

struct Options {
    Extent extent{.threads = std::max(1U, std::thread::hardware_concurrency())};
    std::string date = "undated";
    std::string folder;
    bool check = false;
    size_t worst = 0;
};

void addTo(CLI::App& app, Options& options) {
    app.add_option("--scans", options.extent.scans,
                   "scans per noise level, and per other condition")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--seed", options.extent.seed, "of all that is random")->capture_default_str();
    app.add_option("--threads", options.extent.threads, "the result does not depend on them")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_flag("--quick", options.extent.quick, "five noise levels, few other conditions");
    app.add_flag("--check", options.check, "fail if a bound is not met");
    app.add_option("--worst", options.worst, "show so many of the worst scans of `aligned`");
    app.add_option("-o", options.folder, "folder to write the report to, and what is drawn");
    app.add_option("--date", options.date, "that the report bears, YYYY-MM-DD");
}

void write(const Studies& studies, const Options& options) {
    const std::filesystem::path folder = options.folder;
    const std::string name = "accuracy-" + options.date;
    std::filesystem::create_directories(folder / name);
    writeCurves(studies, folder / name);
    std::ofstream report(folder / (name + ".md"));
    report << reportOf(studies, options.extent, options.date);
    if (!report.flush()) throw std::runtime_error("cannot write to " + folder.string());
}

int run(const Options& options) {
    const auto instrumentsUsed = instruments();
    const Studies studies = runStudies(instrumentsUsed, options.extent);
    if (!options.folder.empty()) write(studies, options);
    for (const ScannerStudies& of : studies.scanners) {
        if (options.worst == 0) break;
        std::cout << of.scanner << "\n\n"
                  << worstTable(of.cells.pooled()[alignedMethod], options.worst) << '\n';
    }
    const auto bounds = boundsOf(studies, options.extent);
    std::cout << tableOf(bounds);
    const auto missed = std::count_if(bounds.begin(), bounds.end(),
                                      [](const Bound& bound) { return !bound.met(); });
    std::cout << fmt::format("\n{} of {} bounds met\n", bounds.size() - size_t(missed),
                             bounds.size());
    return options.check && missed > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Accuracy of offmap's methods in simulated scans"};
    Options options;
    addTo(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::cerr << "offmap_accuracy: " << error.what() << '\n';
        return 2;
    }
}
