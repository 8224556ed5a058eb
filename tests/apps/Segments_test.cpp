// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using nlohmann::json;

using Row = std::vector<std::string>;

/// The rows of a CSV file, read as RFC 4180 says.
std::vector<Row> rowsOf(const std::string& csv) {
    std::vector<Row> rows;
    Row row{""};
    bool inQuotes = false;
    for (size_t i = 0; i < csv.size(); ++i) {
        const char c = csv[i];
        if (inQuotes) {
            if (c != '"') {
                row.back() += c;
            } else if (i + 1 < csv.size() && csv[i + 1] == '"') {
                row.back() += csv[++i];
            } else {
                inQuotes = false;
            }
        } else if (c == '"') {
            inQuotes = true;
        } else if (c == ',') {
            row.emplace_back();
        } else if (c == '\n') {
            rows.push_back(std::exchange(row, {""}));
        } else {
            row.back() += c;
        }
    }
    return rows;
}

class Segments : public ReduceFixture {
 protected:
    struct Table {
        std::vector<Row> rows;
        std::map<std::string, size_t> fields;

        const std::string& at(const Row& row, const std::string& field) const {
            return row.at(fields.at(field));
        }
    };

    Table reduceAndRead(const Arguments& more = {}) {
        Arguments arguments{"--segments", csv_, "--report", report_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = reduce(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        Table table{rowsOf(readFile(csv_)), {}};
        const Row header = table.rows.front();
        table.rows.erase(table.rows.begin());
        for (size_t f = 0; f < header.size(); ++f) table.fields[header[f]] = f;
        for (const Row& row : table.rows) EXPECT_EQ(row.size(), header.size());
        return table;
    }

    const Path csv_ = folder_ / "segments.csv", report_ = folder_ / "report.json";
};

TEST_F(Segments, pointsAreThoseOfTheReport) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 2));
    const Table table = reduceAndRead();
    std::map<std::string, std::map<std::string, uint64_t>> points;  // by scan, by fate
    for (const Row& row : table.rows) {
        const std::string& reason = table.at(row, "reason");
        const std::string& fate = reason.empty() ? table.at(row, "verdict") : reason;
        const uint64_t all = std::stoull(table.at(row, "points"));
        const uint64_t gone = std::stoull(table.at(row, "points_removed"));
        points[table.at(row, "scan")][fate] += reason.empty() ? gone : all;
        if (reason.empty()) points[table.at(row, "scan")]["kept_off_wall"] += all - gone;
    }
    const json report = json::parse(readFile(report_));
    ASSERT_EQ(report["scans"].size(), 6U);
    for (const json& scan : report["scans"]) {
        auto& ofScan = points[std::to_string(scan["scan"].get<int>())];
        EXPECT_GT(ofScan["mapped_by_ray"], 0U);
        EXPECT_EQ(ofScan["mapped_by_ray"], scan["points_removed_by_ray"]);
        EXPECT_EQ(ofScan["mapped_by_extension"], scan["points_removed_by_extension"]);
        EXPECT_EQ(ofScan["kept_off_wall"], scan["points_kept_off_wall"]);
        EXPECT_EQ(ofScan["removed_as_orphan"], scan["points_removed_as_orphans"]);
        for (const auto& [reason, kept] : scan["points_kept_by_reason"].items()) {
            EXPECT_EQ(ofScan[reason], kept) << reason;
        }
    }
}

TEST_F(Segments, rowsTellWhichScanTheyBelongTo) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    const Table table = reduceAndRead();
    const json report = json::parse(readFile(report_));
    for (const Row& row : table.rows) {
        const json& scan = report["scans"].at(std::stoul(table.at(row, "scan")));
        ASSERT_EQ(scan["entry"], std::stoull(table.at(row, "entry")));
        ASSERT_EQ(scan["sensor"], table.at(row, "sensor"));
        // A turn of the slowest sensor takes 0.8 s.
        const double afterBegin = std::stod(table.at(row, "time_s")) - scan["time_s"].get<double>();
        ASSERT_GE(afterBegin, -1e-5);
        ASSERT_LE(afterBegin, 0.8);
    }
}

TEST_F(Segments, ofAMappedWallLieWhereItIs) {
    writeLog(in_, smallLog());
    const Table table = reduceAndRead();
    const json walls = json::parse(readFile(report_))["map"]["walls"];
    size_t mapped = 0;
    for (const Row& row : table.rows) {
        if (table.at(row, "verdict") != "mapped_by_ray") continue;
        ++mapped;
        const auto number = [&](const char* field) { return std::stod(table.at(row, field)); };
        ASSERT_LE(number("measured_min_m"), number("predicted_max_m"));
        ASSERT_GE(number("measured_max_m"), number("predicted_min_m"));
        ASSERT_LT(number("z_min_m"), number("z_max_m"));
        ASSERT_GE(number("z_min_m"), -0.03);  // the floor, six sigma of the 5 mm of noise
        ASSERT_LT(std::stoul(table.at(row, "wall")), walls);
    }
    EXPECT_GT(mapped, 20U);
}

TEST_F(Segments, labelWithCommaAndQuoteIsReadBack) {
    SimulatedRobot robot;
    const std::string label = "front, \"left\"";
    writeLog(in_, Observations{robot.localisation(), robot.cloud(label)});
    const Table table = reduceAndRead();
    ASSERT_FALSE(table.rows.empty());
    for (const Row& row : table.rows) ASSERT_EQ(table.at(row, "sensor"), label);
}

TEST_F(Segments, columnsWithoutPoseHaveNoPrediction) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.cloud()});
    const Table table = reduceAndRead({"--keep-going"});
    ASSERT_FALSE(table.rows.empty());
    for (const Row& row : table.rows) {
        ASSERT_EQ(table.at(row, "reason"), "no_pose");
        for (const char* field : {"predicted_min_m", "predicted_max_m", "residual", "wall"}) {
            ASSERT_EQ(table.at(row, field), "") << field;
        }
    }
}

TEST_F(Segments, sameLogGivesTheSameBytes) {
    writeLog(in_, smallLog());
    reduceAndRead();
    const std::string first = readFile(csv_);
    reduceAndRead({"--force"});
    EXPECT_TRUE(readFile(csv_) == first);
}

TEST_F(Segments, doNotAppearIfTheLogCannotBeReduced) {
    writeLog(in_, smallLog(), std::nullopt);
    writeFile(in_, readFile(in_) + "damage");
    expectRefusal(reduceArguments({"--segments", csv_}), 2, testing::HasSubstr(in_.string()));
}

}  // namespace
