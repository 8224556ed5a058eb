// SPDX-License-Identifier: BSD-3-Clause
#include "CollinearIndex.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace offmap::maps {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using mrpt::math::TPoint2D;

namespace {

using Corner = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;
using Entry = std::pair<Box, uint32_t>;

constexpr double pi = std::numbers::pi;
constexpr int sectors = 90;
constexpr double sectorWidth =
    pi / sectors;  // [rad]; walls along the axes are in the middle of one

/// The box of a line, in axes that are turned so that it lies flat.
Box boxOf(const DrawnLine& line, double turn, double margin) {
    const double c = std::cos(turn), s = std::sin(turn);
    const double u1 = c * line.a.x + s * line.a.y, u2 = c * line.b.x + s * line.b.y;
    const double v1 = c * line.a.y - s * line.a.x, v2 = c * line.b.y - s * line.b.x;
    return {{std::min(u1, u2) - margin, std::min(v1, v2) - margin},
            {std::max(u1, u2) + margin, std::max(v1, v2) + margin}};
}

int sectorOf(double direction) {
    const auto nearest = static_cast<int>(std::lround(direction / sectorWidth));
    return (nearest + sectors) % sectors;
}

std::tuple<double, double, double, double> coordinates(const DrawnLine& line) {
    return {line.a.x, line.a.y, line.b.x, line.b.y};
}

}  // namespace

DrawnLine::DrawnLine(const TPoint2D& end1, const TPoint2D& end2, size_t placeOfIt)
    : a(end1), b(end2), place(placeOfIt) {
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
}

double DrawnLine::direction() const { return std::atan2(b.y - a.y, b.x - a.x); }

bool isBefore(const DrawnLine& one, const DrawnLine& other) {
    return coordinates(one) < coordinates(other);
}

double angleBetween(const DrawnLine& one, const DrawnLine& other) {
    return std::abs(std::remainder(one.direction() - other.direction(), pi));
}

/// Lines of about one direction.
struct CollinearIndex::Sector {
    bgi::rtree<Entry, bgi::rstar<16>> tree;
};

CollinearIndex::CollinearIndex(std::span<const DrawnLine> lines) : sectors_(sectors) {
    std::vector<std::vector<Entry>> entries(sectors);
    for (uint32_t i = 0; i < lines.size(); ++i) {
        const int sector = sectorOf(lines[i].direction());
        entries[static_cast<size_t>(sector)].emplace_back(boxOf(lines[i], sector * sectorWidth, 0),
                                                          i);
    }
    for (size_t k = 0; k < entries.size(); ++k) {
        sectors_[k].tree = bgi::rtree<Entry, bgi::rstar<16>>(entries[k]);  // packed
    }
}

CollinearIndex::~CollinearIndex() = default;
CollinearIndex::CollinearIndex(CollinearIndex&&) noexcept = default;

void CollinearIndex::near(const DrawnLine& line, double margin,
                          const std::function<void(uint32_t)>& tell) const {
    const double direction = line.direction();
    const int low = sectorOf(direction - largestAngle), high = sectorOf(direction + largestAngle);
    const auto search = [&](int sector) {
        const auto hit = [&](const Entry& entry) { tell(entry.second); };
        sectors_[static_cast<size_t>(sector)].tree.query(
            bgi::intersects(boxOf(line, sector * sectorWidth, margin)),
            boost::make_function_output_iterator(hit));
    };
    search(low);
    if (high != low) search(high);
}

}  // namespace offmap::maps
