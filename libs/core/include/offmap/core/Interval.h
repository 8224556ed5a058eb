// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace offmap::core {

/// A closed, bounded, non-empty interval of the real line; min == max is one point. "No interval"
/// is a std::optional<Interval>. Used for ranges and heights, in [m].
class Interval {
 public:
    /// \throw std::invalid_argument unless min <= max (so never with NaN).
    Interval(double min, double max) : min_(min), max_(max) {
        if (!(min <= max)) refuse();
    }

    /// The interval [centre - radius, centre + radius]. \throw std::invalid_argument if radius < 0.
    static Interval around(double centre, double radius) {
        return {centre - radius, centre + radius};
    }
    /// All real numbers.
    static Interval everything();

    double min() const { return min_; }
    double max() const { return max_; }
    double centre() const { return 0.5 * (min_ + max_); }
    double width() const { return max_ - min_; }

    bool contains(double x) const { return min_ <= x && x <= max_; }
    bool contains(const Interval& o) const { return min_ <= o.min_ && o.max_ <= max_; }
    bool intersects(const Interval& o) const { return min_ <= o.max_ && o.min_ <= max_; }

    /// Both ends moved outwards by margin >= 0. \throw std::invalid_argument if nothing would be
    /// left.
    Interval expanded(double margin) const { return {min_ - margin, max_ + margin}; }

    bool operator==(const Interval&) const = default;

 private:
    [[noreturn]] void refuse() const;

    double min_, max_;
};

}  // namespace offmap::core
