// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SplitAndMerge.h>
#include <offmap/evaluation/SurfaceLines.h>

#include <optional>

namespace offmap::evaluation {

using mrpt::math::TPoint2D;

namespace {

using Chain = std::vector<uint32_t>;

/// Chains that may go on, and those that have come to their end.
class Chains {
 public:
    Chains(std::span<const SeenSegment> segments, const SurfaceLineConfig& config)
        : segments_(segments), config_(config) {}

    void add(uint32_t segment) {
        endOverdue(segments_[segment].column);
        if (const auto nearest = nearestTo(segment)) {
            open_[*nearest].push_back(segment);
        } else {
            open_.push_back({segment});
        }
    }

    std::vector<Chain> finish() {
        for (Chain& chain : open_) ended_.push_back(std::move(chain));
        return std::move(ended_);
    }

 private:
    void endOverdue(uint32_t column) {
        std::erase_if(open_, [&](Chain& chain) {
            const bool over = column - segments_[chain.back()].column > config_.maxColumnGap + 1;
            if (over) ended_.push_back(std::move(chain));
            return over;
        });
    }

    std::optional<size_t> nearestTo(uint32_t segment) const {
        const SeenSegment& seen = segments_[segment];
        double least = config_.maxGap * config_.maxGap;
        std::optional<size_t> nearest;
        for (size_t c = 0; c < open_.size(); ++c) {
            const SeenSegment& last = segments_[open_[c].back()];
            if (last.column == seen.column) continue;
            const double square = (seen.place - last.place).sqrNorm();
            if (square > least) continue;
            least = square;
            nearest = c;
        }
        return nearest;
    }

    std::span<const SeenSegment> segments_;
    const SurfaceLineConfig& config_;
    std::vector<Chain> open_, ended_;
};

}  // namespace

std::vector<SurfaceLine> surfaceLines(std::span<const SeenSegment> segments,
                                      const SurfaceLineConfig& config) {
    Chains chains(segments, config);
    for (uint32_t s = 0; s < segments.size(); ++s) chains.add(s);
    std::vector<SurfaceLine> lines;
    std::vector<TPoint2D> places;
    core::SplitAndMergeScratch scratch;
    const core::SplitAndMergeConfig splitting{config.maxPointToLine, config.maxGap,
                                              config.minLength, config.minSegments};
    for (const Chain& chain : chains.finish()) {
        places.clear();
        for (const uint32_t s : chain) places.push_back(segments[s].place);
        for (const core::LinePiece& piece : core::splitAndMerge(places, splitting, scratch)) {
            lines.push_back(
                {{chain.begin() + piece.begin, chain.begin() + piece.end}, piece.line.direction});
        }
    }
    return lines;
}

}  // namespace offmap::evaluation
