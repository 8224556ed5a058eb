// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ScanBuilder.h"

#include <offmap/core/Reducer.h>

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace offmap::core {

using mrpt::poses::CPose3D;

namespace {

constexpr int walls = 4, boxes = 3;
constexpr double darkSigma = 0.06, brightSigma = 0.015;  // [m]

/// The walls to the left and behind are dark.
bool isDark(int surface) { return surface == 2 || surface == 3; }

/// A room of 8 x 6 m. Before its bright walls stand boxes, 15 cm and more away.
std::vector<test::Slab> roomWithBoxes() {
    auto slabs = test::boxRoom(8, 6);
    slabs.push_back({{{3.85, -1.5}, {3.85, -0.7}}, 0, 1.2});
    slabs.push_back({{{3.8, 0.6}, {3.8, 1.6}}, 0.4, 1.6});
    slabs.push_back({{{-1.0, -2.85}, {0.2, -2.85}}, 0, 0.9});
    return slabs;
}

/// What is set where the noise does not depend on the return.
struct SingleSigma {
    double sigma, maxPointToLine;  // [m]
};

struct Outcome {
    double darkRemoved, brightRemoved, unmappedRemoved;  // shares
};

class NoisyRoom {
 public:
    NoisyRoom() {
        const auto slabs = roomWithBoxes();
        const Eigen::Matrix3d covariance =
            Eigen::Vector3d(0.03 * 0.03, 0.03 * 0.03, 0.01 * 0.01).asDiagonal();
        built = test::ScanBuilder(slabs, {0.4, -0.3, 1.1, 0.2, 0, 0}).build({}, covariance);
        auto mapped = test::wallsOf(std::span(slabs).first(walls), 0.01);
        map = std::make_unique<LineMap>(mapped);
        std::mt19937 random(1);
        std::normal_distribution<float> normal;
        for (size_t i = 0; i < built.surface.size(); ++i) {
            const double sigma = isDark(built.surface[i]) ? darkSigma : brightSigma;
            auto& point = built.scan.points[i];
            const float range = point.norm();
            point *= 1 + static_cast<float>(sigma) * normal(random) / range;
            sigmas.push_back(static_cast<float>(sigma));
        }
    }

    Outcome reduced(const SingleSigma& single) const {
        ReductionConfig config;
        config.alignment.sigmaRange = single.sigma;
        config.vertical.maxPointToLine = single.maxPointToLine;
        return reduced(built.scan, config);
    }
    Outcome reducedByReturn() const {
        OrganizedScan scan = built.scan;
        scan.rangeSigma = sigmas;
        return reduced(scan, {});
    }

 private:
    Outcome reduced(const OrganizedScan& scan, ReductionConfig config) const {
        config.matching.method = MatchingMethod::Aligned;
        Reducer reducer(*map, config);
        const ReductionResult& result = reducer.reduce(scan);
        double counts[3] = {}, removed[3] = {};
        for (size_t i = 0; i < built.surface.size(); ++i) {
            const int surface = built.surface[i];
            const int kind = surface < 0 || surface >= walls ? 2 : isDark(surface) ? 0 : 1;
            ++counts[kind];
            removed[kind] += result.labels[i] == PointLabel::Mapped;
        }
        return {removed[0] / counts[0], removed[1] / counts[1], removed[2] / counts[2]};
    }

    test::BuiltScan built;
    std::unique_ptr<LineMap> map;
    std::vector<float> sigmas;
};

}  // namespace

// Split at 5 cm, a wall with 6 cm of noise falls to pieces.
TEST(RangeSigma, ofEachReturnRemovesNoisyWallsToo) {
    const NoisyRoom room;
    const Outcome table = room.reducedByReturn(), single = room.reduced({0.02, 0.05});
    EXPECT_GT(table.darkRemoved, 0.95);
    EXPECT_GT(table.brightRemoved, 0.98);
    EXPECT_LT(single.darkRemoved, 0.5);
    // Returns at a wall's foot, or just over a box, may change sides with the pose: one in each
    // of 180 columns of bright wall would be 1 %, half of them 0.5 %.
    EXPECT_GT(table.brightRemoved, single.brightRemoved - 0.005);
    EXPECT_LT(table.unmappedRemoved, 0.001);
}

// A sigma, and a tolerance, that suit the dark walls take boxes for the bright ones.
TEST(RangeSigma, ofEachReturnSparesWhatOneForAllTakes) {
    const NoisyRoom room;
    const Outcome table = room.reducedByReturn(), single = room.reduced({darkSigma, 3 * darkSigma});
    EXPECT_GT(single.unmappedRemoved, 10 * table.unmappedRemoved);
    EXPECT_GT(table.brightRemoved, single.brightRemoved);
    EXPECT_GT(table.darkRemoved, single.darkRemoved - 0.01);
}

}  // namespace offmap::core
