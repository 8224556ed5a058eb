// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ForkedChild.h"
#include "../support/TemporaryFolder.h"
#include "Pixels.h"

#include <offmap/view/Render.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <sys/resource.h>

namespace offmap::view {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

mrpt::img::CImage smallPicture() {
    mrpt::img::CImage image(7, 4, mrpt::img::CH_RGB);
    image.filledRectangle(0, 0, 7, 4, {10, 20, 30});
    return image;
}

std::string errorFor(const fs::path& file) {
    try {
        writePng(smallPicture(), file);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

TEST(WritePng, pictureIsReadBackAndNothingElseIsLeft) {
    const test::TemporaryFolder folder;
    writePng(smallPicture(), folder / "a.png");
    mrpt::img::CImage read;
    ASSERT_TRUE(read.loadFromFile((folder / "a.png").string()));
    EXPECT_EQ(read.getWidth(), 7U);
    EXPECT_EQ(Pixels::of(read, {10, 20, 30}).count, 28);
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(WritePng, anyNameGivesAPng) {
    const test::TemporaryFolder folder;
    for (const char* const name : {"a.PNG", "b.figure", "c"}) {
        writePng(smallPicture(), folder / name);
        EXPECT_EQ(test::readFile(folder / name).substr(0, 4), "\x89PNG") << name;
    }
    EXPECT_THAT(folder.names(), UnorderedElementsAre("a.PNG", "b.figure", "c"));
}

TEST(WritePng, missingFolderIsNamed) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(errorFor(folder / "no" / "a.png"), HasSubstr("there is no folder"));
}

TEST(WritePng, nameOfAFolderIsRefusedAndNothingIsLeft) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "taken.png");
    EXPECT_THAT(errorFor(folder / "taken.png"), HasSubstr("cannot write the picture"));
    EXPECT_THAT(folder.names(), ElementsAre("taken.png"));
}

TEST(WritePng, lockedFolderIsAnError) {
    const test::TemporaryFolder folder;
    const std::string error = test::inForkedChild([&] {
        test::dropRoot();
        return errorFor(folder / "a.png");
    });
    EXPECT_THAT(error, HasSubstr("is the folder writable"));
}

TEST(WritePng, fullDiskIsAnErrorAndTheOldPictureStays) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "old.png", "old");
    const std::string error = test::inForkedChild([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tiny{16, 16};
        setrlimit(RLIMIT_FSIZE, &tiny);
        return errorFor(folder / "old.png");
    });
    EXPECT_THAT(error, HasSubstr("is there space?"));
    EXPECT_EQ(test::readFile(folder / "old.png"), "old");
    EXPECT_THAT(folder.names(), ElementsAre("old.png"));
}

}  // namespace
}  // namespace offmap::view
