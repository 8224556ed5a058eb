// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/TruthMatch.h>

#include <array>
#include <bit>
#include <functional>
#include <unordered_map>

namespace offmap::evaluation {

namespace {

using Bits = std::array<uint32_t, 3>;

Bits bitsOf(const mrpt::math::TPoint3Df& point) {
    return {std::bit_cast<uint32_t>(point.x), std::bit_cast<uint32_t>(point.y),
            std::bit_cast<uint32_t>(point.z)};
}

struct HashOfBits {
    size_t operator()(const Bits& bits) const {
        // Odd constants of SplitMix64 spread the few bits in which neighbours differ.
        uint64_t hash = (uint64_t{bits[0]} << 32 | bits[1]) * 0xbf58476d1ce4e5b9U;
        hash = (hash ^ (hash >> 31) ^ bits[2]) * 0x94d049bb133111ebU;
        return hash ^ (hash >> 29);
    }
};

}  // namespace

TruthMatch matchTruth(std::span<const TruePoint> truth,
                      std::span<const mrpt::math::TPoint3Df> left) {
    std::unordered_map<Bits, uint32_t, HashOfBits> remaining;
    remaining.reserve(left.size());
    for (const auto& point : left) ++remaining[bitsOf(point)];
    TruthMatch match;
    match.points.reserve(truth.size());
    uint64_t kept = 0;
    for (const TruePoint& point : truth) {
        const auto found = remaining.find(bitsOf(point.point));
        const bool isKept = found != remaining.end() && found->second > 0;
        if (isKept) --found->second, ++kept;
        match.points.push_back(
            {point.mapped, point.onVerticalSegment, !isKept, point.kind, point.standOff});
    }
    match.unknown = left.size() - kept;
    return match;
}

}  // namespace offmap::evaluation
