// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineFit.h>

namespace offmap::core {

void LineFit::add(const mrpt::math::TPoint2D& p) {
    if (count_ == 0) origin_ = p;
    ++count_;
    const double x = p.x - origin_.x, y = p.y - origin_.y;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
    yy_ += y * y;
}

FittedLine LineFit::line() const {
    const double n = static_cast<double>(count_);
    const double sxx = xx_ - x_ * x_ / n, sxy = xy_ - x_ * y_ / n, syy = yy_ - y_ * y_ / n;
    // The major axis of the 2x2 scatter [sxx sxy; sxy syy] stands at half the angle of (sxx - syy,
    // 2 sxy).
    const double difference = sxx - syy, doubled = 2 * sxy;
    const double length = std::hypot(difference, doubled);
    FittedLine line;
    line.point = {origin_.x + x_ / n, origin_.y + y_ / n};
    if (length == 0) {
        line.direction = {1, 0};
        return line;
    }
    // Half-angle formulas; the larger component first, so that neither loses digits.
    if (difference >= 0) {
        const double c = std::sqrt(0.5 * (1 + difference / length));
        line.direction = {c, doubled / (2 * length * c)};
    } else {
        const double s = std::sqrt(0.5 * (1 - difference / length));
        line.direction = {doubled / (2 * length * s), s};
    }
    return line;
}

}  // namespace offmap::core
