// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using mrpt::poses::CPose3D;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Health : public ReduceFixture {
 protected:
    /// A pose off by so much that says it is good to 2 cm and 0.5 degrees.
    static auto wrongLocalisation(const SimulatedRobot& robot, const CPose3D& error) {
        auto obs = robot.localisation();
        obs->pose.mean = CPose3D(robot.pose.x() + error.x(), robot.pose.y() + error.y(), 0,
                                 robot.pose.yaw() + error.yaw(), 0, 0);
        return obs;
    }

    /// As many clouds, those of the numbers said with the pose's error.
    void writeClouds(int count, const std::vector<int>& wrong, const CPose3D& error) {
        SimulatedRobot robot;
        Observations log;
        for (int i = 0; i < count; ++i) {
            const bool isWrong = std::ranges::count(wrong, i) > 0;
            log.push_back(wrongLocalisation(robot, isWrong ? error : CPose3D()));
            log.push_back(robot.cloud());
            robot.wait(2);
        }
        writeLog(in_, log);
    }

    RunResult reduceWith(const std::string& method, const Arguments& more = {}) {
        Arguments all{"--method", method, "--report", report_, "--segments", csv_, "--force"};
        all.insert(all.end(), more.begin(), more.end());
        return reduce(all);
    }

    json report() const { return json::parse(readFile(report_)); }

    static uint64_t returnsIn(const Path& log) {
        uint64_t returns = 0;
        for (const auto& obs : observationsOf(log)) {
            if (is3dScan(*obs)) returns += returnsOf(*obs).size();
        }
        return returns;
    }

    const CPose3D nearby_{0.25, -0.15, 0, 0.09, 0, 0};  // found by a wider look
    const CPose3D elsewhere_{1.4, -1.4, 0, 1.7, 0, 0};
    const Path report_ = folder_ / "report.json", csv_ = folder_ / "segments.csv";
};

TEST_F(Health, ofGoodPosesIsGood) {
    for (const char* method : {"paper", "probabilistic", "aligned"}) {
        SCOPED_TRACE(method);
        writeClouds(3, {}, {});
        const RunResult run = reduceWith(method, {"--strict"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_THAT(run.out, Not(HasSubstr("suspect")));
        EXPECT_EQ(run.err, "");
        for (const json& scan : report()["scans"]) {
            EXPECT_GT(scan["matched_share"], 0.8);
            EXPECT_LT(std::abs(scan["residual_bias_m"].get<double>()), 0.03);
            EXPECT_EQ(scan["suspect"], nullptr);
            EXPECT_EQ(scan["pose_fit"].is_null(), std::string(method) != "aligned");
        }
        EXPECT_EQ(report()["totals"]["scans_suspect"], json::object());
    }
}

TEST_F(Health, tellsHowFarPosesWereCorrected) {
    writeClouds(3, {1}, {0.03, 0, 0, 0.01, 0, 0});
    EXPECT_THAT(reduceWith("aligned").out,
                AllOf(HasSubstr("   scans fit the map; poses corrected by 0.0"), HasSubstr("RMS")));
    const json all = report();
    double squares = 0;
    for (const json& scan : all["scans"]) {
        const json& fit = scan["pose_fit"];
        squares += std::pow(fit["shift_m"].get<double>(), 2) / 3;
        EXPECT_GT(fit["fitted_share"], 0.8);
        EXPECT_EQ(fit["prior_inflation"], 1);
    }
    EXPECT_NEAR(all["scans"][1]["pose_fit"]["turn_deg"].get<double>(), -0.57, 0.3);
    EXPECT_GT(all["scans"][1]["pose_fit"]["prior_chi_square"],
              all["scans"][0]["pose_fit"]["prior_chi_square"]);
    EXPECT_EQ(all["totals"]["scans_with_corrected_pose"], 3);
    // The report rounds to the micrometre.
    EXPECT_NEAR(all["totals"]["pose_shift_rms_m"].get<double>(), std::sqrt(squares), 3e-6);
}

TEST_F(Health, poseThatIsOffByMoreThanItSaysIsHealedAndNamed) {
    writeClouds(4, {1, 3}, nearby_);
    const RunResult run = reduceWith("aligned", {"--strict"});
    EXPECT_EQ(run.exitCode, 0) << "they were reduced";
    EXPECT_THAT(run.out,
                HasSubstr("2 contradict the stated covariance of their pose: scans 1, 3\n"));
    EXPECT_THAT(run.err, AllOf(HasSubstr("2 of 4 scans contradict"), HasSubstr("(scans 1, 3)"),
                               HasSubstr("--pose-sigma")));
    const json all = report();
    EXPECT_EQ(all["scans"][0]["suspect"], nullptr);
    EXPECT_EQ(all["scans"][1]["suspect"], "pose_contradicted");
    EXPECT_GT(all["scans"][1]["matched_share"], 0.8);
    EXPECT_EQ(all["totals"]["scans_suspect"], json({{"pose_contradicted", 2}}));
    EXPECT_EQ(all["totals"]["first_suspects"], json({1, 3}));
    EXPECT_THAT(readFile(csv_), HasSubstr(",pose_contradicted\n"));
}

TEST_F(Health, scanThatFitsNowhereIsKeptWholeAndNamed) {
    writeClouds(3, {1}, elsewhere_);
    const RunResult run = reduceWith("aligned");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("(kept whole: 1 pose does not fit)"),
                               HasSubstr("1 fit no place near their pose")));
    EXPECT_THAT(run.err, AllOf(HasSubstr("1 of 3 scans show what fits no place"),
                               HasSubstr("--map-origin"), HasSubstr("--pose-sigma")));
    const json all = report();
    EXPECT_EQ(all["scans"][1]["not_reduced"], "pose_does_not_fit");
    EXPECT_EQ(all["scans"][1]["suspect"], "pose_does_not_fit");
    EXPECT_EQ(all["scans"][1]["matched_share"], nullptr);
    EXPECT_EQ(all["totals"]["scans_with_corrected_pose"], 2);
    EXPECT_EQ(reduceWith("aligned", {"--strict"}).exitCode, 3);
}

TEST_F(Health, withoutAlignmentTellsByMatches) {
    writeClouds(3, {2}, elsewhere_);
    const RunResult run = reduceWith("paper");
    EXPECT_THAT(run.out, HasSubstr("1 show few of the map's walls: scan 2\n"));
    EXPECT_THAT(run.err, AllOf(HasSubstr("check the poses against the map (scan 2)")));
    EXPECT_EQ(report()["scans"][2]["suspect"], "few_matches");
    EXPECT_LT(report()["scans"][2]["matched_share"], 0.3);
}

TEST_F(Health, listOfSuspectsIsBounded) {
    std::vector<int> all(12);
    for (int i = 0; i < 12; ++i) all[static_cast<size_t>(i)] = i;
    writeClouds(12, all, nearby_);
    const RunResult run = reduceWith("aligned");
    EXPECT_THAT(run.out, HasSubstr(": scans 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, ...\n"));
    EXPECT_EQ(report()["totals"]["scans_suspect"]["pose_contradicted"], 12);
}

TEST_F(Health, ofSeveralLogsIsSummed) {
    writeClouds(2, {1}, nearby_);
    const Path other = folder_ / "other.rawlog", to = folder_ / "reduced/";
    std::filesystem::copy(in_, other);
    const RunResult run =
        runOffmap({"reduce", in_, other, "--map", map_, "-o", to, "--method", "aligned"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, HasSubstr("2 contradict the stated covariance of their pose\n"));
    EXPECT_THAT(run.out, HasSubstr("2   scans fit the map; poses corrected by"));
}

// Single returns go without their segment, and stay without it.
TEST_F(Health, countsAreThoseOfTheLogsWhateverTheMethod) {
    for (const char* method : {"paper", "probabilistic", "aligned"}) {
        SCOPED_TRACE(method);
        SimulatedRobot robot;
        writeLog(in_, secondsOf(robot, 1));
        ASSERT_EQ(reduceWith(method).exitCode, 0);
        const json totals = report()["totals"];
        EXPECT_EQ(totals["points_removed"], returnsIn(in_) - returnsIn(out_));
        uint64_t parts = totals["points_kept_off_wall"];
        for (const char* how : {"by_ray", "by_extension", "as_orphans"}) {
            parts += totals[std::string("points_removed_") + how].get<uint64_t>();
        }
        for (const auto& [reason, points] : totals["points_kept_by_reason"].items()) {
            parts += points.get<uint64_t>();
        }
        EXPECT_EQ(totals["points_on_vertical_segments"], parts);
        EXPECT_EQ(totals["points_removed_by_point"] > 0, std::string(method) != "paper");
    }
}

}  // namespace
