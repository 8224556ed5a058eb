// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineFit.h>

namespace offmap::core {

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
    const double n = static_cast<double>(count_);
    const double sxx = xx_ - x_ * x_ / n, sxy = xy_ - x_ * y_ / n, syy = yy_ - y_ * y_ / n;
    // The major axis of the 2x2 scatter [sxx sxy; sxy syy] stands at half the angle of (sxx - syy,
    // 2 sxy).
    const double difference = sxx - syy, doubled = 2 * sxy;
    const double length = std::sqrt(difference * difference + doubled * doubled);
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
