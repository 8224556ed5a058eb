// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/TextMap.h>
#include <offmap/maps/WallPlacement.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <limits>
#include <locale>
#include <stdexcept>
#include <string>

namespace offmap::maps {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double defaultSigma = 0.03;

std::vector<core::Wall> parsed(std::string_view text) {
    return parseTextMap(text, "plan.lines", defaultSigma);
}

std::string errorOf(std::string_view text) {
    try {
        parsed(text);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

TEST(TextMap, fourFieldsGiveAWallOfAnyHeightAndTheDefaultSigma) {
    const auto walls = parsed("1 -2.5 3e1 +4\n");
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_EQ(walls[0].line.point1, (mrpt::math::TPoint2D{1, -2.5}));
    EXPECT_EQ(walls[0].line.point2, (mrpt::math::TPoint2D{30, 4}));
    EXPECT_EQ(walls[0].sigma, defaultSigma);
    EXPECT_EQ(walls[0].height, core::Interval::everything());
}

TEST(TextMap, fiveFieldsGiveTheSigma) {
    EXPECT_EQ(parsed("0 0 1 0 0.1")[0].sigma, 0.1);
    EXPECT_EQ(parsed("0 0 1 0 0")[0].sigma, 0.0);
}

TEST(TextMap, sevenFieldsGiveTheHeight) {
    EXPECT_EQ(parsed("0 0 1 0 0.1 -0.5 2.5")[0].height, core::Interval(-0.5, 2.5));
}

TEST(TextMap, commentsAndBlankLinesAreSkipped) {
    EXPECT_EQ(parsed("# a plan\n\n  \t\n0 0 1 0 # the north wall\n#0 0 2 0\n0 1 1 1#east").size(),
              2U);
}

TEST(TextMap, windowsLineEndsAndByteOrderMarkAreRead) {
    const auto walls = parsed(
        "\xEF\xBB\xBF"
        "0 0 1 0\r\n\r\n0 1\t1 1 0.2\r\n");
    ASSERT_EQ(walls.size(), 2U);
    EXPECT_EQ(walls[1].sigma, 0.2);
}

TEST(TextMap, lastLineNeedsNoLineEnd) { EXPECT_EQ(parsed("0 0 1 0\n0 1 1 1").size(), 2U); }

TEST(TextMap, localeWithDecimalCommaChangesNothing) {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale({}, new Comma));
    const auto walls = parsed("0.5 0 1 0");
    std::locale::global(before);
    EXPECT_EQ(walls[0].line.point1.x, 0.5);
    EXPECT_THAT(errorOf("0,5 0 1 0"), HasSubstr("x1 is '0,5', not a number"));
}

TEST(TextMap, badNumberIsNamedWithItsPlaceAndTheForm) {
    EXPECT_EQ(errorOf("0 0 1 0\n\n0 0 1O 0\n"),
              "plan.lines:3: x2 is '1O', not a number; "
              "a wall is: x1 y1 x2 y2 [sigma [z_min z_max]], or: "
              "arc cx cy r start_deg end_deg [sigma [z_min z_max]], in metres");
    for (const char* const bad : {"+", "-", "+-1", "1.2.3", "0x10", "1e", "1;", "++1"})
        EXPECT_THAT(errorOf(std::string("0 0 0 ") + bad), HasSubstr("plan.lines:1: y2 is '"))
            << bad;
}

TEST(TextMap, wrongNumberOfFieldsIsAnError) {
    for (const size_t count : {1U, 2U, 3U, 6U}) {
        std::string line;
        for (size_t i = 0; i < count; ++i) line += std::to_string(i) + " ";
        EXPECT_THAT(errorOf(line), HasSubstr(std::to_string(count) + " fields, but it takes"));
    }
    EXPECT_THAT(errorOf("0 0 1 0 0.1 0 2 9"), HasSubstr("more than 7 fields, the 8th is '9'"));
}

TEST(TextMap, valuesThatAreNotFiniteAreErrors) {
    EXPECT_THAT(errorOf("nan 0 1 0"), HasSubstr("x1 is 'nan', not finite"));
    EXPECT_THAT(errorOf("0 0 1 -inf"), HasSubstr("y2 is '-inf', not finite"));
    EXPECT_THAT(errorOf("0 0 1 0 inf"), HasSubstr("sigma is 'inf', not finite"));
    EXPECT_THAT(errorOf("0 0 1e999 0"), HasSubstr("x2 is '1e999', beyond"));
    EXPECT_THAT(errorOf("-1e200 0 1e200 0"), HasSubstr("endless length"));
}

TEST(TextMap, impossibleWallsAreErrors) {
    EXPECT_THAT(errorOf("0 0 1 0\n2 3 2 3"), HasSubstr("plan.lines:2: a wall without length"));
    EXPECT_THAT(errorOf("0 0 1 0 -0.1"), HasSubstr("sigma is -0.1, below zero"));
    EXPECT_THAT(errorOf("0 0 1 0 0.1 2 1"), HasSubstr("z_min 2 is above z_max 1"));
}

TEST(TextMap, noWallIsAnError) {
    EXPECT_THAT(errorOf(""), HasSubstr("plan.lines: the map holds no wall"));
    EXPECT_THAT(errorOf("# only a comment\n"), HasSubstr("holds no wall"));
}

TEST(TextMap, binaryRubbishIsShownWithoutControlBytes) {
    const std::string gzip("\x1f\x8b\x08\x00\x1b[2J\xff", 9);
    EXPECT_THAT(errorOf(gzip),
                HasSubstr("x1 is '\\x1f\\x8b\\x08\\x00\\x1b[2J\\xff', not a number"));
    const std::string longField(100'000, 'A');
    EXPECT_LT(errorOf(longField).size(), 200U);
    EXPECT_THAT(errorOf(std::string(3, '\0')),
                AllOf(HasSubstr("\\x00"), Not(HasSubstr("no wall"))));
}

TEST(TextMap, placingTurnsThenShifts) {
    // A quarter turn takes (1, 0) to (0, 1) and (2, 3) to (-3, 2).
    const auto walls =
        placed(parsed("1 0 2 3 0.1 0 2"), mrpt::poses::CPose2D(10, 20, mrpt::DEG2RAD(90.0)));
    constexpr double rounding = 20 * 4 * std::numeric_limits<double>::epsilon();
    EXPECT_NEAR(walls[0].line.point1.x, 10, rounding);
    EXPECT_NEAR(walls[0].line.point1.y, 21, rounding);
    EXPECT_NEAR(walls[0].line.point2.x, 7, rounding);
    EXPECT_NEAR(walls[0].line.point2.y, 22, rounding);
    EXPECT_EQ(walls[0].sigma, 0.1);
    EXPECT_EQ(walls[0].height, core::Interval(0, 2));
}

}  // namespace
}  // namespace offmap::maps
