// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "RawlogEdit.h"
#include "ReduceFixture.h"

#include <mrpt/maps/CPointsMap.h>

namespace {

using namespace offmap::test;

class Velodynes : public ReduceFixture, public testing::WithParamInterface<const char*> {
 protected:
    mrpt::obs::CObservation::Ptr turn() {
        const std::string model = GetParam();
        if (model == "Hdl32") return robot_.hdl32();
        if (model == "Hdl64") return robot_.hdl64();
        return robot_.vlp16Dual();
    }

    std::vector<Return> returnsIn(const Path& log) const {
        return returnsOf(*observationsOf(log).at(1));
    }

    SimulatedRobot robot_;
    const Path removed_ = folder_ / "removed.rawlog";
};

TEST_P(Velodynes, keepTheirClassAndLoseTheirWalls) {
    const Observations log{robot_.localisation(), turn()};
    for (const bool frames : {false, true}) {
        frames ? writeLog(in_, inFrames(log, 1)) : writeLog(in_, log);
        const RunResult run = reduce({"--removed", removed_, "--strict", "--force"});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const auto original = returnsIn(in_), kept = returnsIn(out_), removed = returnsIn(removed_);
        EXPECT_TRUE(together(kept, removed) == original);
        // Most of what a scanner sees in a room of 8 by 5 m is walls; persons and floor stay.
        EXPECT_GT(removed.size(), original.size() / 2);
        EXPECT_GT(kept.size(), original.size() / 20);
        EXPECT_TRUE(std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(
            observationsOf(out_).at(1)));
        expectRawlogEditReads(out_, in_);
        expectRawlogEditReads(removed_, in_);
    }
}

TEST_P(Velodynes, becomePointClouds) {
    writeLog(in_, Observations{robot_.localisation(), turn()});
    ASSERT_EQ(reduce({"--output", "points", "--strict"}).exitCode, 0);
    const auto cloud =
        std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(observationsOf(out_).at(1));
    ASSERT_TRUE(cloud);
    EXPECT_GT(cloud->pointcloud->size(), 1000U);
    EXPECT_LT(cloud->pointcloud->size(), returnsIn(in_).size() / 2);
}

INSTANTIATE_TEST_SUITE_P(Models, Velodynes, testing::Values("Hdl32", "Hdl64", "Vlp16Dual"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
