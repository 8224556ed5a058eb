// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "FakeLidar.h"

#include <offmap/live/GrabberFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace offmap::live {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Grabber : public testing::Test {
 protected:
    Grabber() { test::FakeLidar::doRegister(); }

    std::filesystem::path written(const std::string& content) const {
        std::ofstream(file_, std::ios::binary) << content;
        return file_;
    }

    template <class Matcher>
    void expectRefusal(const std::string& content, const Matcher& message) const {
        try {
            const GrabberFile file(written(content));
            FAIL() << "accepted: " << content;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr(file_.string()), message));
        }
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "sensors.ini";
};

TEST_F(Grabber, everySectionButGlobalIsASensor) {
    const GrabberFile file(
        written("// by hand\n"
                "[global]\nrawlog_prefix = run\nGRABBER_PERIOD_MS = 1000\n"
                "[LIDAR]\ndriver = FakeLidar // ours\nprocess_rate = 10 // Hz\n"
                "sensorLabel = TOP\n"
                "[notes]\nrawlog-grabber-ignore = true\nx = 1\n"
                "[BACK]\ndriver = CVelodyneScanner\nprocess_rate = 1000\n"
                "model = VLP16\n"));
    EXPECT_THAT(file.sections(), testing::ElementsAre("BACK", "LIDAR"));
    const auto lidar = file.makeSensor("LIDAR");
    EXPECT_EQ(lidar->getSensorLabel(), "TOP");
    EXPECT_EQ(lidar->getProcessRate(), 10);
}

TEST_F(Grabber, whatIsWrongInASectionIsSaidWithItsFix) {
    expectRefusal("[A]\nprocess_rate = 10\n", AllOf(HasSubstr("[A]"), HasSubstr("driver =")));
    expectRefusal("[A]\ndriver = CNoSuchThing\nprocess_rate = 10\n",
                  AllOf(HasSubstr("[A]"), HasSubstr("CNoSuchThing")));
    expectRefusal("[A]\ndriver = FakeLidar\n", AllOf(HasSubstr("[A]"), HasSubstr("process_rate")));
    expectRefusal("[A]\ndriver = FakeLidar\nprocess_rate = nan\n", HasSubstr("process_rate"));
    expectRefusal("[A]\ndriver = FakeLidar\nprocess_rate = 1e-12\n", HasSubstr("process_rate"));
    expectRefusal("[A]\ndriver = FakeLidar\nprocess_rate = 1\nimpossible = true\n",
                  HasSubstr("impossible is not possible"));
    expectRefusal("[A]\ndriver = CVelodyneScanner\nprocess_rate = 1\nmodel = VLP17\n",
                  AllOf(HasSubstr("VLP17"), testing::Not(HasSubstr("backtrace"))));
    expectRefusal("[A]\nrawlog-grabber-ignore = perhaps\n", HasSubstr("rawlog-grabber-ignore"));
}

TEST_F(Grabber, aFileWithoutSensorIsRefused) {
    for (const std::string& content :
         {std::string(), std::string("[global]\nrawlog_prefix = run\n"),
          std::string("[A]\nrawlog-grabber-ignore = true\n"),
          std::string("\x1f\x8b\0\0]][[=\n", 9)})
        expectRefusal(content, testing::_);
    EXPECT_THROW(GrabberFile(folder_ / "none.ini"), std::runtime_error);
    EXPECT_THROW(GrabberFile(folder_.path()), std::runtime_error) << "a folder";
}

}  // namespace
}  // namespace offmap::live
