// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <chrono>

namespace offmap::test {
namespace {

using testing::HasSubstr;

class Live : public ReduceFixture {
 protected:
    RunResult live(const std::string& source, const Arguments& more = {}) const {
        Arguments all{"live", source, "--map", map_};
        all.insert(all.end(), more.begin(), more.end());
        return runOffmap(all);
    }

    /// Five clouds between two poses.
    void writeClouds() const {
        SimulatedRobot robot;
        Observations log{robot.localisation()};
        for (int i = 0; i < 5; ++i) {
            robot.wait(0.05);
            log.push_back(robot.cloud());
        }
        log.push_back(robot.localisation());
        writeLog(in_, log);
    }
};

TEST_F(Live, recordsWhatTheBatchWrites) {
    writeClouds();
    const Path recorded = folder_ / "recorded.rawlog";
    const RunResult run = live(in_, {"--speed", "max", "--record", recorded});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("of 5 that came"));
    ASSERT_EQ(reduce().exitCode, 0);
    const auto clouds = [](const Path& log) {
        Observations all = observationsOf(log);
        std::erase_if(all, [](const auto& obs) { return obs->sensorLabel != "CLOUD"; });
        return all;
    };
    const Observations batch = clouds(out_), alive = clouds(recorded);
    ASSERT_EQ(alive.size(), 5U);
    for (size_t i = 0; i < 5; ++i) {
        using Cloud = mrpt::obs::CObservationPointCloud;
        const auto expected = std::dynamic_pointer_cast<Cloud>(batch[i]);
        const auto found = std::dynamic_pointer_cast<Cloud>(alive[i]);
        EXPECT_EQ(found->pointcloud->size(), expected->pointcloud->size()) << i;
    }
}

TEST_F(Live, takesTheTimeThatTheLogTook) {
    writeClouds();
    const auto begin = std::chrono::steady_clock::now();
    const RunResult run = live(in_, {"--speed", "1"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(took.count(), 0.2) << "from the first cloud to the last";
}

TEST_F(Live, endsAfterTheTimeThatItIsGiven) {
    const RunResult run = live("udp:42368", {"--pose", "2,2.5,17", "--seconds", "0.3", "--quiet"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("of 0 that came"));
}

TEST_F(Live, saysWhatASensorOfAnIniFileIsInTroubleWith) {
    const Path ini = folder_ / "sensors.ini";
    writeFile(ini,
              "[Top]\ndriver = CVelodyneScanner\nmodel = VLP16\nprocess_rate = 1000\n"
              "pcap_input = /nowhere.pcap\n");
    const RunResult run = live(ini, {"--pose", "2,2.5,17", "--seconds", "0.5"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("1 sensor"));
    EXPECT_THAT(run.out, HasSubstr("[Top] Error opening PCAP file: '/nowhere.pcap"));
}

TEST_F(Live, refusesWhatCannotBeMeant) {
    const Arguments none;
    const auto refused = [&](const std::string& source, const Arguments& more, int exitCode,
                             const char* message) {
        Arguments all{"live", source, "--map", map_};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, exitCode, HasSubstr(message));
    };
    refused("udp", none, 1, "--track");
    refused("udp:0", {"--pose", "0,0,0"}, 1, "1 ... 65535");
    refused("udp", {"--track", "0,0,0", "--method", "paper"}, 1, "--method aligned");
    refused(folder_ / "none.pcap", {"--pose", "0,0,0"}, 2, "none.pcap");
    refused(folder_ / "none.rawlog", none, 2, "none.rawlog");
    refused(folder_ / "none.rawlog", {"--follow"}, 2, "none.rawlog");
    refused(folder_ / "none.ini", none, 2, "none.ini");
    writeFile(folder_ / "bad.ini", "[Top]\ndriver = CNoSuchThing\nprocess_rate = 1\n");
    refused(folder_ / "bad.ini", none, 2, "[Top]: driver = CNoSuchThing");
    refused(map_, none, 2, "not a rawlog");
    refused("udp", {"--pose", "0,0,0", "--speed", "-1"}, 1, "--speed");
}

}  // namespace
}  // namespace offmap::test
