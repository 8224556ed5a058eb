// SPDX-License-Identifier: BSD-3-Clause
#include "CollinearMerge.h"

#include "Groups.h"

#include <offmap/core/Interval.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <tuple>
#include <utility>

namespace offmap::maps {

using mrpt::math::TPoint2D;

namespace {

/// A place as seen from a line: along it from its first end, and to the side.
struct Seen {
    double along, off;  ///< [m]
};

Seen seenFrom(const DrawnLine& line, const TPoint2D& place) {
    const TPoint2D way = line.b - line.a, to = place - line.a;
    const double length = way.norm();
    return {(to.x * way.x + to.y * way.y) / length, std::abs(way.x * to.y - way.y * to.x) / length};
}

bool isLonger(const DrawnLine& one, const DrawnLine& other) {
    const double a = one.length(), b = other.length();
    return a != b ? a > b : isBefore(one, other);
}

/// From the first to the last end of lines along the longest of them.
DrawnLine spanOf(const std::vector<const DrawnLine*>& lines) {
    const DrawnLine& longest = **std::ranges::min_element(
        lines, [](const auto* one, const auto* other) { return isLonger(*one, *other); });
    const auto key = [&](const TPoint2D& p) {
        return std::tuple(seenFrom(longest, p).along, p.x, p.y);
    };
    TPoint2D first = longest.a, last = longest.b;
    size_t place = longest.place;
    for (const DrawnLine* line : lines) {
        for (const TPoint2D& end : {line->a, line->b}) {
            if (key(end) < key(first)) first = end;
            if (key(end) > key(last)) last = end;
        }
        place = std::min(place, line->place);
    }
    return {first, last, place};
}

bool liesOn(const DrawnLine& line, const DrawnLine& whole, double tolerance) {
    return seenFrom(whole, line.a).off <= tolerance && seenFrom(whole, line.b).off <= tolerance;
}

/// [m] The part of a line that another one covers, or would.
core::Interval alongOf(const DrawnLine& line, const DrawnLine& whole) {
    const double a = seenFrom(whole, line.a).along, b = seenFrom(whole, line.b).along;
    return {std::min(a, b), std::max(a, b)};
}

/// Whether both are parts of one line, without a gap between them.
bool continueEachOther(const DrawnLine& one, const DrawnLine& other, double tolerance) {
    if (angleBetween(one, other) > CollinearIndex::largestAngle) return false;
    const DrawnLine whole = spanOf({&one, &other});
    if (!liesOn(one, whole, tolerance) || !liesOn(other, whole, tolerance)) return false;
    const core::Interval oneAlong = alongOf(one, whole), otherAlong = alongOf(other, whole);
    return oneAlong.expanded(0.5 * tolerance).intersects(otherAlong.expanded(0.5 * tolerance));
}

/// The lines that continue each other become one, unless they bend on the way.
std::vector<DrawnLine> united(const std::vector<DrawnLine>& lines, double tolerance) {
    const CollinearIndex index(lines);
    Groups groups(lines.size());
    for (uint32_t i = 0; i < lines.size(); ++i) {
        index.near(lines[i], tolerance, [&](uint32_t j) {
            if (j > i && groups.of(i) != groups.of(j) &&
                continueEachOther(lines[i], lines[j], tolerance)) {
                groups.unite(i, j);
            }
        });
    }
    std::map<uint32_t, std::vector<const DrawnLine*>> members;
    std::vector<DrawnLine> result;
    for (uint32_t i = 0; i < lines.size(); ++i) members[groups.of(i)].push_back(&lines[i]);
    for (const auto& [first, group] : members) {
        const DrawnLine whole = group.size() > 1 ? spanOf(group) : *group[0];
        const bool isStraight = std::ranges::all_of(
            group, [&](const DrawnLine* line) { return liesOn(*line, whole, tolerance); });
        if (isStraight) {
            result.push_back(whole);
        } else {
            for (const DrawnLine* line : group) result.push_back(*line);
        }
    }
    return result;
}

bool holds(const DrawnLine& whole, const DrawnLine& part, double tolerance) {
    return std::ranges::all_of(std::initializer_list<TPoint2D>{part.a, part.b},
                               [&](const auto& end) {
                                   const Seen seen = seenFrom(whole, end);
                                   return seen.off <= tolerance && seen.along >= -tolerance &&
                                          seen.along <= whole.length() + tolerance;
                               });
}

/// Without those that a longer one holds which is itself left.
std::vector<DrawnLine> withoutHeld(std::vector<DrawnLine> lines, double tolerance) {
    std::ranges::sort(lines, isLonger);
    const CollinearIndex index(lines);
    std::vector<bool> isHeld(lines.size(), false);
    std::vector<DrawnLine> result;
    for (uint32_t i = 0; i < lines.size(); ++i) {
        index.near(lines[i], tolerance, [&](uint32_t j) {
            if (j < i && !isHeld[j] &&
                angleBetween(lines[i], lines[j]) <= CollinearIndex::largestAngle &&
                holds(lines[j], lines[i], tolerance)) {
                isHeld[i] = true;
            }
        });
        if (!isHeld[i]) result.push_back(lines[i]);
    }
    return result;
}

void dropEqual(std::vector<DrawnLine>& lines) {
    std::ranges::sort(lines, [](const DrawnLine& one, const DrawnLine& other) {
        if (isBefore(one, other) || isBefore(other, one)) return isBefore(one, other);
        return one.place < other.place;
    });
    const auto areEqual = [](const DrawnLine& one, const DrawnLine& other) {
        return one.a == other.a && one.b == other.b;
    };
    lines.erase(std::unique(lines.begin(), lines.end(), areEqual), lines.end());
}

}  // namespace

void mergeCollinear(std::vector<DrawnLine>& lines, double tolerance) {
    dropEqual(lines);
    for (size_t before = lines.size() + 1; lines.size() < before;) {
        before = lines.size();
        lines = united(lines, tolerance);
        lines = withoutHeld(std::move(lines), tolerance);
    }
}

}  // namespace offmap::maps
