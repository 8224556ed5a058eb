// SPDX-License-Identifier: BSD-3-Clause
#include "FigureRows.h"

#include "MadeUpFrame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace offmap::window {

namespace {

using Mood = FigureRow::Mood;

FigureRow rowOf(const std::vector<FigureRow>& rows, const std::string& label) {
    for (const FigureRow& row : rows) {
        if (row.label == label) return row;
    }
    throw std::out_of_range("no figure is called " + label);
}

live::LiveFrame countedFrame() {
    live::LiveFrame frame = test::madeUpFrame();
    auto& record = frame.reduced.record;
    record.counts.returns = 32'761;
    record.removedByRay = 12'000;
    record.removedByPoint = 300;
    record.keptByReason = {0, 1204, 402, 96, 30, 7};
    record.milliseconds = 6.431;
    record.health.matchedShare = 0.95;
    record.health.fit = core::PoseFit{0.0312, 0.004, 0.9, 1.2, 1};
    return frame;
}

}  // namespace

TEST(FigureRows, tellWhatBecameOfTheTurn) {
    const live::LiveFrame frame = countedFrame();
    const auto rows = figuresOf({}, &frame);
    EXPECT_EQ(rowOf(rows, "points").value, "32,761");
    EXPECT_EQ(rowOf(rows, "removed").value, "12,300 (37.5 %)");
    EXPECT_EQ(rowOf(rows, "kept: in front of a wall").value, "1,204");
    EXPECT_EQ(rowOf(rows, "kept: no pose").value, "7");
    EXPECT_EQ(rowOf(rows, "pose correction").value, "0.031 m, 0.23\u00b0");
    EXPECT_EQ(rowOf(rows, "health").value, "fits");
    EXPECT_EQ(rowOf(rows, "health").mood, Mood::Good);
}

TEST(FigureRows, tellHowTheReductionGoes) {
    const live::LiveFrame frame = countedFrame();
    live::LiveFigures figures;
    figures.totals.milliseconds.add(8);
    for (int i = 0; i < 100; ++i) figures.latency.add(i < 98 ? 12 : 150);
    figures.turnsPerSecond = 9.934;
    figures.turnsDropped = 1234;
    const auto rows = figuresOf(figures, &frame);
    // The histogram is true to 0.5 %, so 8 may be 8.04 and 12 may be 12.06.
    EXPECT_TRUE(rowOf(rows, "reduce now, median").value.starts_with("6.43, "));
    EXPECT_NEAR(std::stod(rowOf(rows, "reduce now, median").value.substr(6)), 8, 0.05);
    EXPECT_NEAR(std::stod(rowOf(rows, "latency median, p99").value), 12, 0.11);
    EXPECT_EQ(rowOf(rows, "turns per second").value, "9.93");
    EXPECT_EQ(rowOf(rows, "turns dropped").value, "1,234");
    EXPECT_EQ(rowOf(rows, "turns dropped").mood, Mood::Bad);
    EXPECT_EQ(rowOf(rows, "packets missing").mood, Mood::Plain);
}

TEST(FigureRows, withoutATurnHaveTheSameLabels) {
    const live::LiveFrame frame = countedFrame();
    const auto without = figuresOf({}, nullptr), with = figuresOf({}, &frame);
    ASSERT_EQ(without.size(), with.size());
    for (size_t i = 0; i < with.size(); ++i) EXPECT_EQ(without[i].label, with[i].label);
    EXPECT_EQ(rowOf(without, "points").value, "-");
    EXPECT_EQ(rowOf(without, "health").value, "-");
}

TEST(FigureRows, everyReasonToKeepIsCountedOnce) {
    const auto rows = figuresOf({}, nullptr);
    for (size_t r = 1; r < core::keepReasonCount; ++r) {
        EXPECT_EQ(std::count_if(rows.begin(), rows.end(),
                                [&](const FigureRow& row) {
                                    return row.reason == static_cast<core::KeepReason>(r);
                                }),
                  1)
            << r;
    }
}

TEST(FigureRows, aSuspectTurnSaysWhy) {
    live::LiveFrame frame = countedFrame();
    frame.reduced.record.health.suspect = core::Suspicion::FewMatches;
    const FigureRow row = rowOf(figuresOf({}, &frame), "health");
    EXPECT_EQ(row.value, "suspect: shows few of the map's walls");
    EXPECT_EQ(row.mood, Mood::Bad);
}

TEST(FigureRows, aTurnKeptWholeSaysWhy) {
    live::LiveFrame frame = countedFrame();
    frame.reduced.record.notReduced = "pose_too_old";
    EXPECT_EQ(rowOf(figuresOf({}, &frame), "health").value, "kept whole: pose too old");
}

TEST(FigureRows, aTurnThatSawNoWallsIsNotCalledFitting) {
    live::LiveFrame frame = countedFrame();
    frame.reduced.record.health.matchedShare.reset();
    EXPECT_EQ(rowOf(figuresOf({}, &frame), "health").value, "no walls seen");
    EXPECT_EQ(rowOf(figuresOf({}, &frame), "health").mood, Mood::Plain);
}

TEST(FigureRows, aSourceThatFailsSaysWhy) {
    live::LiveFigures figures;
    figures.source.state = live::SourceState::Failed;
    figures.source.message = "port 2368 is in use";
    const FigureRow row = rowOf(figuresOf(figures, nullptr), "source");
    EXPECT_EQ(row.value, "failed: port 2368 is in use");
    EXPECT_EQ(row.mood, Mood::Bad);
}

TEST(FigureRows, anEmptyScanHasNoShare) {
    const live::LiveFrame frame;
    EXPECT_EQ(rowOf(figuresOf({}, &frame), "removed").value, "0");
}

}  // namespace offmap::window
