// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <mrpt/img/CImage.h>

#include <set>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class Render : public ReduceFixture {
 protected:
    Render() { writeLog(in_, smallLog()); }

    Arguments renderArguments(const Arguments& more = {}) const {
        Arguments all{"render", in_, "--map", map_, "-o", picture_};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    const Path picture_ = folder_ / "scan.png";
};

TEST_F(Render, writesAPicture) {
    const RunResult run = runOffmap(renderArguments());
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("wrote   " + picture_.string()));
    mrpt::img::CImage image;
    ASSERT_TRUE(image.loadFromFile(picture_.string()));
    EXPECT_GE(image.getWidth(), 800U);
    EXPECT_GE(image.getHeight(), 500U);
    EXPECT_THAT(folder_.names(),
                testing::UnorderedElementsAre("in.rawlog", "office.lines", "scan.png"));
}

TEST_F(Render, sizeAndViewAreThoseAskedFor) {
    for (const char* view : {"top", "perspective"}) {
        const RunResult run =
            runOffmap(renderArguments({"--view", view, "--size", "640x480", "--force"}));
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        mrpt::img::CImage image;
        ASSERT_TRUE(image.loadFromFile(picture_.string()));
        EXPECT_EQ(image.getWidth(), 640U);
        EXPECT_EQ(image.getHeight(), 480U);
    }
}

TEST_F(Render, everyChoiceGivesAnotherPicture) {
    std::set<std::string> pictures;
    const std::vector<Arguments> choices{{},
                                         {"--view", "perspective", "--azimuth-deg", "30"},
                                         {"--elevation-deg", "70"},
                                         {"--colour-by", "height"},
                                         {"--colour-by", "residual"},
                                         {"--colour-by", "reason", "--theme", "light"},
                                         {"--theme", "light"},
                                         {"--hide-mapped"}};
    for (Arguments choice : choices) {
        choice.push_back("--force");
        const RunResult run = runOffmap(renderArguments(choice));
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        pictures.insert(readFile(picture_));
    }
    EXPECT_EQ(pictures.size(), choices.size());
}

TEST_F(Render, wrongChoicesAreTold) {
    for (const char* size :
         {"640", "640x", "x480", "640x480x3", "-640x480", "199x480", "640x4001"}) {
        expectRefusal(renderArguments({std::string("--size=") + size}), 1,
                      AllOf(HasSubstr("--size"), HasSubstr("200 to 4000")));
    }
    expectRefusal(renderArguments({"--size", "300x200"}), 2, HasSubstr("too small for its legend"));
    expectRefusal(renderArguments({"--view", "top", "--azimuth-deg", "30"}), 1,
                  HasSubstr("--view top"));
    expectRefusal(renderArguments({"--colour-by", "taste"}), 1, HasSubstr("--colour-by"));
    expectRefusal(renderArguments({"--elevation-deg", "91"}), 1, HasSubstr("--elevation-deg"));
}

TEST_F(Render, coloursByIntensity) {
    const RunResult run = runOffmap(renderArguments({"--colour-by", "intensity"}));
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
}

TEST_F(Render, scanWithoutIntensitiesIsTold) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.localisation(), robot.depthCamera()});
    expectRefusal(renderArguments({"--colour-by", "intensity"}), 2,
                  AllOf(HasSubstr("tell no intensities"), HasSubstr("--colour-by")));
}

TEST_F(Render, existingPictureNeedsForce) {
    writeFile(picture_, "my holiday");
    expectRefusal(
        renderArguments(), 2,
        AllOf(HasSubstr(picture_.string()), HasSubstr("exists already"), HasSubstr("--force")));
    EXPECT_EQ(runOffmap(renderArguments({"--force"})).exitCode, 0);
    EXPECT_EQ(readFile(picture_).substr(1, 3), "PNG");
}

TEST_F(Render, missingScanIsTold) {
    expectRefusal(renderArguments({"--entry", "2"}), 2,
                  AllOf(HasSubstr(in_.string()), HasSubstr("no 3D scan at or after entry 2")));
}

TEST_F(Render, missingFolderIsNamed) {
    Arguments arguments = renderArguments();
    arguments.back() = folder_ / "figures" / "scan.png";
    expectRefusal(arguments, 2, AllOf(HasSubstr(arguments.back()), HasSubstr("folder")));
}

TEST_F(Render, pictureIsNamedAsWhatItIs) {
    Arguments arguments = renderArguments();
    arguments.back() = folder_ / "scan.jpg";
    expectRefusal(arguments, 1, AllOf(HasSubstr(arguments.back()), HasSubstr(".png")));
}

TEST_F(Render, inputIsNotReplaced) {
    Arguments arguments = renderArguments({"--force"});
    arguments[5] = in_;
    expectRefusal(arguments, 1, HasSubstr("IN and OUT are the same file"));
    arguments[5] = map_;
    expectRefusal(arguments, 1, HasSubstr("OUT and --map are the same file"));
}

TEST_F(Render, truncatedLogIsRefused) {
    writeFile(in_, readFile(in_).substr(0, 2000));
    expectRefusal(renderArguments(), 2, HasSubstr(in_.string() + ": entry 1 "));
}

}  // namespace
