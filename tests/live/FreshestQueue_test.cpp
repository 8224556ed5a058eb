// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/FreshestQueue.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace offmap::live {
namespace {

TEST(FreshestQueue, keepsTheNewestAndCountsTheOthers) {
    FreshestQueue<int> queue(2);
    for (int i = 0; i < 5; ++i) queue.push(i);
    EXPECT_EQ(queue.dropped(), 3U);
    EXPECT_EQ(queue.size(), 2U);
    EXPECT_EQ(queue.pop({}), 3);
    EXPECT_EQ(queue.pop({}), 4);
}

TEST(FreshestQueue, aClosedOneGivesWhatIsLeftAndThenNothing) {
    FreshestQueue<int> queue(2);
    queue.push(1);
    queue.close();
    EXPECT_FALSE(queue.ended());
    EXPECT_EQ(queue.pop({}), 1);
    EXPECT_EQ(queue.pop({}), std::nullopt);
    EXPECT_TRUE(queue.ended());
}

TEST(FreshestQueue, aNudgeEndsOneWait) {
    FreshestQueue<int> queue(2);
    queue.nudge();
    EXPECT_EQ(queue.pop({}), std::nullopt);
    EXPECT_FALSE(queue.ended());
    queue.push(1);
    EXPECT_EQ(queue.pop({}), 1);
}

TEST(FreshestQueue, stoppingEndsAnyWait) {
    FreshestQueue<int> queue(1);
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(queue.pop(stop)); });
    reader.request_stop();
    reader.join();
    queue.push(1);
    std::jthread writer([&](const std::stop_token& stop) { EXPECT_FALSE(queue.pushAll(2, stop)); });
    writer.request_stop();
    writer.join();
    EXPECT_EQ(queue.dropped(), 0U);
}

TEST(FreshestQueue, whoeverWaitsForRoomLosesNothing) {
    constexpr int items = 1000;
    FreshestQueue<int> queue(3);
    std::jthread writer([&](const std::stop_token& stop) {
        for (int i = 0; i < items; ++i) queue.pushAll(i, stop);
        queue.close();
    });
    int expected = 0;
    while (const auto item = queue.pop({})) EXPECT_EQ(*item, expected++);
    EXPECT_EQ(expected, items);
    EXPECT_EQ(queue.dropped(), 0U);
}

TEST(FreshestQueue, withoutRoomIsRefused) {
    EXPECT_THROW(FreshestQueue<int>(0), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::live
