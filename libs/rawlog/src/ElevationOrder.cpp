// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"

#include <offmap/core/ByProcessor.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace offmap::rawlog {

using mrpt::math::TPoint3Df;

namespace {

/// Returns that are looked at together.
constexpr size_t blockSize = 256;

/// Sines of elevations. \param pointAt(i) \param sines room for as many
template <class PointAt>
[[gnu::always_inline]] inline void findSines(size_t count, const Upwards& up,
                                             const PointAt& pointAt, float* sines) {
    const auto upX = static_cast<float>(up.x), upY = static_cast<float>(up.y),
               upZ = static_cast<float>(up.z);
    for (size_t i = 0; i < count; ++i) {
        const TPoint3Df p = pointAt(i);
        sines[i] =
            (upX * p.x + upY * p.y + upZ * p.z) / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    }
}

template <class PointAt>
[[gnu::always_inline]] inline ElevationOrder orderOf(size_t count, const Upwards& up,
                                                     const PointAt& pointAt) {
    constexpr float clearly = 4e-6F;  // [-] three times what rounding can do to two sines
    float sines[blockSize];
    uint32_t notUpward = 0, notDownward = 0;
    for (size_t first = 0; first + 1 < count; first += blockSize - 1) {  // blocks share a return
        const size_t size = std::min(blockSize, count - first);
        findSines(
            size, up, [&](size_t i) { return pointAt(first + i); }, sines);
        for (size_t i = 0; i + 1 < size; ++i) {
            const float rise = sines[i + 1] - sines[i];
            notUpward += !(rise > clearly);  // so, too, if it is not a number
            notDownward += !(rise < -clearly);
        }
    }
    return notUpward == 0     ? ElevationOrder::Upward
           : notDownward == 0 ? ElevationOrder::Downward
                              : ElevationOrder::Mixed;
}

/// [-] Square of the elevation's sine, with its sign.
double squaredSineOf(const TPoint3Df& p, const Upwards& up) {
    const double x = p.x, y = p.y, z = p.z;
    const double height = up.x * x + up.y * y + up.z * z;
    return height * std::abs(height) / (x * x + y * y + z * z);
}

struct Below {  // a type, so that what sorts knows it
    bool operator()(const ColumnReturn& a, const ColumnReturn& b) const {
        if (a.squaredSine != b.squaredSine) return a.squaredSine < b.squaredSine;
        return key(a) < key(b);
    }
    static std::tuple<double, float, float, float, uint32_t> key(const ColumnReturn& r) {
        const double x = r.point.x, y = r.point.y, z = r.point.z;
        return {x * x + y * y + z * z, r.point.x, r.point.y, r.point.z, r.slot};
    }
};

}  // namespace

OFFMAP_BY_PROCESSOR ElevationOrder elevationOrderOf(const CloudPoints& returns, const Upwards& up) {
    const float *x = returns.x.data(), *y = returns.y.data(), *z = returns.z.data();
    return orderOf(returns.size(), up, [=](size_t i) { return TPoint3Df(x[i], y[i], z[i]); });
}

ElevationOrder elevationOrderOf(std::span<const ColumnReturn> returns, const Upwards& up) {
    return orderOf(returns.size(), up, [&](size_t i) { return returns[i].point; });
}

void sortUpward(std::span<ColumnReturn> returns, const Upwards& up) {
    for (ColumnReturn& r : returns) r.squaredSine = squaredSineOf(r.point, up);
    std::sort(returns.begin(), returns.end(), Below());
}

}  // namespace offmap::rawlog
