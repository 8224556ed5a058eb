// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/VelodyneModel.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>

namespace offmap::rawlog {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;
using mrpt::math::TPoint3Df;

/// Every model and return mode, in the simulated office.
class VelodyneModes : public testing::TestWithParam<std::string> {
 protected:
    VelodyneModes() {
        const std::string mode = GetParam();
        scan_ = *(mode == "Vlp16"       ? robot_.vlp16(75)
                  : mode == "Vlp16Dual" ? robot_.vlp16Dual(150)
                  : mode == "Hdl32"     ? robot_.hdl32(180)
                                        : robot_.hdl64(348));
        dual_ = mode == "Vlp16Dual";
    }

    void generateCloud(Scan& scan) const {
        scan.minRange = 0;
        scan.maxRange = 1000;
        Scan::TGeneratePointCloudParameters all;
        all.minDistance = 0;
        all.generatePerPointTimestamp = all.generatePerPointAzimuth = true;
        all.generatePointsForLaserID = true;
        scan.generatePointCloud(all);
    }

    /// Slots in the order in which MRPT makes points of them: of every block the first 16, of
    /// equal pairs the first.
    std::vector<size_t> slotsOfMrpt() const {
        std::vector<size_t> slots;
        for (size_t slot = 0; slot < scanClass_.slotCount(scan_); ++slot) {
            const uint16_t distance = distanceOf(returnInSlot(scan_, slot));
            if (slot % 32 >= 16 || distance == 0) continue;
            const bool second = dual_ && slot / 32 % 2 == 1;
            if (second && distance == distanceOf(returnInSlot(scan_, slot - 32))) continue;
            slots.push_back(slot);
        }
        return slots;
    }

    /// Equal pairs go together, as they do after a reduction.
    std::vector<uint8_t> randomPairMask(uint32_t seed) const {
        auto keep = test::randomMask(scanClass_.slotCount(scan_), seed);
        for (size_t slot = 0; dual_ && slot < keep.size(); ++slot) {
            if (slot / 32 % 2 == 0) continue;
            const auto &a = returnInSlot(scan_, slot - 32), &b = returnInSlot(scan_, slot);
            if (distanceOf(a) == distanceOf(b)) keep[slot] = keep[slot - 32];
        }
        return keep;
    }

    Scan withOnly(const std::vector<uint8_t>& keep, Leftovers leftovers) const {
        return dynamic_cast<const Scan&>(*scanClass_.withOnly(scan_, keep, leftovers));
    }

    test::SimulatedRobot robot_;
    Scan scan_;
    bool dual_ = false;
    const VelodyneScan scanClass_;
};

TEST_P(VelodyneModes, allLasersAreDecoded) {
    const VelodyneReturns decoded = decodePackets(scan_);
    std::map<int, size_t> returns;
    for (const uint8_t laser : decoded.lasers) ++returns[laser];
    EXPECT_EQ(returns.size(), modelOf(scan_).lasers);
    size_t all = 0;
    for (size_t slot = 0; slot < scanClass_.slotCount(scan_); ++slot) {
        all += distanceOf(returnInSlot(scan_, slot)) != 0;
    }
    EXPECT_EQ(decoded.points.size(), all);
    // The office is closed: every laser meets something nearly always.
    const size_t firings = decoded.firings.size() * (dual_ ? 2 : 1);
    for (const auto& [laser, count] : returns) EXPECT_GT(count, firings * 9 / 10) << laser;
}

TEST_P(VelodyneModes, whatMrptDecodesIsTheSame) {
    const VelodyneReturns decoded = decodePackets(scan_, {.correctAzimuth = false});
    std::map<size_t, TPoint3Df> ofSlot;
    for (size_t i = 0; i < decoded.points.size(); ++i) ofSlot[decoded.slots[i]] = decoded.points[i];
    generateCloud(scan_);
    const auto slots = slotsOfMrpt();
    ASSERT_EQ(scan_.point_cloud.size(), slots.size());
    ASSERT_GT(slots.size(), 10000U);
    const double floats = 4e-7;  // relative, of single precision coordinates
    for (size_t m = 0; m < slots.size(); ++m) {
        const auto& cloud = scan_.point_cloud;
        const TPoint3Df p = ofSlot.at(slots[m]), q(cloud.x[m], cloud.y[m], cloud.z[m]);
        EXPECT_NEAR(q.z, p.z, floats * 30);
        EXPECT_NEAR(std::hypot(q.x, q.y), std::hypot(p.x, p.y), floats * 30);
        // [1/100 deg] MRPT rounds azimuths to whole ones, and its table of sines has 35,999 steps
        // to the circle instead of 36,000, which adds between 0 and 1.
        const double clockwise = std::atan2(p.y, p.x) - std::atan2(q.y, q.x);
        const double off = 100 * mrpt::RAD2DEG(mrpt::math::wrapToPi(clockwise));
        EXPECT_GE(off, -0.5 - 100 * mrpt::RAD2DEG(floats)) << "point " << m;
        EXPECT_LE(off, 1.5 + 100 * mrpt::RAD2DEG(floats)) << "point " << m;
    }
}

TEST_P(VelodyneModes, keptAndRemovedTogetherAreTheOriginal) {
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(scanClass_.slotCount(scan_), seed);
        Scan kept = withOnly(keep, Leftovers::Keep);
        const Scan removed = withOnly(test::complementOf(keep), Leftovers::Drop);
        for (size_t slot = 0; slot < keep.size(); ++slot) {
            EXPECT_EQ(distanceOf(returnInSlot(keep[slot] ? removed : kept, slot)), 0);
            if (keep[slot]) continue;
            kept.scan_packets[slot / 384].blocks[slot / 32 % 12].laser_returns[slot % 32] =
                returnInSlot(removed, slot);
        }
        EXPECT_EQ(test::bytesOf(kept) == test::bytesOf(scan_), true) << "seed " << seed;
    }
}

TEST_P(VelodyneModes, storedCloudFollowsItsReturns) {
    generateCloud(scan_);
    const auto keep = randomPairMask(7);
    const Scan kept = withOnly(keep, Leftovers::Keep);
    const Scan removed = withOnly(test::complementOf(keep), Leftovers::Drop);
    EXPECT_EQ(kept.point_cloud.size() + removed.point_cloud.size(), scan_.point_cloud.size());
    // What MRPT makes of the reduced packets is what the reduced cloud must hold.
    Scan again = kept;
    generateCloud(again);
    EXPECT_EQ(test::bytesOf(again) == test::bytesOf(kept), true);
}

// Each column is a plane of equal azimuth: a flat wall is a vertical line in it.
TEST_P(VelodyneModes, wallsAreRemoved) {
    const core::LineMap map(mapOf(evaluation::officeRoom()));
    const test::DrivenVehicle poses{robot_.pose};
    TurnReducer reducer(map, poses, {}, OutputClass::Same);
    const auto record = reducer.reduce({std::make_shared<Scan>(scan_)}, scanClass_).record;
    const auto returns = static_cast<double>(record.counts.returns);
    const auto removed = static_cast<double>(record.removed());
    RecordProperty("removed", std::to_string(removed / returns));
    EXPECT_GT(removed / returns, 0.3);
}

TEST_P(VelodyneModes, timeReferenceSaysWhichPacketTheTimeIsOf) {
    using std::chrono::duration;
    const auto firstTime = [&](TimeReference reference) {
        const auto& scan = decodePackets(scan_, {.timeReference = reference}).firings;
        return duration<double, std::micro>(scan.front().time - scan_.timestamp).count();
    };
    const auto& last = scan_.scan_packets.back();
    uint32_t lastStamp = 0;  // stands at an odd address, where MRPT's accessor binds a reference
    std::memcpy(&lastStamp, reinterpret_cast<const char*>(&last) + sizeof last.blocks, 4);
    const double tick = 0.5;  // [us] half of one, rounded down
    EXPECT_EQ(firstTime(TimeReference::First), 0);
    EXPECT_NEAR(firstTime(TimeReference::Middle), -0.5 * lastStamp, tick);
    EXPECT_NEAR(firstTime(TimeReference::Last), -1.0 * lastStamp, tick);
}

INSTANTIATE_TEST_SUITE_P(Models, VelodyneModes,
                         testing::Values("Vlp16", "Vlp16Dual", "Hdl32", "Hdl64"),
                         [](const auto& mode) { return mode.param; });

}  // namespace
}  // namespace offmap::rawlog
