// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/Scans.h"
#include "CraftedEntries.h"
#include "ManyLogsFixture.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <thread>

namespace {

using namespace offmap::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;
namespace fs = std::filesystem;

json withoutTimings(json report) {
    for (json& scan : report["scans"]) scan.erase("reduce_ms");
    for (const char* key : {"reduce_ms_median", "reduce_ms_p95"}) report["totals"].erase(key);
    report.erase("stage_seconds");
    return report;
}

TEST_F(ManyLogs, equalThoseReducedByThemselves) {
    const std::vector<Path> logs{writeGoodLog(1), writeGoodLog(2), writeGoodLog(3)};
    const Path removed = folder_ / "removed", reports = folder_ / "reports", csv = folder_ / "csv";
    const RunResult run = reduceMany(
        logs, {"--removed", removed, "--report", reports, "--segments", csv.string() + "/"});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    for (int number = 1; number <= 3; ++number) {
        const std::string name = "run" + std::to_string(number);
        const Path one = folder_ / (name + ".removed"), report = folder_ / (name + ".json"),
                   segments = folder_ / (name + ".csv");
        in_ = logs_ / (name + ".rawlog");
        ASSERT_EQ(reduce({"--removed", one, "--report", report, "--segments", segments, "--force"})
                      .exitCode,
                  0);
        EXPECT_TRUE(readFile(reduced_ / (name + ".rawlog")) == readFile(out_)) << name;
        EXPECT_TRUE(readFile(removed / (name + ".rawlog")) == readFile(one)) << name;
        EXPECT_TRUE(readFile(csv / (name + ".csv")) == readFile(segments)) << name;
        EXPECT_EQ(withoutTimings(json::parse(readFile(reports / (name + ".json")))),
                  withoutTimings(json::parse(readFile(report))));
    }
}

TEST_F(ManyLogs, doNotDependOnTheNumberOfThreads) {
    const std::vector<Path> logs{writeGoodLog(1), writeGoodLog(9), writeGoodLog(4)};
    const auto filesWith = [&](const char* threads) {
        const RunResult run = reduceMany(
            logs, {"--threads", threads, "--removed", folder_ / "removed", "--segments",
                   folder_ / "csv", "--inspect", folder_ / "pictures", "--write-poses", "--force"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return content();
    };
    const auto alone = filesWith("1");
    EXPECT_EQ(alone.size(), 1 + 5 * logs.size());  // the map; per log, itself and four outputs
    EXPECT_TRUE(alone == filesWith("2"));
    EXPECT_TRUE(alone == filesWith("5"));
}

TEST_F(ManyLogs, summaryIsTheSumOfTheReports) {
    const std::vector<Path> logs{writeGoodLog(2), writeGoodLog(5)};
    const Path reports = folder_ / "reports";
    const RunResult run = reduceMany(logs, {"--report", reports});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    uint64_t points = 0, removed = 0;
    for (const char* name : {"run2.json", "run5.json"}) {
        const json totals = json::parse(readFile(reports / name))["totals"];
        points += totals["points"].get<uint64_t>();
        removed += totals["points_removed"].get<uint64_t>();
    }
    std::string plain = run.out;
    std::erase(plain, ',');
    EXPECT_THAT(plain, testing::ContainsRegex("\nscans +7\n"));
    EXPECT_THAT(plain, testing::ContainsRegex("\npoints +" + std::to_string(points) + " "));
    EXPECT_THAT(plain, testing::ContainsRegex("\nremoved +" + std::to_string(removed) + " "));
    EXPECT_THAT(plain, testing::ContainsRegex("\nrun2.rawlog +2 scans .*% removed\n"));
    EXPECT_THAT(plain, testing::ContainsRegex("\nrun5.rawlog +5 scans .*% removed\n"));
    EXPECT_THAT(plain, HasSubstr("wrote   2 of 2 logs into " + reduced_.string()));
}

TEST_F(ManyLogs, badOnesDoNotStopTheOthers) {
    SimulatedRobot robot;
    const Path truncated = logs_ / "truncated.rawlog", deadly = logs_ / "deadly.rawlog",
               lost = logs_ / "lost.rawlog", flat = logs_ / "flat.rawlog";
    const Path first = writeGoodLog(1), last = writeGoodLog(2);
    writeFile(truncated, readFile(first).substr(0, 500));
    writeFile(deadly, actionsHoldingAComment());
    writeLog(lost, Observations{robot.cloud()});
    writeLog(flat, Observations{robot.localisation(), robot.horizontalScan()});
    const RunResult run =
        reduceMany({first, truncated, deadly, logs_ / "missing.rawlog", lost, flat, last});
    EXPECT_EQ(run.exitCode, 2) << testing::PrintToString(run);
    EXPECT_THAT(namesIn(reduced_), UnorderedElementsAre("run1.rawlog", "run2.rawlog"));
    for (const char* name : {"truncated", "deadly", "missing", "lost", "flat"}) {
        EXPECT_THAT(run.out,
                    testing::ContainsRegex(std::string("\n") + name + ".rawlog +failed: "));
        EXPECT_THAT(run.err, HasSubstr(name));
    }
    EXPECT_THAT(run.err, AllOf(HasSubstr("holds no robot pose"), HasSubstr("holds no 3D scan")));
    EXPECT_THAT(run.out, HasSubstr("wrote   2 of 7 logs"));
    EXPECT_TRUE(readFile(reduced_ / "run2.rawlog").size() > 1000);
}

TEST_F(ManyLogs, keepGoingCopiesWhatCannotBeReduced) {
    SimulatedRobot robot;
    const Path flat = logs_ / "flat.rawlog";
    writeLog(flat, Observations{robot.localisation(), robot.horizontalScan()});
    const RunResult run = reduceMany({writeGoodLog(1), flat}, {"--keep-going"});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("warning: flat.rawlog: the log holds no 3D scan"));
    EXPECT_EQ(entriesOf(reduced_ / "flat.rawlog").size(), 2U);
}

TEST_F(ManyLogs, existingOutputFailsItsLogOnly) {
    const std::vector<Path> logs{writeGoodLog(1), writeGoodLog(2)};
    fs::create_directories(reduced_);
    writeFile(reduced_ / "run1.rawlog", "yesterday's result");
    const RunResult run = reduceMany(logs, {"--quiet"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, AllOf(HasSubstr("run1.rawlog"), HasSubstr("exists already"),
                               HasSubstr("--force"), Not(HasSubstr("run2"))));
    EXPECT_EQ(readFile(reduced_ / "run1.rawlog"), "yesterday's result");
    EXPECT_EQ(entriesOf(reduced_ / "run2.rawlog").size(), 4U);
    EXPECT_EQ(reduceMany(logs, {"--force"}).exitCode, 0);
    EXPECT_EQ(entriesOf(reduced_ / "run1.rawlog").size(), 2U);
}

TEST_F(ManyLogs, strictTellsIfOneWasNotReduced) {
    SimulatedRobot robot;
    const Path late = logs_ / "late.rawlog";
    const auto pose = robot.localisation();
    robot.wait(60);
    writeLog(late, Observations{pose, robot.cloud()});
    const Path good = writeGoodLog(1);
    const RunResult run = reduceMany({late, good}, {"--strict"});
    EXPECT_EQ(run.exitCode, 3) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("(kept whole: 1 pose too old)"));
    EXPECT_THAT(namesIn(reduced_), UnorderedElementsAre("late.rawlog", "run1.rawlog"));
    const RunResult worse = reduceMany({late, logs_ / "missing.rawlog", good},
                                       {"--strict", "--force", "--sensor", "CLOUD"});
    EXPECT_EQ(worse.exitCode, 2) << testing::PrintToString(worse);
}

TEST_F(ManyLogs, logWithoutTheSensorIsAUsageErrorOfItsOwn) {
    SimulatedRobot robot;
    const Path other = logs_ / "other.rawlog";
    writeLog(other, Observations{robot.localisation(), robot.cloud("OTHER")});
    const RunResult run = reduceMany({other, writeGoodLog(1)}, {"--sensor", "CLOUD"});
    EXPECT_EQ(run.exitCode, 1) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("other.rawlog holds no 3D scan labelled 'CLOUD'"));
    EXPECT_THAT(namesIn(reduced_), UnorderedElementsAre("run1.rawlog"));
}

TEST_F(ManyLogs, interruptionKeepsWhatIsDone) {
    SimulatedRobot robot;
    const std::string scan = gzipped(bytesOf(*robot.vlp16()));
    std::string endless;  // several seconds of work, quickly made: one gzip member over and over
    for (int i = 0; i < 1500; ++i) endless += scan;
    const Path first = logs_ / "first.rawlog", second = logs_ / "second.rawlog",
               third = logs_ / "third.rawlog";
    writeFile(first, scan);
    writeFile(second, endless);
    writeFile(third, scan);
    Arguments command = manyArguments({first, second, third}, {"--pose", "2,2.5,17.2"});
    command.insert(command.begin(), offmapBinary());
    RunOptions options;
    options.ownGroup = true;
    RunningProgram program(command, options);
    const auto writesSecond = [&] {
        if (!fs::exists(reduced_)) return false;
        const auto names = namesIn(reduced_);
        return std::any_of(names.begin(), names.end(), [](const std::string& name) {
            return name.starts_with(".second.rawlog");
        });
    };
    while (program.runs() && !writesSecond()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(program.runs()) << "it ended before it could be interrupted";
    kill(-program.id(), SIGINT);
    const RunResult run = program.wait();
    EXPECT_EQ(run.exitCode, 130) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("interrupted; 1 of 3 logs were written"));
    EXPECT_THAT(run.out, HasSubstr("\nfirst.rawlog "));
    EXPECT_THAT(namesIn(reduced_), UnorderedElementsAre("first.rawlog"));
}

}  // namespace
