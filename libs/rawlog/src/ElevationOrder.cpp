// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"

#include <offmap/core/ByProcessor.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace offmap::rawlog {

using mrpt::math::TPoint3D, mrpt::math::TPoint3D_, mrpt::math::TPoint3Df;

namespace {

/// Returns that are looked at together.
constexpr size_t blockSize = 256;

/// [-] Square of an elevation's sine, with its sign. \param up of length 1
template <class Number>
Number squaredSineOf(const TPoint3D_<Number>& p, const TPoint3D_<Number>& up) {
    const Number height = up.x * p.x + up.y * p.y + up.z * p.z;
    return height * std::abs(height) / (p.x * p.x + p.y * p.y + p.z * p.z);
}

/// \param pointAt(i) \param squares room for as many
template <class PointAt>
[[gnu::always_inline]] inline void findSquaredSines(size_t count, const TPoint3Df& up,
                                                    const PointAt& pointAt, float* squares) {
    for (size_t i = 0; i < count; ++i) squares[i] = squaredSineOf<float>(pointAt(i), up);
}

/// [-] By how much a squared sine may seem to differ from another like it: three times what
/// rounding does to sines, 1.2e-6 together, makes 7.2e-6 of the sine in its square. The sine not
/// being known, that is bounded: 2 sqrt(a b) s <= a s^2 + b.
[[gnu::always_inline]] inline float doubtOf(float squaredSine) {
    constexpr float perSquare = 6e-5F, atLevel = 2.5e-7F;
    return perSquare * std::abs(squaredSine) + atLevel;
}

template <class PointAt>
[[gnu::always_inline]] inline ElevationOrder orderOf(size_t count, const Upwards& upwards,
                                                     const PointAt& pointAt) {
    const TPoint3Df up(upwards.direction);
    float squares[blockSize];
    uint32_t notUpward = 0, notDownward = 0;
    for (size_t first = 0; first + 1 < count; first += blockSize - 1) {  // blocks share a return
        const size_t size = std::min(blockSize, count - first);
        findSquaredSines(
            size, up, [&](size_t i) { return pointAt(first + i); }, squares);
        for (size_t i = 0; i + 1 < size; ++i) {
            const float rise = squares[i + 1] - squares[i], doubt = doubtOf(squares[i]);
            notUpward += !(rise > doubt);  // so, too, if it is not a number
            notDownward += !(rise < -doubt);
        }
    }
    return notUpward == 0     ? ElevationOrder::Upward
           : notDownward == 0 ? ElevationOrder::Downward
                              : ElevationOrder::Mixed;
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

OFFMAP_BY_PROCESSOR ElevationOrder elevationOrderOf(std::span<const TPoint3Df> returns,
                                                    const Upwards& up) {
    return orderOf(returns.size(), up, [&](size_t i) { return returns[i]; });
}

void sortUpward(std::span<ColumnReturn> returns, const Upwards& up) {
    for (ColumnReturn& r : returns) {
        r.squaredSine = squaredSineOf<double>(TPoint3D(r.point), up.direction);
    }
    std::sort(returns.begin(), returns.end(), Below());
}

}  // namespace offmap::rawlog
