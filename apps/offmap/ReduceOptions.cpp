// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceOptions.h"

#include <algorithm>
#include <thread>

namespace offmap::app {

namespace {

constexpr const char* refined = "OFFMAP_POSE";

}  // namespace

void ReduceOptions::addTo(CLI::App& command) {
    command.add_option("IN", inputs, "Rawlogs to reduce; they are only read")
        ->required()
        ->type_name("FILE");
    command
        .add_option("-o,--out", output,
                    "Reduced rawlog; with several IN a folder, as the other outputs then are")
        ->required()
        ->type_name("OUT");
    shared.addTo(command);
    command.add_option("--removed", removed, "Rawlog of what was removed; with OUT it makes up IN")
        ->type_name("FILE");
    command.add_option("--report", report, "Figures in total and per scan")->type_name("FILE.json");
    command.add_option("--segments", segments, "What became of every vertical segment, and why")
        ->type_name("FILE.csv");
    command
        .add_option("--inspect", inspect,
                    "Rawlog of 3D pictures to turn and zoom in RawLogViewer, one per scan")
        ->type_name("FILE");
    command.add_option("--sensor", sensors, "Reduce this sensor only; may be repeated")
        ->type_name("LABEL")
        ->allow_extra_args(false);
    command
        .add_option("--output", outputClass,
                    "Class of reduced observations: their own, or CObservationPointCloud")
        ->check(CLI::IsMember({"same", "points"}).description(""))
        ->type_name("same|points");
    command
        .add_option_function<std::string>(
            "--write-poses",
            [this](const std::string& label) { writePoses = label.empty() ? refined : label; },
            "Add each scan's refined pose to OUT, as a robot pose of this label (OFFMAP_POSE); "
            "--method aligned")
        ->expected(0, 1)
        ->type_name("[LABEL]");
    command.add_option("--compression", compression, "Of the rawlogs written, 0 to 9 (1)")
        ->check(CLI::Range(0, 9).description(""))
        ->type_name("LEVEL");
    command
        .add_option("--threads", threads,
                    "Threads that reduce a log (one a processor); outputs do not depend on it")
        ->check(CLI::Range(1, 256).description(""))
        ->type_name("N");
    command.add_flag("--strict", strict, "Exit with 3 if a scan could not be reduced");
    command.add_flag("--keep-going", keepGoing,
                     "Write what can be read of a damaged log; copy scans without "
                     "poses");
    command.add_flag("--force", force, "Replace existing outputs");
    command.add_flag("--quiet", quiet, "No progress and no summary; warnings stay");
}

size_t ReduceOptions::threadCount() const {
    return threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U);
}

}  // namespace offmap::app
