// SPDX-License-Identifier: BSD-3-Clause
#include "GridFaces.h"

#include <algorithm>

namespace offmap::maps {

namespace {

class Tracer {
 public:
    explicit Tracer(const OccupancyGrid& grid) : grid_(grid), traced_(grid.cells.size()) {}

    bool isOpen(const Face& face) const {
        return (traced_[grid_.index(face.cell.x, face.cell.y)] & bit(face)) == 0 &&
               isSeen(grid_, face);
    }

    FaceChain chainThrough(const Face& face) {
        FaceChain chain;
        const Face first = firstBefore(face);
        Face at = first;
        do {
            traced_[grid_.index(at.cell.x, at.cell.y)] |= bit(at);
            chain.faces.push_back(at);
            at = next(at);
        } while (at != first && isSeen(grid_, at));
        chain.closed = at == first;
        return chain;
    }

 private:
    static uint8_t bit(const Face& face) { return static_cast<uint8_t>(1U << face.side); }

    bool isOccupied(const Step& cell) const { return grid_.at(cell.x, cell.y) == Cell::Occupied; }

    /// The face that goes on where this one ends (forward) or begins.
    Face neighbour(const Face& face, bool forward) const {
        const Step ahead = forward ? face.along() : Step{} - face.along();
        const Step beside = face.cell + ahead, across = face.front() + ahead;
        const auto turned = static_cast<uint8_t>(face.side + (forward ? 1 : 3));
        if (isOccupied(across)) return {across, static_cast<uint8_t>((turned + 2) % 4)};
        if (isOccupied(beside)) return {beside, face.side};
        return {face.cell, static_cast<uint8_t>(turned % 4)};
    }

    Face next(const Face& face) const { return neighbour(face, true); }

    /// Where the chain that a face belongs to begins; the face itself, if it is closed.
    Face firstBefore(const Face& face) const {
        Face first = face;
        for (Face before = neighbour(face, false); isSeen(grid_, before);
             before = neighbour(before, false)) {
            if (before == face) return face;
            first = before;
        }
        return first;
    }

    const OccupancyGrid& grid_;
    std::vector<uint8_t> traced_;  ///< a bit for each side of each cell
};

}  // namespace

Step Face::start() const {
    constexpr std::array<Step, 4> corners{{{1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    return cell + corners[side];
}

bool isSeen(const OccupancyGrid& grid, const Face& face) {
    constexpr int rim = 2;  // [cells]
    Step ahead = face.front();
    for (int i = 0; i < rim && grid.at(ahead.x, ahead.y) == Cell::Unknown; ++i) {
        ahead = ahead + face.outward();
    }
    return grid.at(ahead.x, ahead.y) == Cell::Free;
}

std::vector<FaceChain> faceChains(const OccupancyGrid& grid) {
    Tracer tracer(grid);
    std::vector<FaceChain> chains;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            if (grid.at(x, y) != Cell::Occupied) continue;
            for (uint8_t side = 0; side < 4; ++side) {
                const Face face{{x, y}, side};
                if (tracer.isOpen(face)) chains.push_back(tracer.chainThrough(face));
            }
        }
    }
    return chains;
}

}  // namespace offmap::maps
