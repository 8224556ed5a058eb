// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

/// A log whose clouds rawlog-edit has put into files of their own.
class ExternalStorage : public ReduceFixture {
 protected:
    void SetUp() override {
        OFFMAP_NEEDS_SHARED_DATA()
        map_ = sharedData("room/room.lines");
        in_ = folder_ / "external.rawlog";
        const RunResult run = runProgram({"/usr/bin/rawlog-edit", "--externalize", "-i",
                                          sharedData("room/room1_points.rawlog"), "-o", in_},
                                         {.folder = folder_.path()});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_TRUE(std::filesystem::is_directory(images_));
    }

    const Path images_ = folder_ / "external_Images";
};

TEST_F(ExternalStorage, cloudIsReducedAndWrittenInline) {
    ASSERT_EQ(reduce().exitCode, 0);
    const Path externalOut = folder_ / "external.out.rawlog";
    std::filesystem::rename(out_, externalOut);
    std::filesystem::remove_all(images_);

    in_ = sharedData("room/room1_points.rawlog");
    ASSERT_EQ(reduce().exitCode, 0);
    const Observations expected = observationsOf(out_), found = observationsOf(externalOut);
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_TRUE(returnsOf(*found[i]) == returnsOf(*expected[i]));
    }
}

TEST_F(ExternalStorage, inputIsFoundFromAnotherFolder) {
    const TemporaryFolder elsewhere;
    EXPECT_EQ(reduce({}, {.folder = elsewhere.path()}).exitCode, 0);
    EXPECT_THAT(elsewhere.names(), testing::IsEmpty());
}

TEST_F(ExternalStorage, missingFileIsNamed) {
    std::filesystem::remove_all(images_);
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("'LIDAR'"), HasSubstr("external_Images"),
                        HasSubstr("rawlog-edit --de-externalize")));
}

TEST_F(ExternalStorage, damagedFileIsNamed) {
    for (const auto& file : std::filesystem::directory_iterator(images_)) {
        writeFile(file.path(), readFile(file.path()).substr(0, 1000));
    }
    expectRefusal(reduceArguments(), 2, AllOf(HasSubstr("'LIDAR'"), HasSubstr("external_Images")));
}

TEST_F(ExternalStorage, missingFileIsPassedOverWithKeepGoing) {
    std::filesystem::remove_all(images_);
    const RunResult run = reduce({"--keep-going"});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("its file cannot be read"));
    EXPECT_EQ(entriesOf(out_).size(), entriesOf(in_).size());
    EXPECT_EQ(reduce({"--keep-going", "--strict", "--force"}).exitCode, 3);
}

}  // namespace
