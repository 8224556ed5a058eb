// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PiecewiseSource.h"
#include "TurnsInMemory.h"

#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace offmap::live {

inline constexpr auto longEnough = std::chrono::seconds(60);

/// What becomes of a PiecewiseSource's turns, the look-ups of poses counted.
class TurnsInPieces : public testing::Test {
 protected:
    TurnsInPieces() { countLookups(test::officeSetup().poses); }

    void countLookups(std::shared_ptr<const rawlog::PoseSource> poses) {
        setup_.poses = poses_ = std::make_shared<test::CountedPoses>(std::move(poses));
    }

    std::vector<LiveFramePtr> framesOf(std::unique_ptr<test::PiecewiseSource> source) {
        std::vector<LiveFramePtr> frames;
        LiveReduction reduction(
            std::move(source), setup_,
            {.onFrame = [&](const LiveFramePtr& frame) { frames.push_back(frame); }});
        EXPECT_TRUE(reduction.waitUntilFinished(longEnough));
        EXPECT_EQ(reduction.failure(), "");
        return frames;
    }

    static void expectAsWhole(const LiveFrame& frame, const LiveSetup& setup) {
        rawlog::TurnReducer whole(*setup.map, *setup.poses, setup.config, setup.output);
        const auto expected = whole.reduce(frame.arrived.turn, rawlog::VelodyneScan());
        EXPECT_EQ(frame.reduced.removedSlots, expected.removedSlots);
        EXPECT_EQ(frame.reduced.organized.scan.points, expected.organized.scan.points);
        EXPECT_EQ(frame.result.labels, whole.result().labels);
        EXPECT_EQ(frame.reduced.record.counts.zero, expected.record.counts.zero);
        EXPECT_GT(expected.record.removed(), 0U);
    }

    LiveSetup setup_ = test::officeSetup();
    std::shared_ptr<test::CountedPoses> poses_;
};

}  // namespace offmap::live
