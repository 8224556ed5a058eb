// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Health.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace offmap::core {

namespace {

constexpr size_t leastSegments = 20;  // fewer say nothing of a pose
constexpr double leastShare = 0.3;
/// [m] Three times what map (0.03 m) and range (0.02 m) may have in common in all directions.
constexpr double greatestBias = 0.11;

/// What a scan shows where the map has walls.
struct SeenOnWalls {
    size_t segments = 0;
    uint64_t returns = 0, removed = 0;
};

SeenOnWalls seenOnWalls(const ReductionResult& result) {
    SeenOnWalls seen;
    for (size_t s = 0; s < result.segments.size(); ++s) {
        if (!result.matches[s].wall) continue;
        const VerticalSegment& segment = result.segments[s];
        ++seen.segments;
        seen.returns += segment.end - segment.begin;
        for (uint32_t i = segment.begin; i < segment.end; ++i) {
            seen.removed += result.labels[i] == PointLabel::Mapped;
        }
    }
    return seen;
}

std::vector<double> residualsOf(const ReductionResult& result) {
    std::vector<double> residuals;
    for (const SegmentMatch& match : result.matches) {
        if (match.verdict != Verdict::MappedByRay || !match.predicted) continue;
        residuals.push_back(match.measured.centre() - match.predicted->centre());
    }
    return residuals;
}

std::optional<double> medianOf(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

PoseFit fitOf(const Alignment& alignment) {
    const Vector5& mean = alignment.correction.mean;
    return {mean.head<2>().norm(), mean[2], alignment.fittedShare, alignment.priorChiSquare,
            alignment.priorInflation};
}

}  // namespace

std::string_view toString(Suspicion suspicion) {
    switch (suspicion) {
        case Suspicion::DoesNotFit:
            return "pose_does_not_fit";
        case Suspicion::PoseContradicted:
            return "pose_contradicted";
        case Suspicion::FewMatches:
            return "few_matches";
        case Suspicion::Biased:
            return "biased";
    }
    return "unknown";
}

Health healthOf(const ReductionResult& result) {
    Health health;
    if (result.alignment) health.fit = fitOf(*result.alignment);
    if (result.notReduced) {
        if (result.notReduced == PoseFault::DoesNotFit) health.suspect = Suspicion::DoesNotFit;
        return health;
    }
    const SeenOnWalls seen = seenOnWalls(result);
    if (seen.returns > 0) {
        health.matchedShare = static_cast<double>(seen.removed) / static_cast<double>(seen.returns);
    }
    const std::vector<double> residuals = residualsOf(result);
    health.residualBias = medianOf(residuals);
    if (result.alignment && result.alignment->contradictsPrior()) {
        health.suspect = Suspicion::PoseContradicted;
    } else if (seen.segments >= leastSegments && *health.matchedShare < leastShare) {
        health.suspect = Suspicion::FewMatches;
    } else if (residuals.size() >= leastSegments && std::abs(*health.residualBias) > greatestBias) {
        health.suspect = Suspicion::Biased;
    }
    return health;
}

}  // namespace offmap::core
