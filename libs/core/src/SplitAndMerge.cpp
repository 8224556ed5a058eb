// SPDX-License-Identifier: BSD-3-Clause
#include "LaneFit.h"
#include "OffsetsFromLine.h"
#include "RunWithoutGap.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace offmap::core {

using mrpt::math::TPoint2D;
using Run = SplitAndMergeScratch::Run;
using StraightRun = SplitAndMergeScratch::StraightRun;

namespace {

/// What came of fitting a line to a run.
struct Trial {
    std::optional<ScaledLine> line;  // none: a glance tells that no line serves the run
    bool serves;
};

/// What is split: points, and how far each may be off.
class Splitting {
 public:
    Splitting(const PlanePoints& points, const SplitAndMergeConfig& config)
        : points_(points), config_(config) {}

    void cutAtGaps(std::vector<Run>& runs) const;
    Trial tried(Run& run) const;
    std::pair<Run, Run> split(const Run& run, const std::optional<ScaledLine>& line) const;
    bool straysAlone(const Run& run, uint32_t point, const ScaledLine& line) const;
    void append(StraightRun last, std::vector<StraightRun>& straight) const;
    LinePiece pieceOf(const StraightRun& run) const;
    void settleSeam(StraightRun& first, StraightRun& second) const;
    bool longEnough(const LinePiece& piece) const;

 private:
    uint32_t leastPoints() const { return std::max(config_.minPoints, 1u); }
    bool isGap(uint32_t before) const { return isGapBehind(points_, before, config_.maxGap); }
    bool serves(const ScaledLine& line, const Run& run) const {
        return !offsets(run, line).anyBeyond(config_.maxPointToLine);
    }
    LineFit fitTo(uint32_t begin, uint32_t end) const { return fitOf(points_.range(begin, end)); }
    std::pair<Run, Run> partsOf(const Run& run, uint32_t end, uint32_t begin) const;
    OffsetsFromLine offsets(const Run& run, const ScaledLine& line) const;
    ScaledLine chordOf(const Run& run) const;
    bool mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const;
    bool mayBeStraight(const Run& run) const {
        return mayBeStraight(run.begin, run.begin + (run.end - run.begin) / 2, run.end - 1);
    }

    const PlanePoints& points_;
    const SplitAndMergeConfig& config_;
};

/// Runs without gaps that are worth a look, the first one on top.
void Splitting::cutAtGaps(std::vector<Run>& runs) const {
    runs.clear();
    for (auto end = static_cast<uint32_t>(points_.size()); end > 0;) {
        const uint32_t begin = beginOfRunWithoutGap(points_, end, config_.maxGap);
        if (end - begin >= leastPoints()) runs.push_back({begin, end, {}});
        end = begin;
    }
}

OffsetsFromLine Splitting::offsets(const Run& run, const ScaledLine& line) const {
    const auto slack = config_.slack.empty()
                           ? config_.slack
                           : config_.slack.subspan(run.begin, run.end - run.begin);
    return {points_.range(run.begin, run.end), slack, line};
}

ScaledLine Splitting::chordOf(const Run& run) const {
    const TPoint2D from = points_[run.begin], along = points_[run.end - 1] - from;
    const double squaredLength = along.sqrNorm();
    return squaredLength > 0 ? ScaledLine{from, along, squaredLength} : ScaledLine{from, {1, 0}, 1};
}

/// Three points that one line serves form a triangle no higher than twice the tolerance: most
/// corners are told so, without a fit.
bool Splitting::mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const {
    if (!config_.slack.empty()) return true;
    const TPoint2D toBetween = points_[between] - points_[first];
    const TPoint2D toLast = points_[last] - points_[first];
    const double twiceArea = toBetween.x * toLast.y - toBetween.y * toLast.x;
    const double longest =
        std::max({toBetween.sqrNorm(), toLast.sqrNorm(), (toLast - toBetween).sqrNorm()});
    constexpr double rounding = 1 + 1e-5;
    const double highest = 2 * rounding * config_.maxPointToLine;
    return twiceArea * twiceArea <= highest * highest * longest;
}

Trial Splitting::tried(Run& run) const {
    const bool few = run.end - run.begin <= 2;
    if (!few && !mayBeStraight(run)) return {std::nullopt, false};
    if (run.fit.count() == 0) run.fit = fitTo(run.begin, run.end);
    const ScaledLine line = run.fit.scaledLine();
    return {line, few || serves(line, run)};
}

/// Whether a point strays from a line alone, those beside it do not: by noise, then.
bool Splitting::straysAlone(const Run& run, uint32_t point, const ScaledLine& line) const {
    const FittedLine fitted = line.withUnitVector();
    const auto isNear = [&](uint32_t i) {
        const double slack = config_.slack.empty() ? 0 : static_cast<double>(config_.slack[i]);
        return fitted.distance(points_[i]) <= config_.maxPointToLine + slack;
    };
    return (point == run.begin || isNear(point - 1)) && (point + 1 == run.end || isNear(point + 1));
}

/// Splits a run that its line does not serve. If one point strays from that line alone, at it: its
/// chord has the noise of two points. The point is left out if either side of it would be a piece
/// even if it were cut once more: near an end, it may be what a floor begins with. Else at the
/// point furthest from its chord, which mostly is a corner; it begins the second part. \param line
/// of its trial
std::pair<Run, Run> Splitting::split(const Run& run, const std::optional<ScaledLine>& line) const {
    const auto before = [&](uint32_t point) {
        const uint32_t at = std::clamp(point, run.begin + 1, run.end - 1);
        return partsOf(run, at, at);
    };
    if (line) {
        const uint32_t stray = run.begin + offsets(run, *line).furthest().point;
        if (straysAlone(run, stray, *line)) {
            const uint32_t shorter = std::min(stray - run.begin, run.end - (stray + 1));
            const bool nearAnEnd = shorter < 2 * leastPoints();
            return nearAnEnd ? before(stray) : partsOf(run, stray, stray + 1);
        }
    }
    return before(run.begin + offsets(run, chordOf(run)).furthest().point);
}

/// What ends at `end`, and what begins at `begin`. Where the run has been fitted, sums are taken of
/// the smaller part; the larger one has the rest.
std::pair<Run, Run> Splitting::partsOf(const Run& run, uint32_t end, uint32_t begin) const {
    std::pair<Run, Run> parts({run.begin, end, run.fit}, {begin, run.end, run.fit});
    if (run.fit.count() == 0) return parts;
    const bool firstIsSmaller = end - run.begin < run.end - begin;
    Run& smaller = firstIsSmaller ? parts.first : parts.second;
    Run& larger = firstIsSmaller ? parts.second : parts.first;
    smaller.fit = fitTo(smaller.begin, smaller.end);
    larger.fit.remove(smaller.fit);
    if (begin > end) larger.fit.remove(fitTo(end, begin));
    return parts;
}

/// Merges a straight run with the ones before it while one line serves both.
void Splitting::append(StraightRun last, std::vector<StraightRun>& straight) const {
    while (!straight.empty() && straight.back().end == last.begin && !isGap(last.begin - 1)) {
        const StraightRun& before = straight.back();
        if (!mayBeStraight(before.begin, last.begin, last.end - 1)) break;
        LineFit fit = before.fit;
        fit.add(last.fit);
        const ScaledLine line = fit.scaledLine();
        // The smaller of the two mostly tells.
        const bool beforeIsSmaller = before.end - before.begin < last.end - last.begin;
        const Run &smaller = beforeIsSmaller ? before : last,
                  &larger = beforeIsSmaller ? last : before;
        if (!serves(line, smaller) || !serves(line, larger)) break;
        last = {{before.begin, last.end, fit}, line};
        straight.pop_back();
    }
    straight.push_back(last);
}

LinePiece Splitting::pieceOf(const StraightRun& run) const {
    return {run.begin, run.end, run.line.withUnitVector()};
}

/// Splitting gives the points beside a corner to one piece or the other as the order has it. Moves
/// the seam of two pieces, so that each point there belongs to the line it is nearer to.
void Splitting::settleSeam(StraightRun& first, StraightRun& second) const {
    uint32_t seam = first.end;
    if (seam != second.begin || isGap(seam - 1)) return;
    const LinePiece ofFirst = pieceOf(first), ofSecond = pieceOf(second);
    const auto claims = [&](const LinePiece& piece, const LinePiece& other, uint32_t i) {
        return piece.end - piece.begin >= config_.minPoints &&
               piece.line.distance(points_[i]) < other.line.distance(points_[i]);
    };
    while (seam + 1 < second.end && claims(ofFirst, ofSecond, seam)) ++seam;
    while (seam - 1 > first.begin && claims(ofSecond, ofFirst, seam - 1)) --seam;
    if (seam == first.end) return;
    const bool grows = seam > first.end;
    const LineFit moved = grows ? fitTo(first.end, seam) : fitTo(seam, first.end);
    Run before{first.begin, seam, first.fit}, behind{seam, second.end, second.fit};
    (grows ? before : behind).fit.add(moved);
    (grows ? behind : before).fit.remove(moved);
    const Trial ofBefore = tried(before);
    if (!ofBefore.serves) return;
    const Trial ofBehind = tried(behind);
    if (!ofBehind.serves) return;
    first = {before, *ofBefore.line};
    second = {behind, *ofBehind.line};
}

bool Splitting::longEnough(const LinePiece& piece) const {
    if (piece.end - piece.begin < config_.minPoints) return false;
    const double first = piece.line.along(points_[piece.begin]);
    if (std::abs(piece.line.along(points_[piece.end - 1]) - first) >= config_.minLength)
        return true;
    double low = first, high = first;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
        const double coordinate = piece.line.along(points_[i]);
        low = std::min(low, coordinate);
        high = std::max(high, coordinate);
    }
    return high - low >= config_.minLength;
}

}  // namespace

OFFMAP_BY_PROCESSOR [[gnu::flatten]] std::span<const LinePiece> splitAndMerge(
    const PlanePoints& points, const SplitAndMergeConfig& config, SplitAndMergeScratch& scratch) {
    auto& [pending, straight, pieces, x, y] = scratch;
    const Splitting splitting(points, config);
    straight.clear();
    pieces.clear();
    splitting.cutAtGaps(pending);
    while (!pending.empty()) {
        Run run = pending.back();
        pending.pop_back();
        const Trial trial = splitting.tried(run);
        if (trial.serves) {
            splitting.append({run, *trial.line}, straight);
            continue;
        }
        const auto [first, second] = splitting.split(run, trial.line);
        pending.push_back(second);
        pending.push_back(first);
    }
    for (size_t i = 1; i < straight.size(); ++i) splitting.settleSeam(straight[i - 1], straight[i]);
    for (const StraightRun& run : straight) {
        const LinePiece piece = splitting.pieceOf(run);
        if (splitting.longEnough(piece)) pieces.push_back(piece);
    }
    return pieces;
}

std::span<const LinePiece> splitAndMerge(std::span<const TPoint2D> points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch) {
    scratch.x.clear();
    scratch.y.clear();
    for (const TPoint2D& p : points) {
        scratch.x.push_back(static_cast<float>(p.x - points.front().x));
        scratch.y.push_back(static_cast<float>(p.y - points.front().y));
    }
    splitAndMerge({scratch.x, scratch.y}, config, scratch);
    for (LinePiece& piece : scratch.pieces) {
        piece.line = fitOf(points.subspan(piece.begin, piece.end - piece.begin)).line();
    }
    return scratch.pieces;
}

}  // namespace offmap::core
