// SPDX-License-Identifier: BSD-3-Clause
#include "ScoreFixture.h"

namespace {

using namespace offmap::test;
using offmap::evaluation::SurfaceKind;
using testing::AllOf;
using testing::HasSubstr;

class Score : public ScoreFixture {
 protected:
    /// Four classes, one of them with columns of its own.
    static Observations log() {
        SimulatedRobot robot;
        Observations all{robot.localisation()};
        robot.wait(0.1);
        all.insert(all.end(), {robot.vlp16(10), robot.cloud(), robot.depthCamera()});
        const Observations fans = robot.sweep(30);
        all.insert(all.end(), fans.begin(), fans.end());
        robot.wait(0.1);
        all.push_back(robot.localisation());
        return all;
    }

    /// Reduces the log, and calls mapped what was removed: a score that is known to be perfect.
    void reduceAndCallRemovedMapped() {
        writeLog(in_, log());
        const RunResult run = reduce({"--removed", removed_});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto kept = observationsOf(out_);
        Truth truth = truthOf(in_, [](size_t) { return true; });
        for (size_t o = 0; o < truth.size(); ++o) {
            std::multiset<std::array<float, 3>> left;
            for (const auto& p : pointsOf(*kept.at(o))) left.insert({p.x, p.y, p.z});
            for (auto& one : truth[o].points) {
                const auto found = left.find({one.point.x, one.point.y, one.point.z});
                if (found == left.end()) continue;
                left.erase(found);
                one.mapped = false;
            }
        }
        writeTruth(truth);
    }
};

TEST_F(Score, unreducedLogKeepsAll) {
    writeLog(in_, log());
    writeTruth(truthOf(in_, [](size_t i) { return i % 2 == 0; }));
    const auto score = scoreOf(in_);
    const uint64_t points = score["points"];
    EXPECT_GT(points, 1000U);
    EXPECT_EQ(score["mapped"]["points"], (points + 1) / 2);
    EXPECT_EQ(score["mapped"]["removed_share"], 0);
    EXPECT_EQ(score["mapped_on_vertical_segments"]["removed_share"], 0);
    EXPECT_EQ(score["unmapped"]["kept"], points / 2);
    EXPECT_EQ(score["unmapped"]["kept_share"], 1);
    EXPECT_EQ(score["geometric_mean"], 0);
}

TEST_F(Score, everyClassIsScoredByItsReturns) {
    reduceAndCallRemovedMapped();
    const auto reduced = scoreOf(out_);
    EXPECT_GT(reduced["mapped"]["points"], 1000U);
    EXPECT_GT(reduced["unmapped"]["points"], 1000U);
    EXPECT_EQ(reduced["mapped"]["removed_share"], 1);
    EXPECT_EQ(reduced["unmapped"]["kept_share"], 1);
    EXPECT_EQ(reduced["geometric_mean"], 1);
    EXPECT_EQ(reduced["scan_percentiles"]["mapped_removed_share"]["p05"], 1);
    EXPECT_EQ(reduced["scan_percentiles"]["unmapped_removed_share"]["p95"], 0);
}

TEST_F(Score, complementScoresTheComplement) {
    reduceAndCallRemovedMapped();
    const auto removed = scoreOf(removed_);
    EXPECT_EQ(removed["mapped"]["removed_share"], 0);
    EXPECT_EQ(removed["unmapped"]["kept_share"], 0);
}

TEST_F(Score, pointCloudsScoreAsTheirObservations) {
    reduceAndCallRemovedMapped();
    const auto same = scoreOf(out_);
    ASSERT_EQ(reduce({"--output", "points", "--force"}).exitCode, 0);
    const auto points = scoreOf(out_);
    EXPECT_EQ(points, same);
}

TEST_F(Score, rotatingScanNeedsItsElevations) {
    SimulatedRobot robot;
    Observations observations{robot.rotatingScan()};
    writeLog(in_, observations);
    writeTruth(truthOf(in_, [](size_t) { return false; }));
    expectRefusal(
        scoreArguments(in_), 2,
        AllOf(HasSubstr("another log"), HasSubstr("'ROTATING': "), HasSubstr("elevations")));
    EXPECT_EQ(scoreOf(in_, {"--set", "sensor.elevations_deg=" +
                                         rotatingElevationsText()})["unmapped"]["kept_share"],
              1);
}

TEST_F(Score, tableTellsWhatTheFiguresMean) {
    writeLog(in_, smallLog());
    // Of four points: one mapped on a segment, one mapped elsewhere, two not mapped.
    Truth truth = truthOf(in_, [](size_t) { return true; });
    auto& points = truth.at(1).points;
    points[0].onVerticalSegment = true;
    for (size_t i = 1; i < points.size(); ++i) points[i].onVerticalSegment = false;
    points[1].mapped = points[2].mapped = false;
    points[1].kind = SurfaceKind::Floor;
    points[2].standOff = 0.2F;
    points.push_back({{9, 9, 9}, false, SurfaceKind::Object, 0.2F});  // not in the log: removed
    writeTruth(truth);
    const RunResult run = runOffmap(scoreArguments(in_));
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("1 scan, "));
    EXPECT_THAT(run.out, HasSubstr("mapped, vertical segments       0.00 %   0 of 1\n"));
    EXPECT_THAT(run.out, HasSubstr("not mapped (UP)                66.67 %   2 of 3\n"));
    EXPECT_THAT(run.out, HasSubstr("  floor                       100.00 %   1 of 1\n"));
    EXPECT_THAT(run.out, HasSubstr("  objects                      50.00 %   1 of 2\n"));
    EXPECT_THAT(run.out, HasSubstr("  20 cm off a wall             50.00 %   1 of 2\n"));
    EXPECT_EQ(run.err, "");
}

TEST_F(Score, columnsOfATurnAreOneScan) {
    SimulatedRobot robot;
    writeLog(in_, robot.sweep(20));
    Truth truth = truthOf(in_, [](size_t) { return false; });
    for (auto& column : truth) column.scan = 3;
    truth.back().points.push_back({{9, 9, 9}});  // removed: one of many, not all of its column
    writeTruth(truth);
    const auto score = scoreOf(in_);
    EXPECT_EQ(score["scans"], 1);
    EXPECT_EQ(score["observations"], 20);
    const double points = score["points"];
    EXPECT_EQ(score["scan_percentiles"]["unmapped_removed_share"]["p50"], 1 / points);
}

TEST_F(Score, logInFramesIsScored) {
    writeLog(in_, inFrames(log()));
    writeTruth(truthOf(in_, [](size_t) { return false; }));
    EXPECT_EQ(scoreOf(in_)["unmapped"]["kept_share"], 1);
}

TEST_F(Score, simulatedLogAndItsComplementAddUp) {
    const Path sim = folder_ / "sim";
    const Arguments options{"--class", "sweep", "--scans", "1", "--seed", "5"};
    Arguments simulate{"simulate", "random_room", "-o", sim};
    simulate.insert(simulate.end(), options.begin(), options.end());
    ASSERT_EQ(runOffmap(simulate).exitCode, 0);
    truth_ = sim / "truth.csv.gz";
    map_ = sim / "map.lines";
    ASSERT_EQ(reduceLog(sim / "scans.rawlog", {"--removed", removed_}).exitCode, 0);
    const auto kept = scoreOf(out_), removed = scoreOf(removed_);
    EXPECT_GT(kept["geometric_mean"], 0.8);
    for (const char* which : {"mapped", "mapped_on_vertical_segments"}) {
        const uint64_t both =
            kept[which]["removed"].get<uint64_t>() + removed[which]["removed"].get<uint64_t>();
        EXPECT_EQ(both, kept[which]["points"]) << which;
    }
    const uint64_t both =
        kept["unmapped"]["kept"].get<uint64_t>() + removed["unmapped"]["kept"].get<uint64_t>();
    EXPECT_EQ(both, kept["unmapped"]["points"]);
}

TEST_F(Score, helpTellsWhatItTakes) {
    const RunResult run = runOffmap({"score", "--help"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("TRUTH"), HasSubstr("REDUCED"), HasSubstr("--json"),
                               HasSubstr("--partial"), HasSubstr("Exit codes")));
}

}  // namespace
