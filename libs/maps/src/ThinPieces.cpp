// SPDX-License-Identifier: BSD-3-Clause
#include "ThinPieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <utility>

namespace offmap::maps {

using mrpt::math::TPoint2D;

namespace {

// A line that is drawn through every cell it touches is cos a + sin a <= 1.42 cells thick.
constexpr double thinnest = 1.5;  // [cells]

TPoint2D vector(const Step& step) { return {double(step.x), double(step.y)}; }

/// How many cells behind a face are occupied; more than thin walls have need not be told apart.
int depthBehind(const OccupancyGrid& grid, const Face& face) {
    constexpr int most = 4;
    int depth = 1;
    for (Step cell = face.cell - face.outward();
         depth < most && grid.at(cell.x, cell.y) == Cell::Occupied; cell = cell - face.outward()) {
        ++depth;
    }
    return depth;
}

constexpr double diagonal = 0.7;  // a little less than the cosine of 45 degrees

/// How squarely a face looks away from a line: cosine. A step between rows or columns looks along.
double acrossLine(const Face& face, const TPoint2D& normal) {
    const TPoint2D outward = vector(face.outward());
    return std::abs(normal.x * outward.x + normal.y * outward.y);
}

/// The other side of the wall.
Face opposite(const OccupancyGrid& grid, Face face) {
    for (int i = depthBehind(grid, face); i > 1; --i) face.cell = face.cell - face.outward();
    face.side = static_cast<uint8_t>((face.side + 2) % 4);
    return face;
}

struct FaceHash {
    size_t operator()(const Face& face) const {
        return std::hash<uint64_t>{}(static_cast<uint64_t>(face.cell.x) << 34U ^
                                     static_cast<uint64_t>(face.cell.y) << 2U ^ face.side);
    }
};

}  // namespace

void thin(const OccupancyGrid& grid, Piece& piece) {
    const TPoint2D normal = piece.line.normal();
    std::vector<TPoint2D> middles;  // of the wall behind the faces
    size_t looking = 0;
    double thickness = 0, offset = 0;  // [cells] across the line, sums over the middles
    for (const Face& face : piece.faces) {
        const double across = acrossLine(face, normal);
        if (across < diagonal) continue;
        ++looking;
        constexpr int thickest = 2;  // of a line drawn aslant; at a corner it is another wall's
        const int depth = depthBehind(grid, face);
        if (depth > thickest) continue;
        middles.push_back(middleOf(face) - vector(face.outward()) * (0.5 * depth));
        thickness += depth * across;
        offset += piece.line.offset(middles.back());
    }
    const auto count = static_cast<double>(middles.size());
    // Of a single cell no middle line would be left.
    piece.isThin = looking > 1 && 2 * middles.size() > looking && thickness <= thinnest * count;
    if (!piece.isThin) return;
    constexpr size_t fewToTellADirection = 4;
    if (middles.size() < fewToTellADirection) {
        piece.line.centre += normal * (offset / count);
    } else {
        piece.line = fitLine(middles, piece.line.direction);
    }
}

void keepOneSide(const OccupancyGrid& grid, std::vector<Piece>& pieces) {
    std::unordered_map<Face, size_t, FaceHash> pieceOf;
    std::vector<size_t> thinOnes;
    for (size_t i = 0; i < pieces.size(); ++i) {
        if (!pieces[i].isThin) continue;
        thinOnes.push_back(i);
        for (const Face& face : pieces[i].faces) pieceOf[face] = i;
    }
    // The side goes whose chain is the shorter one: what stays of a chain is joined at its bends.
    std::ranges::stable_sort(thinOnes, std::less{}, [&](size_t i) {
        return std::pair(pieces[i].chainFaces, pieces[i].faces.size());
    });
    for (const size_t i : thinOnes) {
        size_t shared = 0, alone = 0;
        for (const Face& face : pieces[i].faces) {
            if (acrossLine(face, pieces[i].line.normal()) < diagonal) continue;
            const auto other = pieceOf.find(opposite(grid, face));
            const bool isShared =
                other != pieceOf.end() && other->second != i && pieces[other->second].isKept;
            ++(isShared ? shared : alone);
        }
        constexpr size_t atItsEnds = 2;  // at a bend one side is a cell longer than the other
        pieces[i].isKept = shared == 0 || alone > atItsEnds || shared < 4 * alone;
    }
}

}  // namespace offmap::maps
