// SPDX-License-Identifier: BSD-3-Clause
#include "MapFixture.h"

#include <mrpt/img/CImage.h>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class MapDraw : public MapFixture {};

TEST_F(MapDraw, pngHasTheSizeAskedFor) {
    const Path picture = folder_ / "plan.png";
    const RunResult run = map("draw", {"-o", picture, "--size", "700"});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("wrote   " + picture.string()));
    mrpt::img::CImage image;
    ASSERT_TRUE(image.loadFromFile(picture.string()));
    // rounded up to a whole pixel
    EXPECT_NEAR(double(std::max(image.getWidth(), image.getHeight())), 700, 1);
    EXPECT_THAT(folder_.names(), testing::UnorderedElementsAre("office.lines", "plan.png"));
}

TEST_F(MapDraw, svgIsOne) {
    const Path picture = folder_ / "plan.SVG";
    ASSERT_EQ(map("draw", {"-o", picture}).exitCode, 0);
    EXPECT_THAT(readFile(picture), AllOf(HasSubstr("<svg"), HasSubstr("</svg>")));
}

TEST_F(MapDraw, pictureIsNamedAsWhatItIs) {
    expectMapRefused("draw", {"-o", folder_ / "plan.jpg"}, 1,
                     AllOf(HasSubstr("plan.jpg"), HasSubstr(".png or .svg")));
}

TEST_F(MapDraw, sizesBeyondReasonAreRefused) {
    for (const char* size : {"0", "-5", "199", "20001", "large"}) {
        expectMapRefused("draw", {"-o", folder_ / "plan.png", "--size", size}, 1,
                         HasSubstr("--size"));
    }
}

TEST_F(MapDraw, existingPictureNeedsForce) {
    const Path picture = folder_ / "plan.png";
    writeFile(picture, "my holiday");
    expectMapRefused("draw", {"-o", picture}, 2,
                     AllOf(HasSubstr("plan.png exists already"), HasSubstr("--force")));
    EXPECT_EQ(map("draw", {"-o", picture, "--force"}).exitCode, 0);
    EXPECT_EQ(readFile(picture).substr(1, 3), "PNG");
}

TEST_F(MapDraw, inputIsNotReplaced) {
    const Path named = folder_ / "map.svg";
    std::filesystem::create_hard_link(map_, named);
    expectMapRefused("draw", {"-o", named, "--force"}, 1, HasSubstr("same file"));
}

TEST_F(MapDraw, planBeyondAllMeasureIsRefused) {
    writeFile(map_, "-1e300 0 1e300 0\n");
    expectMapRefused("draw", {"-o", folder_ / "plan.png"}, 2, HasSubstr(map_.string()));
}

TEST_F(MapDraw, manyWallsAreDrawn) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) {
        const int x = i % 200, y = i / 200;
        text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(x + 1) + " " +
                std::to_string(y + i % 2) + "\n";
    }
    writeFile(map_, text);
    EXPECT_EQ(map("draw", {"-o", folder_ / "plan.png"}).exitCode, 0);
}

}  // namespace
