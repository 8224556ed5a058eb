// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/evaluation/TruthFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

namespace offmap::evaluation {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::string header =
    "scan,time_s,sensor,x_m,y_m,z_m,mapped,kind,stand_off_m,on_vertical_segment\n";

std::string textOf(const std::vector<ObservationTruth>& observations) {
    std::string text;
    TruthWriter writer([&](std::string_view piece) { text += piece; });
    for (const ObservationTruth& observation : observations) writer.add(observation);
    return text;
}

std::vector<ObservationTruth> readFrom(const std::string& content) {
    const TemporaryFolder folder;
    test::writeFile(folder / "truth.csv", content);
    TruthReader reader(folder / "truth.csv");
    std::vector<ObservationTruth> all;
    while (const ObservationTruth* observation = reader.next()) all.push_back(*observation);
    return all;
}

std::string messageOf(const std::string& content) {
    try {
        readFrom(content);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

mrpt::Clock::time_point seconds(double seconds) { return mrpt::Clock::fromDouble(seconds); }

/// All that is awkward: numbers without short decimals, the smallest, negative zero, odd labels.
std::vector<ObservationTruth> awkward() {
    const auto tick = mrpt::Clock::duration(1);
    return {
        {0, seconds(1.7e9) + tick, "LIDAR", {{{0.1F, -1.0F / 3, 1e-38F}, true, SurfaceKind::Wall}}},
        {0,
         seconds(1.7e9) + 2 * tick,
         "LIDAR",
         {{{-0.0F, 16777217.0F, 5}, false, SurfaceKind::Object, 0.05F, true},
          {{std::numeric_limits<float>::denorm_min(), 0, 0}, false, SurfaceKind::Floor}}},
        {7, seconds(1.7e9) + 2 * tick, "a,\"b\"", {{{1, 2, 3}, false, SurfaceKind::Ceiling, 0}}},
        {8, mrpt::Clock::time_point(), "", {{{1, 2, 3}, true, SurfaceKind::Wall}}},
        {9, seconds(1.7e9), " ", {{{1, 2, 3}, true, SurfaceKind::Object, {}, true}}},
    };
}

TEST(TruthFile, rowsStandAsDocumented) {
    const std::vector<ObservationTruth> observations{
        {3,
         seconds(1700000000.25),
         "VLP16",
         {{{1.5F, -2, 0.1F}, true, SurfaceKind::Wall, {}, true},
          {{1, 0, 0.25F}, false, SurfaceKind::Object, 0.3F, false}}}};
    EXPECT_EQ(textOf(observations), header +
                                        "3,1700000000.2500000,VLP16,1.5,-2,0.1,1,wall,,1\n"
                                        "3,1700000000.2500000,VLP16,1,0,0.25,0,object,0.3,0\n");
}

TEST(TruthFile, whatWasWrittenIsReadExactly) {
    const auto written = awkward();
    const auto read = readFrom(textOf(written));
    ASSERT_EQ(read.size(), written.size());
    for (size_t i = 0; i < written.size(); ++i) {
        EXPECT_EQ(read[i].scan, written[i].scan);
        EXPECT_EQ(read[i].time, written[i].time);
        EXPECT_EQ(read[i].sensor, written[i].sensor);
        EXPECT_EQ(read[i].points, written[i].points);
    }
    EXPECT_TRUE(std::signbit(read[1].points[0].point.x));
}

TEST(TruthFile, gzipIsReadLikePlainText) {
    const std::string text = textOf(awkward());
    EXPECT_EQ(textOf(readFrom(test::gzipped(text))), text);
}

TEST(TruthFile, linesOfWindowsAndNoEndOfTheLastAreRead) {
    const std::string row = "0,1.0000000,A,1,2,3,0,floor,,0";
    EXPECT_EQ(readFrom(header + row).size(), 1U);
    std::string text = header;
    text.insert(text.size() - 1, "\r");
    EXPECT_EQ(readFrom(text + row + "\r\n").at(0).points.size(), 1U);
}

TEST(TruthFile, manyBlocksOfTextAreReadWhole) {
    ObservationTruth observation{0, seconds(5), "S", {}};
    // 60,000 rows of more than 30 bytes each: more than the reader's 1 MiB
    for (int i = 0; i < 60000; ++i) {
        observation.points.push_back({{static_cast<float>(i), 0, 0}, i % 3 == 0});
    }
    const auto read = readFrom(textOf({observation}));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].points, observation.points);
}

TEST(TruthFile, observationsWithoutReturnsLeaveNoRow) {
    EXPECT_EQ(textOf({{0, seconds(1), "A", {}}}), header);
    EXPECT_TRUE(readFrom(header).empty());
}

TEST(TruthFile, whatCannotBeToldAgainIsRefused) {
    const TruePoint point{{1, 2, 3}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(textOf({{0, seconds(1), "A\nB", {point}}}), std::invalid_argument);
    EXPECT_THROW(textOf({{0, seconds(1), "A", {{{nan, 0, 0}}}}}), std::invalid_argument);
    EXPECT_THROW(textOf({{0, seconds(1), "A", {point}}, {1, seconds(1), "A", {point}}}),
                 std::invalid_argument);
}

TEST(TruthFile, badRowsAreNamedWithLineAndField) {
    const std::string good = "0,1.0000000,A,1,2,3,0,floor,,0\n";
    const auto bad = [&](const std::string& row) { return messageOf(header + good + row); };
    EXPECT_THAT(bad("0,1.0000000,A,1,2,x,0,floor,,0\n"),
                AllOf(HasSubstr("truth.csv, line 3: "), HasSubstr("z_m is 'x', not a number")));
    EXPECT_THAT(bad("0,1.0000000,A,1,nan,3,0,floor,,0\n"), HasSubstr("y_m is 'nan', not finite"));
    EXPECT_THAT(bad("0,1.0000000,A,1,2,3,2,floor,,0\n"), HasSubstr("mapped is '2', not 0 or 1"));
    EXPECT_THAT(bad("0,1.0000000,A,1,2,3,0,roof,,0\n"), HasSubstr("kind is 'roof', not wall"));
    EXPECT_THAT(bad("0,1.0000000,A,1,2,3,0,floor,near,0\n"), HasSubstr("stand_off_m is 'near'"));
    EXPECT_THAT(bad("0,1.0000000,A,1,2,3,0,floor,,0,9\n"), HasSubstr("on_vertical_segment is"));
    EXPECT_THAT(bad("0,1.0000000,A,1,2,3\n"), HasSubstr("too few fields"));
    EXPECT_THAT(bad("0,2.5,A,1,2,3,0,floor,,0\n"), HasSubstr("seconds with 7 decimals"));
    EXPECT_THAT(bad("0,999999999999.0000000,A,1,2,3,0,floor,,0\n"), HasSubstr("7 decimals"));
    EXPECT_THAT(bad("-1,2.0000000,A,1,2,3,0,floor,,0\n"), HasSubstr("scan is '-1'"));
    EXPECT_THAT(bad("0,2.0000000,\"A,1,2,3,0,floor,,0\n"), HasSubstr("quotes"));
    EXPECT_THAT(bad("\n"), HasSubstr("line 3: too few fields"));
    EXPECT_THAT(bad(std::string(2 << 20, 'x')), HasSubstr("line 3: the line is longer"));
}

TEST(TruthFile, otherFilesAreRefused) {
    const TemporaryFolder folder;
    EXPECT_THROW(TruthReader(folder / "none.csv"), std::runtime_error);
    EXPECT_THROW(TruthReader(folder.path()), std::runtime_error);
    EXPECT_THAT(messageOf(""), HasSubstr("is empty"));
    EXPECT_THAT(messageOf("x,y\n1,2\n"), HasSubstr("line 1: not a truth file"));
}

TEST(TruthFile, truncatedGzipIsNoticed) {
    const std::string packed = test::gzipped(textOf(awkward()));
    EXPECT_THAT(messageOf(packed.substr(0, packed.size() / 2)), HasSubstr("truncated or corrupt"));
    EXPECT_THAT(messageOf(packed.substr(0, packed.size() - 4)), HasSubstr("truncated or corrupt"));
}

}  // namespace
}  // namespace offmap::evaluation
