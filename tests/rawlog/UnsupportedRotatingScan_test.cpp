// SPDX-License-Identifier: BSD-3-Clause
#include "../support/RotatingMaker.h"

#include <offmap/rawlog/RotatingGeometry.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace offmap::rawlog {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class UnsupportedRotatingScan : public testing::Test {
 protected:
    std::string reason() const { return unsupportedRotatingScan(*scan_, config_).value_or("none"); }

    const std::shared_ptr<mrpt::obs::CObservationRotatingScan> scan_ =
        test::emptyRotatingScan(3, 8);
    SensorConfig config_ = test::withElevations({0.2, 0.1, 0});
};

TEST_F(UnsupportedRotatingScan, configuredElevationsAreEnough) { EXPECT_EQ(reason(), "none"); }

TEST_F(UnsupportedRotatingScan, unknownModelAsksForElevations) {
    config_.elevations.clear();
    scan_->lidarModel = "OS-\n128";
    EXPECT_THAT(reason(), AllOf(HasSubstr("\"OS-?128\""), HasSubstr("3 rows"),
                                HasSubstr("sensor.elevations_deg")));
}

TEST_F(UnsupportedRotatingScan, wrongNumberOfElevationsIsTold) {
    config_.elevations.pop_back();
    EXPECT_THAT(reason(),
                AllOf(HasSubstr("sensor.elevations_deg gives 2 elevations"), HasSubstr("3 rows")));
}

TEST_F(UnsupportedRotatingScan, modelsOfMrptNeedNoElevations) {
    config_.elevations.clear();
    for (const auto& [model, rows] :
         {std::pair{"VLP-16", 16}, {"HDL-32E", 32}, {"2D_SCAN_", 1}, {"2D_SCAN_FRONT", 1}}) {
        const auto scan = test::emptyRotatingScan(static_cast<uint16_t>(rows), 8);
        scan->lidarModel = model;
        EXPECT_FALSE(unsupportedRotatingScan(*scan, config_)) << model;
        scan_->lidarModel = model;
        EXPECT_THAT(reason(), HasSubstr("elevations of its 3 rows")) << model;
    }
}

TEST_F(UnsupportedRotatingScan, imagesMustHaveTheSizeOfTheScan) {
    scan_->rangeImage.setZero(3, 7);
    EXPECT_THAT(reason(), HasSubstr("range image is 3 x 7, not 3 rows x 8 columns"));
    scan_->rangeImage.setZero(4, 8);
    EXPECT_THAT(reason(), HasSubstr("range image is 4 x 8"));
    scan_->rangeImage.setZero(3, 8);
    scan_->rangeOtherLayers["LAST"].setZero(3, 8);
    EXPECT_EQ(reason(), "none");
    scan_->rangeOtherLayers["LAST"].setZero(2, 8);
    EXPECT_THAT(reason(), HasSubstr("layer LAST is 2 x 8"));
}

TEST_F(UnsupportedRotatingScan, emptyScanIsTold) {
    EXPECT_THAT(unsupportedRotatingScan({}, {}).value_or(""), HasSubstr("without rows or columns"));
}

TEST_F(UnsupportedRotatingScan, numbersMustBeOfAScanner) {
    const auto expectRefused = [this](double& number, std::initializer_list<double> values,
                                      const char* name) {
        const double valid = number;
        for (const double value : values) {
            number = value;
            EXPECT_THAT(reason(), HasSubstr(name)) << value;
        }
        number = valid;
        EXPECT_EQ(reason(), "none");
    };
    expectRefused(scan_->rangeResolution, {nan, infinity, 0, -0.002}, "rangeResolution");
    expectRefused(scan_->startAzimuth, {nan, infinity, -13}, "startAzimuth");
    expectRefused(scan_->azimuthSpan, {nan, -infinity, 13}, "azimuthSpan");
    expectRefused(scan_->sweepDuration, {nan, infinity, -1e-9, 3601}, "sweepDuration");
}

}  // namespace
}  // namespace offmap::rawlog
