// SPDX-License-Identifier: BSD-3-Clause
#include "GridFaces.h"
#include "StraightPieces.h"
#include "ThinPieces.h"

#include <offmap/core/LineMap.h>
#include <offmap/maps/GridLines.h>

#include <cmath>
#include <span>
#include <utility>

namespace offmap::maps {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;

namespace {

TPoint2D placeOf(const Step& step) { return {double(step.x), double(step.y)}; }

double distance(const TPoint2D& a, const TPoint2D& b) { return (a - b).norm(); }

/// The ends of two lines that meet at a bend, where the last face of one and the first of the other
/// share a corner.
struct Joint {
    TPoint2D end, begin;
};

Joint jointOf(const PieceLine& a, const PieceLine& b, const TPoint2D& corner) {
    constexpr double reach = 1;  // [cells] the lines meet further away if they hardly bend
    const TPoint2D footA = a.foot(corner), footB = b.foot(corner);
    const double sine = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
    if (std::abs(sine) > 0.1) {
        const TPoint2D meet = footA + a.direction * (b.offset(footA) / sine);
        if (distance(meet, corner) <= reach) return {meet, meet};
    }
    constexpr double hardly = 0.3;  // [cells] more would turn a long line by what is beside it
    if (distance(footA, footB) <= hardly) {
        const TPoint2D middle = (footA + footB) * 0.5;
        return {middle, middle};
    }
    return {footA, footB};
}

/// Before each piece, and behind the last.
std::vector<Joint> jointsOf(std::span<const Piece> pieces, bool closed) {
    std::vector<Joint> joints;
    const auto meet = [](const Piece& a, const Piece& b) {
        return jointOf(a.line, b.line, placeOf(b.faces.front().start()));
    };
    const Piece &first = pieces.front(), &last = pieces.back();
    const TPoint2D begin = first.line.foot(placeOf(first.faces.front().start())),
                   end = last.line.foot(placeOf(last.faces.back().end()));
    joints.push_back(closed ? meet(last, first) : Joint{begin, begin});
    for (size_t i = 1; i < pieces.size(); ++i) joints.push_back(meet(pieces[i - 1], pieces[i]));
    joints.push_back(closed ? joints.front() : Joint{end, end});
    return joints;
}

/// Sharp bends can leave less of a short piece than the half cell at each end that thinning takes,
/// or turn it round: such a piece ends where its faces end.
TSegment2D withoutLoss(const Piece& piece, const TSegment2D& joined) {
    const TPoint2D begin = placeOf(piece.faces.front().start()),
                   end = placeOf(piece.faces.back().end());
    const auto along = [&](const TPoint2D& a, const TPoint2D& b) {
        return piece.line.position(b) - piece.line.position(a);
    };
    constexpr double most = 1 + 1e-9;  // [cells]
    if (along(joined.point1, joined.point2) >= along(begin, end) - most) return joined;
    return {piece.line.foot(begin), piece.line.foot(end)};
}

/// The lines of a chain's pieces, those that are kept, bend joined to bend.
void addLines(std::span<const Piece> pieces, bool closed, std::vector<TSegment2D>& lines) {
    const auto add = [&](const TPoint2D& from, const TPoint2D& to) {
        // The end of a thin wall comes to nothing, as both its sides come to its middle.
        constexpr double nothing = 0.1;  // [cells]
        if (distance(from, to) > nothing) lines.emplace_back(from, to);
    };
    const std::vector<Joint> joints = jointsOf(pieces, closed && pieces.size() > 1);
    for (size_t i = 0; i < pieces.size(); ++i) {
        if (!pieces[i].isKept) continue;
        const TSegment2D line = withoutLoss(pieces[i], {joints[i].begin, joints[i + 1].end});
        add(line.point1, line.point2);
        add(joints[i + 1].end, joints[i + 1].begin);
    }
}

/// Faces that no line comes near stand for themselves: where cells lie about singly, what belongs
/// together cannot always be told.
void addStrays(std::span<const FaceChain> chains, std::vector<TSegment2D>& lines) {
    std::vector<core::Wall> walls;
    for (const TSegment2D& line : lines) {
        walls.emplace_back();
        walls.back().line = line;
    }
    const core::LineMap map(std::move(walls));
    constexpr double near = 1.5;  // [cells] from a cell's middle, so one from its border
    for (const FaceChain& chain : chains) {
        for (const Face& face : chain.faces) {
            const TPoint2D middle = placeOf(face.cell) + TPoint2D{0.5, 0.5};
            if (map.nearestWall(middle, near, 0)) continue;
            lines.emplace_back(placeOf(face.start()), placeOf(face.end()));
        }
    }
}

}  // namespace

std::vector<TSegment2D> gridLines(const OccupancyGrid& grid, ThinWall thinWall) {
    std::vector<FaceChain> chains = faceChains(grid);
    std::vector<Piece> pieces;
    std::vector<size_t> firstPieces{0};
    for (FaceChain& chain : chains) {
        const std::vector<size_t> cuts = straightPieces(chain);
        const std::span<const Face> faces = chain.faces;
        for (size_t i = 0; i + 1 < cuts.size(); ++i) {
            const auto own = faces.subspan(cuts[i], cuts[i + 1] - cuts[i]);
            pieces.push_back({own, faces.size(), lineAlong(own)});
            if (thinWall == ThinWall::Middle) thin(grid, pieces.back());
        }
        firstPieces.push_back(pieces.size());
    }
    keepOneSide(grid, pieces);
    std::vector<TSegment2D> lines;
    for (size_t i = 0; i < chains.size(); ++i) {
        const auto own = std::span<const Piece>(pieces).subspan(
            firstPieces[i], firstPieces[i + 1] - firstPieces[i]);
        addLines(own, chains[i].closed, lines);
    }
    addStrays(chains, lines);
    return lines;
}

}  // namespace offmap::maps
