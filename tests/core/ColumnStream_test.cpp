// SPDX-License-Identifier: BSD-3-Clause
#include "SmallRoom.h"

#include <offmap/core/Reducer.h>

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace offmap::core {

namespace {

constexpr MatchingMethod methods[] = {MatchingMethod::Paper, MatchingMethod::Probabilistic,
                                      MatchingMethod::Aligned};

ReductionConfig configOf(MatchingMethod method) {
    ReductionConfig config;
    config.matching.method = method;
    config.orphan.remove = true;
    return config;
}

/// What of a scan has been taken, column by column.
class Turning {
 public:
    explicit Turning(const OrganizedScan& whole) : whole_(whole) {}

    bool complete() const { return scan_.columns.size() == whole_.columns.size(); }
    const OrganizedScan& scan() const { return scan_; }

    void take() {
        const ScanColumn& column = whole_.columns[scan_.columns.size()];
        const auto append = [&](auto& to, const auto& from) {
            if (from.empty()) return;
            to.insert(to.end(), from.begin() + column.begin, from.begin() + column.end);
        };
        append(scan_.points, whole_.points);
        append(scan_.sourceIndex, whole_.sourceIndex);
        append(scan_.rangeSigma, whole_.rangeSigma);
        scan_.columns.push_back(column);
    }

 private:
    const OrganizedScan& whole_;
    OrganizedScan scan_;
};

auto fieldsOf(const VerticalSegment& s) {
    return std::tuple(s.column, s.begin, s.end, s.bottom.x, s.bottom.y, s.top.x, s.top.y, s.slope,
                      s.centre.x, s.centre.y);
}

auto fieldsOf(const SegmentMatch& m) {
    return std::tuple(m.verdict, m.reason, m.wall, m.measured.min(), m.measured.max(), m.residual);
}

void expectSame(const ReductionResult& a, const ReductionResult& b) {
    EXPECT_EQ(a.labels, b.labels);
    ASSERT_EQ(a.segments.size(), b.segments.size());
    ASSERT_EQ(a.matches.size(), b.matches.size());
    for (size_t s = 0; s < a.segments.size(); ++s) {
        EXPECT_EQ(fieldsOf(a.segments[s]), fieldsOf(b.segments[s])) << "segment " << s;
        EXPECT_EQ(fieldsOf(a.matches[s]), fieldsOf(b.matches[s])) << "segment " << s;
    }
    EXPECT_EQ(a.notReduced, b.notReduced);
    EXPECT_EQ(a.columnsWithoutPose, b.columnsWithoutPose);
    EXPECT_EQ(a.alignment.has_value(), b.alignment.has_value());
}

}  // namespace

TEST(ColumnStream, anyPortionsComeToWhatTheWholeScanDoes) {
    const test::SmallRoom room;
    OrganizedScan scan = room.built.scan;
    scan.columns[2].sensor.reset();
    std::mt19937 random(7);
    for (const bool noisy : {false, true}) {
        if (noisy) scan.rangeSigma.assign(scan.points.size(), 0.02F);
        for (const MatchingMethod method : methods) {
            Reducer whole(room.map, configOf(method)), pieces(room.map, configOf(method));
            const ReductionResult& expected = whole.reduce(scan);
            ASSERT_FALSE(expected.segments.empty());
            for (const size_t most : {1, 5, 1000}) {
                SCOPED_TRACE("at most " + std::to_string(most) + " columns at once");
                Turning turning(scan);
                pieces.begin();
                while (!turning.complete()) {
                    for (size_t n = 1 + random() % most; n > 0 && !turning.complete(); --n) {
                        turning.take();
                    }
                    pieces.add(turning.scan());
                }
                expectSame(pieces.finish(turning.scan()), expected);
            }
        }
    }
}

TEST(ColumnStream, columnsComeWithTheirSegmentsAndWhatTheirRaysMeet) {
    const test::SmallRoom room;
    ReductionConfig config = configOf(MatchingMethod::Paper);
    config.extension.enabled = config.orphan.remove = false;  // what needs neighbours
    Reducer whole(room.map, config), pieces(room.map, config);
    const ReductionResult& expected = whole.reduce(room.built.scan);
    Turning turning(room.built.scan);
    size_t s = 0;
    while (!turning.complete()) {
        turning.take();
        const auto [segments, matches] = pieces.add(turning.scan());
        ASSERT_EQ(segments.size(), matches.size());
        for (size_t i = 0; i < segments.size(); ++i, ++s) {
            EXPECT_EQ(segments[i].column, turning.scan().columns.size() - 1);
            EXPECT_EQ(fieldsOf(segments[i]), fieldsOf(expected.segments[s]));
            EXPECT_EQ(fieldsOf(matches[i]), fieldsOf(expected.matches[s]));
        }
    }
    EXPECT_EQ(s, expected.segments.size());
    EXPECT_GT(s, 0U);
}

TEST(ColumnStream, aScanThatIsGivenUpLeavesNothing) {
    const test::SmallRoom room;
    for (const MatchingMethod method : methods) {
        Reducer fresh(room.map, configOf(method)), used(room.map, configOf(method));
        Turning turning(room.built.scan);
        for (int i = 0; i < 9; ++i) turning.take();
        used.add(turning.scan());
        expectSame(used.reduce(room.built.scan), fresh.reduce(room.built.scan));
    }
}

}  // namespace offmap::core
