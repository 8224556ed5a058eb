// SPDX-License-Identifier: BSD-3-Clause
#include "Lanes.h"

#include <offmap/core/LineFit.h>

namespace offmap::core {

void LineFit::add(const PlanePoints& points) {
    if (points.size() == 0) return;
    if (count_ == 0) origin_ = points[0];
    Lanes sumX = Lanes::Zero(), sumY = sumX, sumXX = sumX, sumXY = sumX, sumYY = sumX;
    size_t i = 0;
    for (; i + laneCount <= points.size(); i += laneCount) {
        const Lanes x = lanesAt(points.x.data() + i) - origin_.x;
        const Lanes y = lanesAt(points.y.data() + i) - origin_.y;
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
        sumYY += y * y;
    }
    count_ += i;
    x_ += sumX.sum();
    y_ += sumY.sum();
    xx_ += sumXX.sum();
    xy_ += sumXY.sum();
    yy_ += sumYY.sum();
    for (; i < points.size(); ++i) add(points[i]);
}

void LineFit::add(const LineFit& other) {
    if (count_ == 0) {
        *this = other;
        return;
    }
    const double n = static_cast<double>(other.count_);
    const double dx = other.origin_.x - origin_.x, dy = other.origin_.y - origin_.y;
    count_ += other.count_;
    xx_ += other.xx_ + dx * (2 * other.x_ + n * dx);
    xy_ += other.xy_ + dx * other.y_ + dy * (other.x_ + n * dx);
    yy_ += other.yy_ + dy * (2 * other.y_ + n * dy);
    x_ += other.x_ + n * dx;
    y_ += other.y_ + n * dy;
}

FittedLine LineFit::line() const {
    const double inverse = 1 / static_cast<double>(count_);
    const double sxx = xx_ - x_ * x_ * inverse, sxy = xy_ - x_ * y_ * inverse,
                 syy = yy_ - y_ * y_ * inverse;
    // The major axis of the 2x2 scatter [sxx sxy; sxy syy] stands at half the angle of (sxx - syy,
    // 2 sxy).
    const double difference = sxx - syy, doubled = 2 * sxy;
    const double length = std::sqrt(difference * difference + doubled * doubled);
    FittedLine line;
    line.point = {origin_.x + x_ * inverse, origin_.y + y_ * inverse};
    if (length == 0) {
        line.direction = {1, 0};
        return line;
    }
    // Half-angle formulas, from the larger component, so that neither loses digits.
    const double larger = length + std::abs(difference);
    const double scale = 1 / std::sqrt(larger * larger + doubled * doubled);
    line.direction = difference >= 0 ? mrpt::math::TPoint2D(larger * scale, doubled * scale)
                                     : mrpt::math::TPoint2D(doubled * scale, larger * scale);
    return line;
}

}  // namespace offmap::core
