// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>

#include <algorithm>
#include <tuple>

namespace offmap::rawlog {

using core::DoubleLanes, core::doubleLaneCount;
using mrpt::math::TPoint3Df;

namespace {

/// Elevation of returns, one or as many as there are lanes, told without a division.
template <class Numbers>
struct Elevation {
    [[gnu::always_inline]] Elevation(const float* xs, const float* ys, const float* zs,
                                     const Upwards& up) {
        Numbers x, y, z;
        core::load(xs, x);
        core::load(ys, y);
        core::load(zs, z);
        const Numbers height = up.x * x + up.y * y + up.z * z;
        squaredHeight = height * (height < 0 ? -height : height);
        squaredRange = x * x + y * y + z * z;
    }
    Elevation(const TPoint3Df& p, const Upwards& up) : Elevation(&p.x, &p.y, &p.z, up) {}
    /// Of returns of a cloud, from one on.
    [[gnu::always_inline]] Elevation(const CloudPoints& points, size_t i, const Upwards& up)
        : Elevation(points.x.data() + i, points.y.data() + i, points.z.data() + i, up) {}
    /// Of those behind the first of `here`.
    [[gnu::always_inline]] Elevation(const Elevation& here, const Elevation& more)
        : squaredHeight(
              __builtin_shufflevector(here.squaredHeight, more.squaredHeight, 1, 2, 3, 4)),
          squaredRange(__builtin_shufflevector(here.squaredRange, more.squaredRange, 1, 2, 3, 4)) {}

    Numbers squaredHeight, squaredRange;  ///< [m^2] that of the height with its sign
};

/// How returns stand to those before them; compares products in place of ratios.
template <class Numbers>
struct Step {
    [[gnu::always_inline]] Step(const Elevation<Numbers>& from, const Elevation<Numbers>& to) {
        constexpr double rounding = 1e-12;
        upwards = to.squaredHeight * from.squaredRange - from.squaredHeight * to.squaredRange -
                  rounding * from.squaredRange * to.squaredRange;
    }
    Numbers upwards;  ///< [m^4] above 0 if rounding cannot make it look otherwise
};

bool isAbove(const TPoint3Df& p, const TPoint3Df& other, const Upwards& up) {
    return Step(Elevation<double>(other, up), Elevation<double>(p, up)).upwards > 0;
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

OFFMAP_BY_PROCESSOR bool standUpward(const CloudPoints& returns, const Upwards& up) {
    using Elevations = Elevation<DoubleLanes>;
    const size_t count = returns.size();
    if (count <= doubleLaneCount) {
        bool upward = true;
        for (size_t i = 1; i < count; ++i) upward &= isAbove(returns[i], returns[i - 1], up);
        return upward;
    }
    DoubleLanes least = DoubleLanes{} + 1;
    const auto add = [&least](const Elevations& before, const Elevations& next) {
        const DoubleLanes upwards = Step(before, next).upwards;
        least = upwards < least ? upwards : least;
    };
    size_t from = 0;
    Elevations here(returns, 0, up);
    for (; from + 2 * doubleLaneCount <= count; from += doubleLaneCount) {
        const Elevations more(returns, from + doubleLaneCount, up);
        add(here, Elevations(here, more));
        here = more;
    }
    for (; from + 1 < count; from += doubleLaneCount) {  // some steps twice
        const size_t i = std::min(from, count - 1 - doubleLaneCount);
        add(Elevations(returns, i, up), Elevations(returns, i + 1, up));
    }
    return !core::any(least <= 0);
}

bool standUpward(std::span<const ColumnReturn> returns, const Upwards& up) {
    for (size_t i = 1; i < returns.size(); ++i) {
        if (!isAbove(returns[i].point, returns[i - 1].point, up)) return false;
    }
    return true;
}

void sortUpward(std::span<ColumnReturn> returns, const Upwards& up) {
    for (ColumnReturn& r : returns) {
        const Elevation<double> elevation(r.point, up);
        r.squaredSine = elevation.squaredHeight / elevation.squaredRange;
    }
    std::sort(returns.begin(), returns.end(), Below());
}

}  // namespace offmap::rawlog
