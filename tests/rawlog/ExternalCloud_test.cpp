// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/PointCloudScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cstdlib>

namespace offmap::rawlog {
namespace {

namespace fs = std::filesystem;
using Cloud = mrpt::obs::CObservationPointCloud;

/// The real cloud, stored in a file of its own by MRPT's tool: folder/x.rawlog and
/// folder/x_Images/pc_*.bin.
class ExternalCloud : public testing::Test {
 protected:
    void SetUp() override {
        OFFMAP_NEEDS_SHARED_DATA()
        const std::string command = "rawlog-edit --externalize -i '" + original().string() +
                                    "' -o '" + rawlog().string() + "' > /dev/null 2>&1";
        if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    }

    static fs::path original() { return test::sharedData("room/room1_points.rawlog"); }
    fs::path rawlog() const { return folder_ / "x.rawlog"; }
    Cloud stored() const { return *test::observationsIn<Cloud>(rawlog()).at(0); }

    test::TemporaryFolder folder_;
};

TEST_F(ExternalCloud, isLoadedAndBecomesInline) {
    Cloud cloud = stored();
    ASSERT_TRUE(cloud.isExternallyStored());
    PointCloudScan().loadExternal(cloud, rawlog());
    EXPECT_FALSE(cloud.isExternallyStored());
    EXPECT_EQ(test::bytesOf(cloud), test::bytesOf(*test::observationsIn<Cloud>(original()).at(0)));
}

TEST_F(ExternalCloud, isFoundBesideTheLogAsWell) {
    for (const auto& file : fs::directory_iterator(folder_ / "x_Images")) {
        fs::rename(file.path(), folder_ / file.path().filename().string());
    }
    Cloud cloud = stored();
    PointCloudScan().loadExternal(cloud, rawlog());
    EXPECT_EQ(cloud.pointcloud->size(), 88904U);
}

TEST_F(ExternalCloud, missingFileIsNamed) {
    fs::remove_all(folder_ / "x_Images");
    Cloud cloud = stored();
    try {
        PointCloudScan().loadExternal(cloud, rawlog());
        FAIL() << "no exception";
    } catch (const std::runtime_error& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr(cloud.getExternalStorageFile()));
        EXPECT_THAT(e.what(), testing::HasSubstr((folder_ / "x_Images").string()));
    }
    EXPECT_TRUE(cloud.isExternallyStored());
}

TEST_F(ExternalCloud, damagedFileIsNamed) {
    Cloud cloud = stored();
    const fs::path file = folder_ / "x_Images" / cloud.getExternalStorageFile();
    test::writeFile(file, "no cloud");
    try {
        PointCloudScan().loadExternal(cloud, rawlog());
        FAIL() << "no exception";
    } catch (const std::runtime_error& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr(file.string()));
    }
}

TEST_F(ExternalCloud, hasNoSlotsBeforeItIsLoaded) {
    EXPECT_THROW(PointCloudScan().slotCount(stored()), std::logic_error);
}

TEST(InlineCloud, isLeftAlone) {
    Cloud cloud;
    PointCloudScan().loadExternal(cloud, "nowhere.rawlog");
    EXPECT_FALSE(cloud.pointcloud);
}

}  // namespace
}  // namespace offmap::rawlog
