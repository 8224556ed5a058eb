// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineFit.h>

namespace offmap::core {

using mrpt::math::TPoint2D;

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

FittedLine LineFit::line() const { return scaledLine().withUnitVector(); }

LineFit fitOf(std::span<const TPoint2D> points) {
    LineFit fit;
    for (const TPoint2D& p : points) fit.add(p);
    return fit;
}

void RangeFits::build(const PlanePoints& points) {
    before_.resize(points.size() + 1);
    before_.front() = {};
    if (points.size() == 0) return;
    origin_ = points[0];
    Sums sums;
    for (size_t i = 0; i < points.size(); ++i) {
        const TPoint2D p = points[i] - origin_;
        sums.x += p.x;
        sums.y += p.y;
        sums.xx += p.x * p.x;
        sums.xy += p.x * p.y;
        sums.yy += p.y * p.y;
        before_[i + 1] = sums;
    }
}

LineFit RangeFits::of(size_t begin, size_t end) const {
    const Sums &from = before_[begin], &to = before_[end];
    LineFit fit;
    fit.count_ = end - begin;
    fit.origin_ = origin_;
    fit.x_ = to.x - from.x;
    fit.y_ = to.y - from.y;
    fit.xx_ = to.xx - from.xx;
    fit.xy_ = to.xy - from.xy;
    fit.yy_ = to.yy - from.yy;
    return fit;
}

}  // namespace offmap::core
