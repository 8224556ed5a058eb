// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"
#include "../support/RunProgram.h"
#include "../support/Scans.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/RangeImageScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace offmap::rawlog {
namespace {

namespace fs = std::filesystem;
using test::DepthImage;
using testing::AllOf;
using testing::HasSubstr;

const char* const rgbdSample = "/usr/share/mrpt/datasets/tests_rgbd.rawlog";

/// The sample, its points, ranges and colours put into files of their own by MRPT's tool.
class ExternalRangeImage : public testing::Test {
 protected:
    void SetUp() override {
        const std::string command = std::string("rawlog-edit --externalize -i ") + rgbdSample +
                                    " -o '" + rawlog().string() + "' > /dev/null 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
    }

    fs::path rawlog() const { return folder_ / "x.rawlog"; }
    DepthImage stored() const { return *test::observationsIn<DepthImage>(rawlog()).at(0); }

    fs::path file(const char* ending) const {
        for (const auto& entry : fs::directory_iterator(folder_ / "x_Images")) {
            if (entry.path().string().ends_with(ending)) return entry.path();
        }
        throw std::runtime_error(std::string("no file ending in ") + ending);
    }

    template <class Matcher>
    void expectRefusal(const Matcher& message) const {
        DepthImage obs = stored();
        const std::string before = test::bytesOf(obs);
        try {
            RangeImageScan().loadExternal(obs, rawlog());
            FAIL() << "no exception";
        } catch (const std::runtime_error& e) {
            EXPECT_THAT(e.what(), message);
        }
        EXPECT_EQ(test::bytesOf(obs), before);
    }

    test::TemporaryFolder folder_;
};

TEST_F(ExternalRangeImage, isLoadedAndBecomesInline) {
    DepthImage obs = stored();
    ASSERT_TRUE(obs.rangeImage_isExternallyStored());
    ASSERT_TRUE(obs.points3D_isExternallyStored());
    ASSERT_TRUE(obs.intensityImage.isExternallyStored());
    EXPECT_THROW(RangeImageScan().slotCount(obs), std::logic_error);
    EXPECT_TRUE(RangeImageScan().loadExternal(obs, rawlog()));

    // The colours are where they were, and all else is as it was before it was stored apart.
    const DepthImage original = *test::observationsIn<DepthImage>(rgbdSample).at(0);
    EXPECT_TRUE(obs.intensityImage.isExternallyStored());
    EXPECT_EQ(obs.intensityImage.getExternalStorageFile(),
              stored().intensityImage.getExternalStorageFile());
    obs.intensityImage = original.intensityImage;
    EXPECT_TRUE(test::bytesOf(obs) == test::bytesOf(original));
    EXPECT_FALSE(RangeImageScan().loadExternal(obs, "nowhere.rawlog"));
}

TEST_F(ExternalRangeImage, doesNotNeedItsColours) {
    fs::remove(file("_INT.png"));
    DepthImage obs = stored();
    EXPECT_TRUE(RangeImageScan().loadExternal(obs, rawlog()));
    const std::vector<uint8_t> none(RangeImageScan().slotCount(obs), 0);
    const auto reduced = RangeImageScan().withOnly(obs, none);
    EXPECT_EQ(dynamic_cast<const DepthImage&>(*reduced).intensityImage.getExternalStorageFile(),
              stored().intensityImage.getExternalStorageFile());
    EXPECT_NO_THROW(RangeImageScan().asPointCloud(obs, none, {}));
}

TEST_F(ExternalRangeImage, missingFileIsNamed) {
    const fs::path ranges = file("_RANGES.bin"), points = file("_3D.bin");
    fs::remove(points);
    expectRefusal(AllOf(HasSubstr("point cloud of 'OPENNI2'"), HasSubstr(points.filename())));
    fs::remove(ranges);
    expectRefusal(AllOf(HasSubstr("range image of 'OPENNI2'"), HasSubstr(ranges.filename()),
                        HasSubstr((folder_ / "x_Images").string())));
}

TEST_F(ExternalRangeImage, damagedFileIsNamed) {
    for (const char* ending : {"_RANGES.bin", "_3D.bin"}) {
        const fs::path damaged = file(ending);
        const std::string bytes = test::readFile(damaged);
        for (const std::string& content :
             {std::string(), std::string("no ranges"), std::string(64, '\xFF'),
              bytes.substr(0, bytes.size() / 2)}) {
            test::writeFile(damaged, content);
            expectRefusal(HasSubstr(damaged.string()));
        }
        test::writeFile(damaged, bytes);
    }
}

TEST_F(ExternalRangeImage, ofAnotherSizeIsRefused) {
    DepthImage other = *test::emptyDepthImage(8, 4);
    other.rangeImage_convertToExternalStorage("other.bin", folder_.path().string() + "/");
    fs::rename(folder_ / "other.bin", file("_RANGES.bin"));
    expectRefusal(AllOf(HasSubstr("640 x 480"), HasSubstr("8 x 4")));
}

/// rawlog-edit --txt-externals; what MRPT itself writes there it cannot read.
TEST_F(ExternalRangeImage, mayBeText) {
    DepthImage obs = *test::observationsIn<DepthImage>(rgbdSample).at(0);
    const DepthImage original = obs;
    DepthImage::EXTERNALS_AS_TEXT(true);
    const std::string folder = folder_.path().string() + "/";
    obs.points3D_convertToExternalStorage("points", folder);
    obs.rangeImage_convertToExternalStorage("ranges", folder);
    DepthImage::EXTERNALS_AS_TEXT(false);
    EXPECT_TRUE(RangeImageScan().loadExternal(obs, rawlog()));
    EXPECT_TRUE(obs.rangeImage == original.rangeImage);
    EXPECT_EQ(obs.points3D_idxs_x, original.points3D_idxs_x);
    // Text has 4 decimals.
    for (size_t i = 0; i < original.points3D_x.size(); i += 1000) {
        EXPECT_NEAR(obs.points3D_y[i], original.points3D_y[i], 0.5e-4 + 1e-6);
    }
}

}  // namespace
}  // namespace offmap::rawlog
