// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;

class FlippedBytes : public ReduceFixture, public testing::WithParamInterface<bool> {};

TEST_P(FlippedBytes, areSurvived) {
    SimulatedRobot robot;
    const Observations log = oneSecondOf(robot);
    GetParam() ? writeLog(in_, inFrames(log), std::nullopt) : writeLog(in_, log, std::nullopt);
    const std::vector<LogEntry> entries = entriesOf(in_);
    const std::string whole = readFile(in_);
    std::mt19937 random(2006);
    int refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        // Every other one in the head of an entry, where the structure is densest.
        std::string damaged = whole;
        if (trial % 2 == 0) {
            damaged = withByteFlipped(whole, whole.size(), random);
        } else {
            size_t begin = 0;
            const size_t last =
                std::uniform_int_distribution<size_t>(0, entries.size() - 1)(random);
            for (size_t i = 0; i < last; ++i) begin += entries[i].bytes.size();
            const size_t head = std::min<size_t>(100, entries[last].bytes.size());
            damaged.replace(begin, std::string::npos,
                            withByteFlipped(whole.substr(begin), head, random));
        }
        refused += !reducesOrRefuses(damaged);
    }
    EXPECT_GT(refused, 50);
}

INSTANTIATE_TEST_SUITE_P(Formats, FlippedBytes, testing::Bool(), [](const auto& format) {
    return format.param ? "SensoryFrames" : "ObservationsOnly";
});

}  // namespace
