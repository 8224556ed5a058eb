// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ReportFile.h>

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <nlohmann/json.hpp>

namespace offmap::rawlog {
namespace {

TurnRecord someTurn() {
    TurnRecord turn;
    turn.entry = 7;
    turn.time = mrpt::Clock::fromDouble(1.7e9);
    turn.label = "LIDAR \"1\"\xff";  // as a damaged log may name it
    turn.className = "CObservationPointCloud";
    turn.counts.returns = 100;
    turn.onVerticalSegments = 60;
    turn.removedByRay = 30;
    turn.removedByExtension = 10;
    turn.keptByReason[static_cast<size_t>(core::KeepReason::InFrontOfWall)] = 20;
    turn.milliseconds = 1.5;
    return turn;
}

nlohmann::json reportOf(const std::vector<TurnRecord>& turns) {
    test::TemporaryFolder folder;
    ReportFile report(folder / "report.json", {});
    report.begin({{"offmap", "x"}, {"input", "in.rawlog"}});
    ReductionTotals totals;
    for (const TurnRecord& turn : turns) {
        report.add(turn);
        totals.add(turn);
    }
    report.finish(totals, {{"warnings", nlohmann::ordered_json::array()}});
    report.publish();
    return nlohmann::json::parse(test::readFile(folder / "report.json"));
}

TEST(ReportFile, isJsonWithTheDocumentedKeys) {
    TurnRecord keptWhole = someTurn();
    keptWhole.notReduced = "no_pose";
    const nlohmann::json report = reportOf({someTurn(), keptWhole});
    EXPECT_EQ(report.at("input"), "in.rawlog");
    ASSERT_EQ(report.at("scans").size(), 2U);
    const auto& scan = report.at("scans")[0];
    EXPECT_EQ(scan.at("entry"), 7);
    EXPECT_EQ(scan.at("points"), 100);
    EXPECT_EQ(scan.at("points_on_vertical_segments"), 60);
    EXPECT_EQ(scan.at("points_removed"), 40);
    EXPECT_EQ(scan.at("points_kept_by_reason").at("in_front_of_wall"), 20);
    EXPECT_TRUE(scan.at("not_reduced").is_null());
    EXPECT_EQ(report.at("scans")[1].at("not_reduced"), "no_pose");
    const auto& totals = report.at("totals");
    EXPECT_EQ(totals.at("scans"), 2);
    EXPECT_EQ(totals.at("points"), 200);
    EXPECT_EQ(totals.at("points_on_vertical_segments"), 120);
    EXPECT_EQ(totals.at("points_removed"), 80);
    EXPECT_EQ(totals.at("scans_not_reduced"), (nlohmann::json{{"no_pose", 1}}));
    EXPECT_NEAR(totals.at("reduce_ms_median").get<double>(), 1.5, 0.005 * 1.5 + 0.0005);
}

TEST(ReportFile, logWithoutScansIsJsonToo) {
    const nlohmann::json report = reportOf({});
    EXPECT_TRUE(report.at("scans").empty());
    EXPECT_EQ(report.at("totals").at("scans"), 0);
    EXPECT_TRUE(report.at("totals").at("reduce_ms_median").is_null());
}

}  // namespace
}  // namespace offmap::rawlog
