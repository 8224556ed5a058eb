// SPDX-License-Identifier: BSD-3-Clause
#include "StraightPieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace offmap::maps {

using mrpt::math::TPoint2D;

namespace {

/// [cells] How far the middles of a straight edge's faces are from its line at most.
constexpr double halfACell = 0.5 + 1e-6;

TPoint2D wayOf(std::span<const Face> faces) {
    const Step way = faces.back().end() - faces.front().start();
    return {double(way.x), double(way.y)};
}

double worstOffset(const PieceLine& line, std::span<const Face> faces) {
    double worst = 0;
    for (const Face& face : faces) worst = std::max(worst, std::abs(line.offset(middleOf(face))));
    return worst;
}

/// Whether a run goes back along its line by a cell: the two sides of a thin wall do, though both
/// lie near one line.
bool goesBack(const PieceLine& line, std::span<const Face> faces) {
    constexpr double most = 0.75;  // [cells]
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Face& face : faces) {
        const double at = line.position(middleOf(face));
        if (at < furthest - most) return true;
        furthest = std::max(furthest, at);
    }
    return false;
}

/// Sums over the faces of a chain, and lines through any run of them.
class Run {
 public:
    explicit Run(std::span<const Face> faces) : faces_(faces), sums_(1) {
        for (const Face& face : faces) {
            const Step twice = face.start() + face.end();
            sums_.push_back(sums_.back());
            sums_.back().add(twice.x, twice.y);
        }
    }

    size_t size() const { return faces_.size(); }

    Scatter scatter(size_t begin, size_t end) const {
        const Moments<int64_t>&a = sums_[begin], &b = sums_[end];
        const int64_t n = b.n - a.n, x = b.x - a.x, y = b.y - a.y;
        const Step first = faces_[begin].start() + faces_[begin].end();
        const int64_t x0 = first.x, y0 = first.y;
        const auto half = [](int64_t value) { return 0.5 * static_cast<double>(value); };
        const auto quarter = [](int64_t value) { return 0.25 * static_cast<double>(value); };
        return scatterOf({static_cast<double>(n), half(x - n * x0), half(y - n * y0),
                          quarter(b.xx - a.xx - 2 * x0 * x + n * x0 * x0),
                          quarter(b.xy - a.xy - x0 * y - y0 * x + n * x0 * y0),
                          quarter(b.yy - a.yy - 2 * y0 * y + n * y0 * y0)},
                         {half(x0), half(y0)});
    }

    /// The line that a run of faces stands for, if it is straight.
    std::optional<PieceLine> line(size_t begin, size_t end) const {
        const auto faces = faces_.subspan(begin, end - begin);
        const TPoint2D along = wayOf(faces);
        if (along.norm() == 0) return std::nullopt;
        PieceLine line = lineOf(scatter(begin, end), along);
        if (worstOffset(line, faces) > halfACell) {
            line = midlineOf(faces, along);
            if (worstOffset(line, faces) > halfACell) return std::nullopt;
        }
        if (goesBack(line, faces)) return std::nullopt;
        return line;
    }
    bool isStraight(size_t begin, size_t end) const { return line(begin, end).has_value(); }

    /// Where the longest straight run that begins there ends: doubled until it bends, then halved.
    size_t straightEnd(size_t begin) const {
        size_t good = begin + 1, step = 1;
        while (good < size()) {
            const size_t tried = std::min(good + step, size());
            if (!isStraight(begin, tried)) break;
            good = tried;
            step *= 2;
        }
        for (; step > 0; step /= 2) {
            if (good + step <= size() && isStraight(begin, good + step)) good += step;
        }
        return good;
    }

    /// Between two pieces, where cutting leaves the least squared distances.
    size_t bestCut(size_t begin, size_t cut, size_t end) const {
        const auto cost = [&](size_t at) {
            return scatter(begin, at).squaredDistances() + scatter(at, end).squaredDistances();
        };
        constexpr double rounding = 1e-9;
        size_t best = cut;
        double least = cost(cut) - rounding;
        for (size_t at = begin + 1; at < end; ++at) {
            if (const double found = cost(at); found < least) {
                best = at;
                least = found - rounding;
            }
        }
        return isStraight(begin, best) && isStraight(best, end) ? best : cut;
    }

 private:
    std::span<const Face> faces_;
    std::vector<Moments<int64_t>> sums_;  ///< of the faces before each, in half cells
};

void turnTo(FaceChain& chain, size_t begin) {
    std::rotate(chain.faces.begin(), chain.faces.begin() + std::ptrdiff_t(begin),
                chain.faces.end());
}

std::vector<size_t> piecesOf(const FaceChain& chain) {
    const Run run(chain.faces);
    std::vector<size_t> cuts{0};
    while (cuts.back() < run.size()) cuts.push_back(run.straightEnd(cuts.back()));
    for (int sweep = 0; sweep < 2; ++sweep) {
        for (size_t i = 1; i + 1 < cuts.size(); ++i) {
            cuts[i] = run.bestCut(cuts[i - 1], cuts[i], cuts[i + 1]);
        }
    }
    return cuts;
}

}  // namespace

PieceLine lineAlong(std::span<const Face> faces) {
    if (const auto line = Run(faces).line(0, faces.size())) return *line;
    const TPoint2D way = wayOf(faces);  // a single face that leads nowhere is not straight
    return {middleOf(faces.front()), way * (1 / way.norm())};
}

std::vector<size_t> straightPieces(FaceChain& chain) {
    if (chain.closed) {
        const std::vector<size_t> cuts = piecesOf(chain);
        if (cuts.size() > 2) turnTo(chain, cuts[1]);
    }
    return piecesOf(chain);
}

}  // namespace offmap::maps
